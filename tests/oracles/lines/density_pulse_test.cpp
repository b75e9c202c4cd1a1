#include "oracles/lines/density_pulse.hpp"

#include "tests/catch.hpp"
#include "tests/oracles/lines/line_gate.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::line;

namespace {

struct Stream {
    double rho, v, p, gamma, rho_pulse, begin, width, L;
};

const std::vector<Stream> streams{
    {1, 1, 1, 1.4, 2, 0.25, 0.5, 1}, {0.3, -0.7, 2.1, 1.67, 0.01, 1.9, 1.3, 2.5}, {2, 340, 1e5, 1.2, 7, 0, 3, 40}};

Exact flow_of(const Stream& s) {
    return bound(density_pulse(), {{"rho", s.rho},
                                   {"v", s.v},
                                   {"p", s.p},
                                   {"gamma", s.gamma},
                                   {"rho_pulse", s.rho_pulse},
                                   {"begin", s.begin},
                                   {"width", s.width},
                                   {"L", s.L}});
}

constexpr int cells = 37;

/// In units of the time in which the stream crosses a cell.
constexpr std::array moments{0.0, 0.37, 5.2, 61.3, 1000.7};

double time_of(const Stream& s, double moment) { return moment * s.L / cells / std::abs(s.v); }

/// What is in a cell changes by what its sides let through, over a step in which at most one jump crosses a side: the
/// mean of a cell is then that of its upwind side in the past.
Defect transport(const Exact& flow, const Stream& s) {
    Defect defect;
    for (const double moment : moments) {
        const double t = time_of(s, moment);
        for (int i = 0; i < cells; ++i) {
            const double a = s.L * i / cells, b = s.L * (i + 1) / cells;
            const double later = t + time_of(s, 1);
            const double up = std::fmod(s.v > 0 ? a - s.L / cells + s.L : a + s.L / cells, s.L);
            const auto now = mean_over(flow, std::abs(up) < 1e-12 * s.L ? 0 : up, std::min(s.L, up + s.L / cells), t);
            const auto then = mean_over(flow, a, b, later);
            for (const auto& info : flow.fields) {
                const double scale = std::abs(field(flow, info.name, now)) + std::abs(field(flow, info.name, then));
                const double jump = info.name == "velocity" || info.name == "pressure" ? 0 : 1;
                defect.add(field(flow, info.name, then) - field(flow, info.name, now),
                           1e-12 * (1 + 30 * jump * moment) * scale, scale);
            }
        }
    }
    return defect;
}

/// The data: how much there is in all, between which densities, and where; velocity and pressure as given for ever.
Defect data(const Exact& flow, const Stream& s) {
    Defect defect;
    const double mass = s.rho * s.L + (s.rho_pulse - s.rho) * s.width;
    for (const double moment : moments) {
        const double t = time_of(s, moment);
        defect.add(field(flow, "density", mean_over(flow, 0, s.L, t)) * s.L - mass, 1e-13 * mass, mass);
        for (int i = 0; i < cells; ++i) {
            const auto row = row_at(flow, s.L * (i + 0.5) / cells, t);
            const double rho = field(flow, "density", row);
            defect.add(rho == s.rho || rho == s.rho_pulse ? 0 : 1, 0, 1);
            defect.add(field(flow, "velocity", row) - s.v, 0, std::abs(s.v));
            defect.add(field(flow, "pressure", row) - s.p, 0, s.p);
            const double inner = rho * field(flow, "energy", row) * (s.gamma - 1);
            defect.add(inner - s.p, 1e-14 * s.p, s.p);
            const double total = field(flow, "total_energy", row) - s.p / (s.gamma - 1) - 0.5 * rho * s.v * s.v;
            defect.add(total, 1e-13 * (s.p + rho * s.v * s.v), s.p + rho * s.v * s.v);
            defect.add(field(flow, "momentum", row) - rho * s.v, 1e-15 * rho * std::abs(s.v), rho * std::abs(s.v));
        }
    }
    defect.add(at(flow, "density", s.begin, 0) - s.rho_pulse, 0, 1);
    defect.add(at(flow, "density", std::fmod(s.begin + s.width, s.L), 0) - s.rho, 0, 1);
    return defect;
}

/// Density jumps at the jumps and nowhere else, and they are the contacts.
Defect places(const Exact& flow, const Stream& s) {
    Defect defect;
    for (const double moment : moments) {
        const double t = time_of(s, moment);
        const auto jumps = flow.jumps(t);
        const auto waves = flow.waves(t);
        defect.add(jumps.size() == 2 && waves.size() == 2 && std::is_sorted(jumps.begin(), jumps.end()) ? 0 : 1, 0, 1);
        for (std::size_t i = 0; i < std::min(jumps.size(), waves.size()); ++i) {
            defect.add(waves[i].left == jumps[i] && waves[i].kind == Wave::Kind::contact ? 0 : 1, 0, 1);
            const double beside = 1e-9 * s.L;
            const double before = at(flow, "density", jumps[i] < beside ? s.L - beside : jumps[i] - beside, t);
            defect.add(before != at(flow, "density", jumps[i] + beside, t) ? 0 : 1, 0, 1);
        }
    }
    return defect;
}

std::string ringing_of(const Exact& flow, const Stream& s) {
    return std::string(transport(flow, s).holds() ? "" : "transport; ") + (data(flow, s).holds() ? "" : "data; ") +
           (places(flow, s).holds() ? "" : "places");
}

}  // namespace

TEST_CASE("density pulse: transport, data and places hold", "[gate]") {
    for (const auto& s : streams) {
        INFO("v = " << s.v);
        CHECK(ringing_of(flow_of(s), s) == "");
    }
}

TEST_CASE("density pulse: after a period it is where it was", "[gate]") {
    for (const auto& s : streams) {
        const Exact flow = flow_of(s);
        const double period = constant(flow, "period");
        CHECK(period == Approx(s.L / std::abs(s.v)).epsilon(1e-15));
        const double apart = std::abs(constant(flow, "x_begin", 3 * period) - s.begin);
        CHECK(std::min(apart, s.L - apart) <= 4e-15 * s.L);
    }
}

TEST_CASE("density pulse: a pulse that does not fit is refused, none has no jumps", "[unit]") {
    CHECK_THAT(refusal(density_pulse(), {{"width", 1.0}}),
               ContainsSubstring("< L = 1") && ContainsSubstring("nearest"));
    CHECK_THAT(refusal(density_pulse(), {{"begin", 1.25}}), ContainsSubstring("nearest: 0.25"));
    const Exact none = bound(density_pulse(), {{"rho_pulse", 1.0}});
    CHECK((none.jumps(0.3).empty() && none.waves(0.3).empty()));
    const Exact still = bound(density_pulse(), {{"v", 0.0}});
    CHECK((std::isinf(constant(still, "period")) && still.jumps(9) == std::vector{0.25, 0.75}));
    // A pulse over the end of the domain: both its parts are seen.
    const Exact over = bound(density_pulse(), {{"begin", 0.75}});
    CHECK((at(over, "density", 0.1, 0) == 2 && at(over, "density", 0.5, 0) == 1 && at(over, "density", 0.9, 0) == 2));
    CHECK(at(over, "density", 1, 0) == at(over, "density", 0, 0));
}

TEST_CASE("alarm: density pulse: the gates ring for seeded faults", "[alarm]") {
    for (const auto& s : streams) {
        INFO("v = " << s.v);
        const auto with = [&](auto change) {
            Stream other = s;
            change(other);
            return ringing_of(flow_of(other), s);
        };
        CHECK_THAT(with([](Stream& o) { o.v *= 1 + 1e-6; }),
                   ContainsSubstring("transport") && ContainsSubstring("data"));
        CHECK_THAT(with([](Stream& o) { o.v = -o.v; }), ContainsSubstring("transport"));
        CHECK_THAT(with([](Stream& o) { o.width *= 1 + 1e-6; }), ContainsSubstring("data"));
        CHECK_THAT(with([](Stream& o) { o.gamma *= 1 + 1e-6; }), ContainsSubstring("data"));
        CHECK_THAT(with([](Stream& o) { o.rho_pulse *= 1 + 1e-6; }), ContainsSubstring("data"));
        Exact late = flow_of(s);
        late.jumps = [given = late.jumps, s](double t) { return given(t + time_of(s, 0.01)); };
        CHECK_THAT(ringing_of(late, s), ContainsSubstring("places"));
    }
}

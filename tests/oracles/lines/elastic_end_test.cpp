#include "oracles/lines/elastic_end.hpp"

#include "tests/catch.hpp"
#include "tests/oracles/fuzz.hpp"
#include "tests/oracles/lines/line_gate.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::line;

namespace {

struct Bar {
    std::string material, end;
    double lambda, v, T, V;
    double E = 2.3, rho0 = 1.7, c_v = 0.6, k = 1.3, x0 = 0.2;
    double coupling() const { return material == "linear" ? 0 : k; }
};

/// Pushed, stopped and pulled; let go while compressed, hot, and while stretched.
std::vector<Bar> bars() {
    std::vector<Bar> list;
    for (const std::string material : {"linear", "A", "B", "C"}) {
        list.push_back({material, "wall", 0.9, 0.1, 0.4, 0.6});
        list.push_back({material, "wall", 1.2, -0.5, 0.1, 0});
        list.push_back({material, "wall", 0.9, 0.1, 0.4, -0.6});
        list.push_back({material, "free", 0.6, -0.2, 0.5, 0});
        list.push_back({material, "free", 1.7, 0.3, 0.02, 0});
    }
    return list;
}

Given given(const Bar& bar) {
    return {{"material", bar.material},
            {"end", bar.end},
            {"lambda", bar.lambda},
            {"v", bar.v},
            {"T", bar.T},
            {"V", bar.V},
            {"E", bar.E},
            {"rho0", bar.rho0},
            {"c_v", bar.c_v},
            {"k", bar.k},
            {"x0", bar.x0}};
}

/// Energy per reference volume, written anew: C_s + c_v lambda^-k T.
double energy_of(const Bar& bar, double lambda, double T) {
    const double heat = bar.c_v * std::pow(lambda, -bar.coupling()) * T;
    if (bar.material == "linear") return bar.E / 2 * (lambda - 1) * (lambda - 1) + heat;
    if (bar.material == "A") return bar.E / 3 * (lambda * lambda / 2 + 1 / lambda - 1.5) + heat;
    if (bar.material == "B") return bar.E / 2 * (lambda * lambda / 2 - std::log(lambda) - 0.5) + heat;
    return bar.E * (lambda * std::log(lambda) - lambda + 1) + heat;
}

/// sigma = dC/dlambda by differences, energy = C / rho0, lambda = rho0 / rho = 1 + strain.
double law_of(const Bar& bar, const Exact& exact, double x, double t) {
    const auto row = row_at(exact, x, t);
    const double lambda = bar.rho0 / field(exact, "density", row);
    const double T = field(exact, "temperature", row);
    const auto C = [&](double l) { return energy_of(bar, l, T); };
    const double sigma = first_derivative(C, lambda, 0.02 * lambda, 1e-15 * bar.E).value;
    return std::abs(field(exact, "stress", row) - sigma) / bar.E +
           std::abs(field(exact, "energy", row) - C(lambda) / bar.rho0) * bar.rho0 / bar.E +
           std::abs(field(exact, "strain", row) - (lambda - 1));
}

Claim claim_of(const Bar& bar) {
    const Exact exact = bound(elastic_end(), given(bar));
    const double end = constant(exact, "v_end");
    std::vector<double> places{end};
    for (const double edge : wave_edges(exact, 1)) places.push_back(0.3 * places.back() + 0.7 * (edge - bar.x0));
    const double reach = std::abs(bar.v) + 6 * std::sqrt((bar.E + bar.c_v * bar.T) / bar.rho0);
    places.push_back(reach);
    return {exact, bar.x0, bar.rho0,
            reach, places, [bar](const Exact& flow, double x, double t) {
                return law_of(bar, flow, x, t); }};
}

/// A wall moves the material beside it, a free end bears no stress; ahead of the wave nothing has changed.
Defect ends(const Claim& claim, const Bar& bar) {
    Defect defect;
    const auto& exact = claim.exact;
    for (const double t : times) {
        const double place = bar.x0 + claim.places.front() * t;
        if (bar.end == "wall") defect.add(at(exact, "velocity", place, t) - bar.V, 1e-13 * claim.speed, claim.speed);
        else defect.add(at(exact, "stress", place, t), 1e-13 * bar.E, bar.E);
        defect.add(at(exact, "velocity", place, t) - claim.places.front(), 1e-13 * claim.speed, claim.speed);
        const double ahead = bar.x0 + claim.places.back() * t;
        defect.add(at(exact, "velocity", ahead, t) - bar.v, 0, claim.speed);
        defect.add(at(exact, "strain", ahead, t) - (bar.lambda - 1), 0, 1);
        defect.add(at(exact, "temperature", ahead, t) - bar.T, 0, 1);
    }
    return defect;
}

/// In a fan the temperature is that of the bar; a shock compresses and heats (Lax), but in the linear law.
Defect entropy(const Claim& claim, const Bar& bar) {
    Defect defect;
    const auto& exact = claim.exact;
    const bool compressed = constant(exact, "rho_end") > bar.rho0 / bar.lambda;
    const double T = constant(exact, "T_end");
    if (bar.material == "linear") defect.add(T - bar.T, 0, 1);
    else if (compressed) defect.add(T > bar.T && exact.jumps(1).size() == 1 ? 0 : 1, 0, 1);
    else defect.add(T == bar.T && exact.jumps(1).empty() ? 0 : 1, 0, 1);
    return defect;
}

std::string ringing_of(const Claim& claim, const Bar& bar) {
    return ringing(claim) + (ends(claim, bar).holds() ? "" : "ends; ") + (entropy(claim, bar).holds() ? "" : "entropy");
}

std::string name_of(const Bar& bar) { return bar.material + " " + bar.end + ", V = " + std::to_string(bar.V); }

}  // namespace

TEST_CASE("elastic end: balances, jumps, means, law, ends and entropy hold", "[gate]") {
    for (const auto& bar : bars()) {
        INFO(name_of(bar));
        CHECK(ringing_of(claim_of(bar), bar) == "");
    }
}

TEST_CASE("elastic end: the linear bar has d'Alembert's solution", "[gate]") {
    // v - c0 lambda and v + c0 lambda travel unchanged along X -+ c0 t; the end sends back what it gets.
    for (const auto& bar : bars()) {
        if (bar.material != "linear") continue;
        INFO(name_of(bar));
        const Exact exact = bound(elastic_end(), given(bar));
        const double c0 = std::sqrt(bar.E / bar.rho0);
        const double incoming = bar.v + c0 * bar.lambda;  // runs to the left and reaches the end
        const bool wall = bar.end == "wall";
        const double v = wall ? bar.V : incoming - c0;
        const double lambda = wall ? (incoming - bar.V) / c0 : 1;
        CHECK(constant(exact, "v_end") == Approx(v).epsilon(1e-14));
        CHECK(constant(exact, "rho_end") == Approx(bar.rho0 / lambda).epsilon(1e-14));
        REQUIRE(exact.jumps(2).size() == 1);
        // The front is the particle X = c0 t, which is still where the undisturbed bar has it.
        CHECK(exact.jumps(2).front() == Approx(bar.x0 + 2 * (bar.v + bar.lambda * c0)).epsilon(1e-14));
    }
}

TEST_CASE("elastic end: random bars keep their balances", "[property]") {
    Random random(83);
    Tally tally;
    const std::vector<std::string> materials{"linear", "A", "B", "C"};
    for (int i = 0; i < fuzz_rounds(300); ++i) {
        Bar bar{materials[static_cast<std::size_t>(random.whole(0, 3))],
                random.coin() ? "wall" : "free",
                random.uniform(0.4, 2),
                random.uniform(-0.5, 0.5),
                random.uniform(0, 1),
                0};
        bar.E = random.log_uniform(0.1, 10);
        bar.rho0 = random.log_uniform(0.1, 10);
        bar.k = random.uniform(0, 3);
        if (bar.end == "wall") bar.V = random.uniform(-0.6, 0.6);
        if (!refusal(elastic_end(), given(bar)).empty()) {
            ++tally.refused;
            continue;
        }
        const Claim claim = claim_of(bar);
        INFO(name_of(bar) << ", lambda = " << bar.lambda << ", v = " << bar.v << ", round " << i);
        REQUIRE(ringing(claim, {{"balance", balance}, {"jumps", jump_conditions}}) == "");
        REQUIRE(ends(claim, bar).holds());
        ++tally.checked;
    }
    CHECK(tally.checked > 0.9 * fuzz_rounds(300));
}

TEST_CASE("elastic end: what has no solution is refused", "[unit]") {
    CHECK_THAT(refusal(elastic_end(), {{"end", "free"}, {"V", 0.3}}), ContainsSubstring("nearest: V = 0"));
    CHECK_THAT(refusal(elastic_end(), {{"material", "linear"}, {"V", 1.5}}),
               ContainsSubstring("crushes the bar") && ContainsSubstring("nearest: V = 0.5"));
    CHECK(refusal(elastic_end(), {{"material", "linear"}, {"V", 0.99}}).empty());
    const Exact exact = bound(elastic_end(), {{"V", 0.5}, {"x0", 1.0}});
    CHECK_NOTHROW(row_at(exact, 1.5 * (1 - 1e-15), 1));
    CHECK_THROWS_WITH(row_at(exact, 1.4, 1),
                      ContainsSubstring("beyond the end") && ContainsSubstring("nearest: x = 1.5"));
    CHECK(exact.jumps(0).empty());
    const Exact still = bound(elastic_end(), {{"V", 0.0}});
    CHECK((still.waves(1).empty() && still.jumps(1).empty()));
}

TEST_CASE("alarm: elastic end: the gates ring for seeded faults", "[alarm]") {
    for (const auto& bar : bars()) {
        INFO(name_of(bar));
        const Claim good = claim_of(bar);
        const auto flow_of = [&](const Bar& other) {
            Claim claim = good;
            claim.exact = bound(elastic_end(), given(other));
            return claim;
        };
        if (bar.end == "wall") {  // a free end would be elsewhere, and points beyond it are refused
            Bar other = bar;
            other.E *= 1 + 1e-6;
            CHECK_THAT(ringing_of(flow_of(other), bar), ContainsSubstring("law"));
            other = bar;
            other.T += 1e-6;
            CHECK_THAT(ringing_of(flow_of(other), bar), ContainsSubstring("ends"));
            other = bar;
            other.V -= 1e-6;
            CHECK_THAT(ringing_of(flow_of(other), bar), ContainsSubstring("ends"));
        }
        const double rho = bar.rho0 / bar.lambda;
        const auto disturbed = [&](std::size_t field, double fault = 1e-6) {
            return changed(good, [=](auto row, double, double) {
                if (row[1] != rho) row[field] *= 1 + fault;
            });
        };
        CHECK_THAT(ringing_of(disturbed(1), bar), ContainsSubstring("balance") && ContainsSubstring("law"));
        CHECK_THAT(ringing_of(disturbed(5, 1e-4), bar), ContainsSubstring("law"));
        CHECK_THAT(ringing_of(disturbed(7), bar), ContainsSubstring("balance"));
        if (bar.end == "wall") CHECK_THAT(ringing_of(disturbed(2), bar), ContainsSubstring("balance"));
        const auto warm = changed(good, [=](auto row, double, double) { row[4] *= row[1] == rho ? 1 : 1.01; });
        if (bar.T > 0) CHECK_THAT(ringing_of(warm, bar), ContainsSubstring("law"));
    }
}

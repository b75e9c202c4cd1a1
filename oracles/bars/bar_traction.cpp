#include "oracles/bars/bar_traction.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <limits>

#include "core/elastic_constants.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/bars/end_load.hpp"

namespace ordo::oracles {
namespace {

constexpr double pi = boost::math::constants::pi<double>();
const std::string where = "oracle bar_traction";

bars::StepLoad step_at(const BarTraction& bar, double t) { return {bar.L, bar.wave_speed(), bar.tau / bar.E, t}; }
bars::SineLoad sine_at(const BarTraction& bar, double t) {
    return {bar.L, bar.wave_speed(), bar.tau / bar.E, bar.omega, t};
}

BarTraction bar_from(const Values& values) {
    const BarTraction bar{
        .L = values.number("L"),
        .E = youngs_modulus(values, 100, "oracle bar_traction"),
        .rho = values.number("rho"),
        .tau = values.number("tau"),
        .omega = values.number("omega"),
        .profile = values.word("profile") == "sine" ? BarTraction::Profile::sine : BarTraction::Profile::step};
    bars::require_waves(bar.L, bar.E, bar.rho, where);
    const double strain = bar.tau / bar.E;
    for (const double scale : {strain, strain * bar.L, strain * bar.wave_speed()})
        bars::require_finite(4e12 * scale, "tau / E = " + shortest(strain), where);  // resonance grows with t
    if (bar.profile == BarTraction::Profile::step) return bar;
    const double waves = bar.omega * bar.L / bar.wave_speed();
    if (!(waves >= 1e-12 && waves <= 1e12))
        throw InputError(where, "omega = " + shortest(bar.omega) + ": omega L / c must be in [1e-12, 1e12], but is " +
                                    shortest(waves) +
                                    "; take omega near c / L = " + shortest(bar.wave_speed() / bar.L));
    return bar;
}

Constants constants_of(const BarTraction& bar, std::optional<double> t) {
    const bool sine = bar.profile == BarTraction::Profile::sine;
    const double mode = bar.resonant_mode();
    Constants list{{"wave_speed", bar.wave_speed()},
                   {"first_eigenfrequency", bar.eigenfrequency(1)},
                   {"period", 4 * bar.L / bar.wave_speed()}};
    if (sine) list.push_back({"resonance", std::string(mode > 0 ? "yes" : "no")});
    if (mode > 0) list.push_back({"resonant_mode", mode});
    if (t) list.push_back({"front", bar.front(*t)});
    return list;
}

Exact bind(const Values& values) {
    const BarTraction bar = bar_from(values);
    const bool sine = bar.profile == BarTraction::Profile::sine;
    const double slowest = bar.L / bar.wave_speed();
    Exact exact{.dim = 1,
                .coordinates = Coordinates::material,
                .lower = {0},
                .upper = {bar.L},
                .times = between(0, bars::most_radians * (sine ? std::min(slowest, 1 / bar.omega) : slowest)),
                .fields = standard_fields(),
                .sample = {},
                .jumps = no_jumps,
                .features =
                    [bar, sine](const std::string& field, double t) {
                        return std::vector{bars::front_feature(field, bar.front(t), sine ? 2 : 1)};
                    },
                .constants = [bar](std::optional<double> t) { return constants_of(bar, t); }};
    if (sine) {
        exact.sample = bars::points_of([bar](double t) { return sine_at(bar, t); }, bar.E);
        exact.averages = bars::cells_of([bar](double t) { return sine_at(bar, t); }, bar.E);
        return exact;
    }
    exact.sample = bars::points_of([bar](double t) { return step_at(bar, t); }, bar.E);
    exact.averages = bars::cells_of([bar](double t) { return step_at(bar, t); }, bar.E);
    exact.jumps = [bar](double t) { return t > 0 ? std::vector{bar.front(t)} : std::vector<double>{}; };
    return exact;
}

constexpr const char* explanation =
    "rho u_tt = E u_XX on 0 <= X <= L;  u(0, t) = 0,  E u_X(L, t) = load(t),  at rest at t = 0\n"
    "load = tau sin(omega t) (profile sine) or tau for t > 0 (profile step); nominal, tension positive\n"
    "u = sum_{m >= 0} (-1)^m [ I(t - ((2m+1) L - X)/c) - I(t - ((2m+1) L + X)/c) ]\n"
    "I(s) = (c/E) int_0^s load, 0 for s < 0;  c = sqrt(E / rho);  the sum is finite and taken in closed form\n"
    "x is the position in the undeformed bar; exact at any strain where the nominal stress is E (F - 1)\n"
    "omega may be an eigenfrequency omega_n = (2n - 1) pi c / (2L): the amplitude then grows linearly with t\n"
    "refused: omega L / c outside [1e-12, 1e12]; t beyond 1e12 radians of load or 1e12 transits, where phases are "
    "lost\n"
    "constants: wave_speed, first_eigenfrequency, period (4 L / c, of the bar), resonance (yes or no), resonant_mode,\n"
    "with --t front (position of the front)";

}  // namespace

double BarTraction::wave_speed() const { return std::sqrt(E / rho); }
double BarTraction::eigenfrequency(int n) const { return (n - 0.5) * pi * wave_speed() / L; }

double BarTraction::resonant_mode() const {
    if (profile == Profile::step) return 0;
    const double half_waves = omega * L / (wave_speed() * pi);
    const double n = std::round(half_waves + 0.5);
    const double ulps = 4 * std::numeric_limits<double>::epsilon();
    return n >= 1 && n < 1e14 && std::abs(half_waves - (n - 0.5)) <= ulps * half_waves ? n : 0;
}

double BarTraction::front(double t) const { return step_at(*this, t).front(); }

bars::Fields BarTraction::at(double X, double t) const {
    return profile == Profile::sine ? sine_at(*this, t).at(X) : step_at(*this, t).at(X);
}
bars::Fields BarTraction::mean(double a, double b, double t) const {
    return profile == Profile::sine ? sine_at(*this, t).mean(a, b) : step_at(*this, t).mean(a, b);
}
double BarTraction::displacement(double X, double t) const { return at(X, t).displacement; }
double BarTraction::velocity(double X, double t) const { return at(X, t).velocity; }
double BarTraction::strain(double X, double t) const { return at(X, t).strain; }
double BarTraction::stress(double X, double t) const { return E * strain(X, t); }

Oracle bar_traction() {
    return {.name = "bar_traction",
            .about = "Elastic bar, fixed at one end, under a sine or a step of traction at the other",
            .source = {"Steffen2008", "MPMtry"},
            .explanation = explanation,
            .example = "bar_traction --set profile=step --t 1.5 --grid 0:1:101",
            .parameters = with_youngs_modulus(
                {number("L", "m", 1, positive, "length"), number("rho", "kg/m", 100, positive, "density"),
                 number("tau", "Pa", 1, finite, "traction at X = L: amplitude of the sine, height of the step"),
                 number("omega", "1/s", 3.141592653589793, positive,
                        "angular frequency of the sine, by default pi c / L of the default bar; the step has none"),
                 word("profile", "sine", {{"sine", "load tau sin(omega t)"}, {"step", "load tau, suddenly at t = 0"}},
                      "the load in time")},
                100),
            .fields = standard_fields(),
            .smoothness =
                "sine: displacement, velocity, stress continuous, the last two with a kink at the front; "
                "step: displacement with a kink, velocity and stress jump at the front",
            .accuracy = "1e-14 (1 + omega t), for the step 1e-14 (1 + c t / L), of the field's largest value until t",
            .bind = bind};
}

}  // namespace ordo::oracles

#include "oracles/bars/bar_vibration.hpp"

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/sinc.hpp>
#include <cmath>

#include "core/elastic_constants.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::oracles {
namespace {

constexpr double pi = boost::math::constants::pi<double>();
constexpr double most_radians = 1e12;  // a later phase has less than four digits left

void require_numbers(const BarVibration& bar) {
    const double omega = bar.frequency();
    const bool ordinary = std::isnormal(omega) && std::isnormal(1 / omega) && std::isfinite(bar.v0 / omega) &&
                          std::isfinite(bar.E * (bar.v0 / omega * bar.wave_number()));
    if (ordinary) return;
    throw InputError("oracle bar_vibration", "L = " + shortest(bar.L) + ", E = " + shortest(bar.E) +
                                                 ", rho = " + shortest(bar.rho) + ", v0 = " + shortest(bar.v0) +
                                                 ": the frequency or an amplitude is out of the range of numbers");
}

BarVibration::Ends ends_of(const std::string& word) {
    using Ends = BarVibration::Ends;
    return word == "fixed_free" ? Ends::fixed_free : word == "fixed_fixed" ? Ends::fixed_fixed : Ends::periodic;
}

Exact bind(const Values& values) {
    const BarVibration bar{.L = values.number("L"),
                           .E = youngs_modulus(values, 100, "oracle bar_vibration"),
                           .rho = values.number("rho"),
                           .v0 = values.number("v0"),
                           .mode = values.whole("mode"),
                           .ends = ends_of(values.word("ends"))};
    require_numbers(bar);
    const auto row = [bar](double X, double t) {
        return std::array{bar.displacement(X, t), bar.velocity(X, t), bar.stress(X, t), bar.strain(X, t)};
    };
    return {.dim = 1,
            .coordinates = Coordinates::material,
            .lower = {0},
            .upper = {bar.L},
            .times = between(0, most_radians / bar.frequency()),
            .fields = standard_fields(),
            .sample = along_a_line(row),
            .averages = over_cells([bar, row](double a, double b, double t) {
                auto means = row((a + b) / 2, t);
                for (double& mean : means) mean *= bar.cell_factor(a, b);
                return means;
            }),
            .jumps = no_jumps,
            .features = no_features,
            .constants = [bar](std::optional<double>) -> Constants {
                return {{"wave_number", bar.wave_number()}, {"frequency", bar.frequency()}};
            }};
}

}  // namespace

double BarVibration::wave_number() const {
    return ends == Ends::fixed_free ? (2 * mode - 1) * pi / (2 * L) : (ends == Ends::periodic ? 2 : 1) * mode * pi / L;
}
double BarVibration::frequency() const { return wave_number() * std::sqrt(E / rho); }

double BarVibration::displacement(double X, double t) const {
    return v0 / frequency() * std::sin(frequency() * t) * std::sin(wave_number() * X);
}
double BarVibration::velocity(double X, double t) const {
    return v0 * std::cos(frequency() * t) * std::sin(wave_number() * X);
}
double BarVibration::strain(double X, double t) const {
    return v0 / frequency() * std::sin(frequency() * t) * wave_number() * std::cos(wave_number() * X);
}
double BarVibration::stress(double X, double t) const { return E * strain(X, t); }
double BarVibration::cell_factor(double a, double b) const {
    return boost::math::sinc_pi(wave_number() * ((b - a) / 2));
}

Oracle bar_vibration() {
    return {.name = "bar_vibration",
            .about = "One mode of an elastic bar, fixed at one end or at both, or periodic",
            .source = {"WobbesTielen2015"},
            .explanation =
                "rho u_tt = E u_XX;  u(X, 0) = 0,  u_t(X, 0) = v0 sin(k X)\n"
                "u = (v0 / omega) sin(omega t) sin(k X),  omega = k sqrt(E / rho)\n"
                "fixed_free: k = (2 mode - 1) pi / (2 L);  fixed_fixed: k = mode pi / L;  periodic: k = 2 mode pi / L\n"
                "x is the position in the undeformed bar; exact at any strain where the nominal stress is E (F - 1)\n"
                "a cell's mean is the value at its middle times sin(z) / z, z = k (b - a) / 2\n"
                "refused: t beyond 1e12 / omega, where the phase is lost\n"
                "constants: wave_number (k), frequency (omega, in 1/s)",
            .example = "bar_vibration --t 0.5 --grid 0:25:101",
            .parameters = with_youngs_modulus(
                {number("L", "m", 25, positive, "length"), number("rho", "kg/m", 1, positive, "density"),
                 number("v0", "m/s", 0.1, finite, "amplitude of the velocity at t = 0"),
                 whole("mode", 1, between(1, 1000), "which mode, counted from 1"),
                 word("ends", "fixed_free",
                      {{"fixed_free", "u = 0 at X = 0, no traction at X = L"},
                       {"fixed_fixed", "u = 0 at both ends"},
                       {"periodic", "the bar goes on at X = L as it began at X = 0"}},
                      "how the ends are held")},
                100),
            .fields = standard_fields(),
            .smoothness = "analytic in x and t",
            .accuracy = "2 ulp times (1 + k X + omega t), relative to the field's amplitude",
            .bind = bind};
}

}  // namespace ordo::oracles

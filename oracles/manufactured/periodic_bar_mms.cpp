#include "oracles/manufactured/periodic_bar_mms.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/manufactured/half_turns.hpp"
#include "oracles/manufactured/neo_hookean.hpp"

namespace ordo::oracles {
namespace {

constexpr double pi = boost::math::constants::pi<double>();
constexpr const char* where = "oracle periodic_bar_mms";

/// The law of this bar: no Poisson's effect, whatever solid E was taken from.
ElasticConstants elastic_of(const PeriodicBarMms& bar) {
    return elastic_constants({Elastic::E, bar.E}, {Elastic::nu, 0}, where);
}

Exact bind(const Values& values) {
    const PeriodicBarMms bar{.L = values.number("L"),
                             .A = values.number("A"),
                             .rho = values.number("rho"),
                             .E = youngs_modulus(values, PeriodicBarMms{}.E, where)};
    require_representable(elastic_of(bar), bar.rho, bar.c() / bar.L, where);
    if (!(2 * pi * std::abs(bar.A) < bar.L))
        throw InputError(where, "A = " + shortest(bar.A) +
                                    " m turns the bar inside out (det F <= 0); must be below L/(2 pi) = " +
                                    shortest(bar.L / (2 * pi)) + " in size");
    return {
        .dim = 1,
        .coordinates = Coordinates::material,
        .lower = {0},
        .upper = {bar.L},
        .times = times_up_to(bar.omega()),
        .fields = manufactured_fields(),
        .sample = material_points<1>(bar),
        .jumps = no_jumps,
        .features = no_features,
        .constants = [bar](std::optional<double>) { return motion_constants(elastic_of(bar), bar.c(), bar.omega()); }};
}

std::vector<Parameter> parameters() {
    return with_youngs_modulus(
        {number("L", "m", 1, positive, "length and period"), number("rho", "kg/m", 1, positive, "density"),
         number("A", "m", 0.001, finite, "amplitude of the displacement, below L/(2 pi) in size")},
        1e6);
}

}  // namespace

double PeriodicBarMms::c() const { return std::sqrt(E / rho); }
double PeriodicBarMms::omega() const { return pi * c() / L; }

MaterialPoint<1> PeriodicBarMms::at(const std::array<double, 1>& X, double t) const {
    const double in_space = sin_pi(2 * (X[0] / L));
    const double in_time = std::cos(omega() * t);
    const double u = A * in_space * in_time;
    const double H = 2 * pi * (A / L) * cos_pi(2 * (X[0] / L)) * in_time;
    const double F = 1 + H;
    const double P = E / 2 * H * (2 + H) / F;
    return {.u = {u},
            .v = {-A * omega() * in_space * std::sin(omega() * t)},
            .stress = {P},
            .strain = {H},
            .b = {omega() * omega() * u * (1 + 2 / (F * F))},
            .F = {F},
            .P = {P}};
}

Oracle periodic_bar_mms() {
    return {
        .name = "periodic_bar_mms",
        .about = "Manufactured standing wave of a periodic neo-Hookean bar, at any amplitude",
        .source = {"Steffen2008b"},
        .explanation =
            "u = A sin(2 pi X / L) cos(omega t),  omega = pi c / L,  c = sqrt(E / rho)\n"
            "F = 1 + (2 pi A / L) cos(2 pi X / L) cos(omega t)\n"
            "stress = nominal_stress = (E/2)(F - 1/F),  body_force = omega^2 u (1 + 2/F^2)\n" +
            manufactured_law() +
            "\nHere lambda = 0 and mu = E/2, whichever two constants E was taken from. At t = 0 the bar is deformed\n"
            "and at rest: start positions, F and stress from these fields. Both ends are held too: u = 0.\n"
            "Refused: 2 pi |A| >= L, where det F reaches 0; omega t > 1e12, where the phase is lost.\n"
            "Constants: E nu K G lambda M c omega",
        .example = "periodic_bar_mms --set A=0.05 --t 0.0003 --grid 0:1:101",
        .parameters = parameters(),
        .fields = manufactured_fields(),
        .smoothness = "analytic in x and t",
        .accuracy = "1e-15 (4 + omega t) of each field's amplitude; over 10 (1 - 2 pi |A| / L) where that is below 1",
        .bind = bind};
}

}  // namespace ordo::oracles

#include "oracles/manufactured/bar_mms.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/manufactured/half_turns.hpp"

namespace ordo::oracles {
namespace {

constexpr double pi = boost::math::constants::pi<double>();
constexpr const char* where = "oracle bar_mms";

Exact::Sample points_of(const BarMms& bar) {
    return [bar](std::span<const double> X, double t, std::span<double> values) {
        const BarMms::Moment now = bar.at(t);
        const std::size_t width = values.size() / std::max<std::size_t>(X.size(), 1);
        for (std::size_t i = 0; i < X.size(); ++i) write(now.at(X[i]), values.subspan(i * width, width));
    };
}

Exact bind(const Values& values) {
    const BarMms bar{.L = values.number("L"),
                     .A = values.number("A"),
                     .rho = values.number("rho"),
                     .elastic = elastic_constants(values, BarMms{}.elastic, where)};
    require_representable(bar.elastic, bar.rho, std::sqrt(bar.elastic.M / bar.rho) / bar.L, where);
    if (!(pi * std::abs(bar.A) < bar.L))
        throw InputError(where, "A = " + shortest(bar.A) +
                                    " m turns the bar inside out (det F <= 0); must be below L/pi = " +
                                    shortest(bar.L / pi) + " in size");
    return {.dim = 1,
            .coordinates = Coordinates::material,
            .lower = {0},
            .upper = {bar.L},
            .times = times_up_to(bar.omega()),
            .fields = manufactured_fields(),
            .sample = points_of(bar),
            .jumps = no_jumps,
            .features = no_features,
            .constants = [bar](std::optional<double>) { return motion_constants(bar.elastic, bar.c(), bar.omega()); }};
}

std::vector<Parameter> parameters() {
    return appended(elastic_parameters("E 1e7, nu 0"),
                    {number("L", "m", 1, positive, "length"), number("rho", "kg/m", 1000, positive, "density"),
                     number("A", "m", 1e-4, finite, "amplitude of the displacement, below L/pi in size; papers' G")});
}

}  // namespace

double BarMms::c() const { return std::sqrt(elastic.E / rho); }
double BarMms::omega() const { return pi * c() / L; }

BarMms::Moment BarMms::at(double t) const {
    const double in_time = std::sin(omega() * t);
    return {.L = L,
            .rho = rho,
            .u = A * in_time,
            .v = A * omega() * std::cos(omega() * t),
            .H = pi * (A / L) * in_time,
            .wave_excess = wave_excess(elastic),
            .law = NeoHookean(elastic)};
}

MaterialPoint<1> BarMms::at(const std::array<double, 1>& X, double t) const { return at(t).at(X[0]); }

MaterialPoint<1> BarMms::Moment::at(double X) const {
    const double in_space = sin_pi(X / L);
    const double here = u * in_space;
    const double strain = H * cos_pi(X / L);
    const double ln_F = law.lambda == 0 ? 0 : std::log1p(strain);
    const double P = law.kirchhoff(strain, ln_F) / (1 + strain);
    const double b = (pi / L) * (pi / L) * here * ((wave_excess + law.hardening(strain, ln_F)) / rho);
    return {.u = {here}, .v = {v * in_space}, .stress = {P}, .strain = {strain}, .b = {b}, .F = {1 + strain}, .P = {P}};
}

Oracle bar_mms() {
    return {
        .name = "bar_mms",
        .about = "Manufactured motion of a neo-Hookean bar with both ends held, at any amplitude",
        .source = {"Nguyen2023", "Tran2020"},
        .explanation =
            "u = A sin(pi X / L) sin(omega t),  omega = pi c / L,  c = sqrt(E / rho)\n"
            "F = 1 + (pi A / L) cos(pi X / L) sin(omega t)\n"
            "stress = nominal_stress = lambda ln F / F + mu (F - 1/F)\n"
            "body_force = (pi^2 u / (rho L^2)) (lambda (1 - ln F) / F^2 + mu (1 + 1/F^2) - E)\n" +
            manufactured_law() +
            "\nA is the amplitude that papers call G; G is the shear modulus here. Elasticity: any two of E, nu, K,\n"
            "G, lambda, M. Refused: pi |A| >= L, where det F reaches 0; omega t > 1e12, where the phase is lost.\n"
            "Constants: E nu K G lambda M c omega",
        .example = "bar_mms --set A=0.05 --t 0.005 --grid 0:1:101",
        .parameters = parameters(),
        .fields = manufactured_fields(),
        .smoothness = "analytic in x and t",
        .accuracy = "1e-15 (4 + omega t) of each field's amplitude; over 10 (1 - pi |A| / L) where that is below 1",
        .bind = bind};
}

}  // namespace ordo::oracles

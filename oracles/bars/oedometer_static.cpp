#include "oracles/bars/oedometer_static.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/lambert_w.hpp>
#include <cmath>
#include <limits>

#include "core/elastic_constants.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/bars/bar.hpp"

namespace ordo::oracles {
namespace {

using Law = OedometerStatic::Law;
const std::string where = "oracle oedometer_static";
constexpr double exp_minus_one = 0.36787944117144233;  // the largest P / E of the Kirchhoff law, at theta = 1
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// One law: its name, which stresses it can bear, in words and in p = P / E.
struct Bearing {
    const char* name;
    const char* rule;
    double low, high;  ///< of p; infinite where there is none
    bool high_included;
};
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::array laws{Bearing{"E(F-1)", "P > -E", -1, infinite, false},
                          Bearing{"E(1-1/F)", "P < E", -infinite, 1, false},
                          Bearing{"E ln F", "any P", -infinite, infinite, false},
                          Bearing{"E ln F / F", "P <= E / e = 0.36787944117144233 E", -infinite, exp_minus_one, true},
                          Bearing{"E(F-1/F)/2", "any P", -infinite, infinite, false}};

const Bearing& range_of(Law law) { return laws[static_cast<std::size_t>(law)]; }

bool bears(Law law, double p) {
    const auto& [name, rule, low, high, included] = range_of(law);
    return p > low && (included ? p <= high : p < high);
}

double log_stretch_of(Law law, double p) {
    if (!bears(law, p)) return nan;
    switch (law) {
        case Law::nominal: return std::log1p(p);
        case Law::reciprocal: return -std::log1p(-p);
        case Law::logarithmic: return p;
        case Law::kirchhoff: return p == exp_minus_one ? 1 : -boost::math::lambert_w0(-p);
        case Law::neo_hookean: break;
    }
    return std::asinh(p);
}

double slope_of(Law law, double theta) {  ///< dp / dtheta
    switch (law) {
        case Law::nominal: return std::exp(theta);
        case Law::reciprocal: return std::exp(-theta);
        case Law::logarithmic: return 1;
        case Law::kirchhoff: return (1 - theta) * std::exp(-theta);
        case Law::neo_hookean: break;
    }
    return std::cosh(theta);
}

/// The mean of exp(theta) - 1 with weight dp/dtheta over the stresses between two log stretches, by Gauss-Legendre.
template <class Rule>
double mean_strain(Law law, double from, double to, double panels) {
    const double half = (to - from) / (2 * panels);
    double sum = 0, weights = 0;
    const auto add = [&](double weight, double theta) {
        weight *= slope_of(law, theta);
        weights += weight;
        sum += weight * std::expm1(theta);
    };
    for (double panel = 0; panel < panels; ++panel) {
        const double middle = from + (2 * panel + 1) * half;
        add(Rule::weights()[0], middle);
        for (std::size_t i = 1; i < Rule::weights().size(); ++i) {
            add(Rule::weights()[i], middle - half * Rule::abscissa()[i]);
            add(Rule::weights()[i], middle + half * Rule::abscissa()[i]);
        }
    }
    return sum / weights;
}

/// The integrand grows like exp(2 theta) at most: 7 points over a span of 1/2 and 15 over one of 4 leave below 1e-18.
double mean_strain(Law law, double from, double to) {
    using boost::math::quadrature::gauss;
    if (from == to) return std::expm1(from);
    const double span = std::abs(to - from);
    if (span <= 0.5) return mean_strain<gauss<double, 7>>(law, from, to, 1);
    return mean_strain<gauss<double, 15>>(law, from, to, std::ceil(span / 4));
}

/// The base bears the least stress and the top the most: what both can bear every point between can.
void require_stretch(const OedometerStatic& column) {
    const double load = std::abs(column.p0) + column.rho * column.g * column.H;
    bars::require_finite(load, "|p0| + rho g H", where);
    bars::require_finite(load / column.E, "(|p0| + rho g H) / E", where);
    for (const double X : {0.0, column.H}) {
        const double P = column.stress(X);
        const std::string place = X == 0 ? "at the base" : "at the top";
        const auto& [name, rule, low, high, included] = range_of(column.law);
        if (!bears(column.law, P / column.E))
            throw InputError(where, "P = " + shortest(P) + " Pa " + place + ": the law " + name +
                                        " has a stretch for " + rule + " only, E = " + shortest(column.E) +
                                        "; take a " + (X == 0 ? "lighter or stiffer column" : "smaller p0"));
        if (!(std::abs(column.log_stretch(X)) <= 300))
            throw InputError(where, "P / E = " + shortest(P / column.E) + " " + place +
                                        ": ln F must be in [-300, 300], the range of numbers; take a larger E");
    }
    if (std::isfinite(column.displacement(column.H))) return;
    throw InputError(where, "the displacement is out of the range of numbers; take a smaller H");
}

std::vector<FieldInfo> static_fields() { return {{"displacement", "m", 1}, {"strain", "-", 2}, {"stress", "Pa", 2}}; }

Exact bind(const Values& values) {
    const auto named =
        std::find_if(laws.begin(), laws.end(), [&](const Bearing& law) { return law.name == values.word("law"); });
    const OedometerStatic column{.H = values.number("H"),
                                 .E = youngs_modulus(values, 1e6, "oracle oedometer_static"),
                                 .rho = values.number("rho"),
                                 .g = values.number("g"),
                                 .p0 = values.number("p0"),
                                 .law = static_cast<Law>(named - laws.begin())};
    require_stretch(column);
    return {.dim = 1,
            .coordinates = Coordinates::material,
            .lower = {0},
            .upper = {column.H},
            .fields = static_fields(),
            .sample = along_a_line([column, base = column.log_stretch(0)](double X, double) {
                const double theta = column.log_stretch(X);
                return std::array{X * mean_strain(column.law, base, theta), std::expm1(theta), column.stress(X)};
            }),
            .jumps = no_jumps,
            .features = no_features,
            .constants = [column](std::optional<double>) -> Constants {
                return {{"top_displacement", column.displacement(column.H)},
                        {"base_stress", column.stress(0)},
                        {"base_strain", column.strain(0)},
                        {"top_strain", column.strain(column.H)}};
            }};
}

constexpr const char* explanation =
    "dP/dX = rho g,  P(H) = p0,  u(0) = 0:  P = p0 - rho g (H - X),  u(X) = int_0^X (F - 1);  independent of t\n"
    "P is the nominal stress and the Cauchy stress: the cross-section keeps its area; tension is positive\n"
    "strain is du/dX = F - 1; x is the position in the undeformed column; gravity acts towards -X\n"
    "law, F of p = P / E:\n"
    "  E(F-1)      1 + p                P > -E     linear column, exact at any strain\n"
    "  E(1-1/F)    1 / (1 - p)          P < E      increment (E - sigma) d eps of an updated mesh\n"
    "  E ln F      exp(p)               any P      increment E d eps of the true strain\n"
    "  E ln F / F  exp(-W0(-p))         P <= E/e   Hencky: Kirchhoff stress E ln F; W0 is Lambert's function\n"
    "  E(F-1/F)/2  p + sqrt(p^2 + 1)    any P      neo-Hookean, nu = 0\n"
    "refused: stresses for which the law has no F (at the base or at the top), |ln F| > 300\n"
    "constants: top_displacement, base_stress, base_strain, top_strain";

}  // namespace

double OedometerStatic::stress(double X) const { return p0 - rho * g * (H - X); }
double OedometerStatic::log_stretch(double X) const { return log_stretch_of(law, stress(X) / E); }
double OedometerStatic::strain(double X) const { return std::expm1(log_stretch(X)); }
double OedometerStatic::displacement(double X) const { return X * mean_strain(law, log_stretch(0), log_stretch(X)); }

Oracle oedometer_static() {
    return {.name = "oedometer_static",
            .about = "Column at rest under gravity and a load on its top, at any strain, for five laws",
            .source = {"MPMtry", "CoombsAugarde2020", "Corless1996"},
            .explanation = explanation,
            .example = "oedometer_static --t 0 --grid 0:50:101",
            .parameters =
                with_youngs_modulus({number("H", "m", 50, positive, "height before the load"),
                                     number("rho", "kg/m", 80, positive, "density before the load"),
                                     number("g", "m/s^2", 10, at_least(0), "gravity, towards -X"),
                                     number("p0", "Pa", 0, finite, "nominal traction on the top, tension positive"),
                                     word("law", "E ln F / F",
                                          {{"E(F-1)", "P = E (F - 1)"},
                                           {"E(1-1/F)", "P = E (1 - 1/F)"},
                                           {"E ln F", "P = E ln F"},
                                           {"E ln F / F", "P = E ln F / F: Hencky, Kirchhoff stress E ln F"},
                                           {"E(F-1/F)/2", "P = (E/2) (F - 1/F): neo-Hookean"}},
                                          "nominal stress of the stretch")},
                                    1e6),
            .fields = static_fields(),
            .smoothness = "analytic in x, constant in t",
            .accuracy = "1e-14 of the field's largest value, for loads changed by 1e-15 of |p0| + rho g H at most",
            .bind = bind};
}

}  // namespace ordo::oracles

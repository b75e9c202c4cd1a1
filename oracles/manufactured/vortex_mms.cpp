#include "oracles/manufactured/vortex_mms.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "oracles/manufactured/annulus.hpp"

namespace ordo::oracles {
namespace {

constexpr double pi = boost::math::constants::pi<double>();
constexpr const char* where = "oracle vortex_mms";

using Vector = std::array<double, 2>;

/// h, h' and h'' at R [1, 1/m, 1/m^2].
struct Profile {
    double h, slope, curvature;
};

Profile profile(const VortexMms& vortex, double R) {
    const double width = vortex.r_o - vortex.r_i;
    const double in = (R - vortex.r_i) / width, out = (vortex.r_o - R) / width;
    return {.h = 16 * in * in * out * out,
            .slope = 32 * in * out * (out - in) / width,
            .curvature = 32 * ((out - in) * (out - in) - 2 * in * out) / (width * width)};
}

Exact bind(const Values& values) {
    VortexMms vortex{.r_i = values.number("r_i"),
                     .r_o = values.number("r_o"),
                     .A = values.number("A"),
                     .rho = values.number("rho"),
                     .elastic = elastic_constants(values, VortexMms{}.elastic, where)};
    if (values.has("omega")) vortex.pulse = values.number("omega");
    require_ring(vortex.r_i, vortex.r_o, where);
    const double slowest = vortex.c() / (vortex.r_o - vortex.r_i);
    require_representable(vortex.elastic, vortex.rho, std::max(vortex.omega(), slowest), where);
    return {.dim = 2,
            .coordinates = Coordinates::material,
            .lower = {-vortex.r_o, -vortex.r_o},
            .upper = {vortex.r_o, vortex.r_o},
            .times = times_up_to(vortex.omega()),
            .fields = manufactured_fields(),
            .sample = material_points<2>(vortex),
            .jumps = no_jumps,
            .features = no_features,
            .constants = [vortex](std::optional<double>) {
                return motion_constants(vortex.elastic, vortex.c(), vortex.omega());
            }};
}

std::vector<Parameter> parameters() {
    return appended(
        elastic_parameters("E 1000, nu 0.3"),
        {number("r_i", "m", 0.75, positive, "inner radius"), number("r_o", "m", 1.25, positive, "outer radius"),
         number("rho", "kg/m^2", 1000, positive, "density"),
         number("A", "rad", 1, between(-1000, 1000), "amplitude of the turn half-way between the rims"),
         without_default(number("omega", "1/s", 0, positive, "absent: 2 pi c / (r_i + r_o)"))});
}

/// a b^T, row by row.
std::array<double, 4> dyad(double factor, const Vector& a, const Vector& b) {
    return {factor * a[0] * b[0], factor * a[0] * b[1], factor * a[1] * b[0], factor * a[1] * b[1]};
}

std::array<double, 4> sum(const std::array<double, 4>& a, const std::array<double, 4>& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}

}  // namespace

double VortexMms::c() const { return std::sqrt(elastic.E / rho); }
double VortexMms::omega() const { return pulse.value_or(2 * pi * c() / (r_i + r_o)); }

MaterialPoint<2> VortexMms::at(const Vector& X, double t) const {
    const double R = radius_in(r_i, r_o, X, where);
    const auto [h, slope, curvature] = profile(*this, R);
    const double T = A * std::sin(omega() * t);
    const double alpha_t = A * omega() * std::cos(omega() * t) * h;
    const double g = R * T * slope;
    const double s = std::sin(T * h), half = std::sin(T * h / 2), turn = -2 * half * half;  // cos alpha - 1
    const Vector e_R{X[0] / R, X[1] / R}, e_O{-e_R[1], e_R[0]};
    const Vector e_r{e_R[0] + turn * e_R[0] - s * e_R[1], e_R[1] + turn * e_R[1] + s * e_R[0]}, e_o{-e_r[1], e_r[0]};
    const auto H = sum({turn, -s, s, turn}, dyad(g, e_o, e_R));
    const double mu = elastic.G;
    const double b_r = R * (mu / rho * T * slope * T * slope - alpha_t * alpha_t);
    const double b_o = -R * omega() * omega() * T * h - mu / rho * (T * (3 * slope + R * curvature));
    return {.u = {turn * X[0] - s * X[1], turn * X[1] + s * X[0]},
            .v = {alpha_t * R * e_o[0], alpha_t * R * e_o[1]},
            .stress = sum(sum(dyad(mu * g, e_r, e_o), dyad(mu * g, e_o, e_r)), dyad(mu * g * g, e_o, e_o)),
            .strain = H,
            .b = {b_r * e_r[0] + b_o * e_o[0], b_r * e_r[1] + b_o * e_o[1]},
            .F = {1 + H[0], H[1], H[2], 1 + H[3]},
            .P = sum(dyad(mu * g, e_r, e_O), dyad(mu * g, e_o, e_R))};
}

Oracle vortex_mms() {
    return {
        .name = "vortex_mms",
        .about = "Generalized vortex: the circles of a neo-Hookean ring turn against each other, its rims at rest",
        .source = {"Kamojjala2015"},
        .explanation =
            "x = Q(alpha) X,  alpha = T h(R),  T = A sin(omega t),  h = 16 (R-r_i)^2 (r_o-R)^2 / (r_o-r_i)^4\n"
            "F = Q (I + g e_O e_R),  g = R alpha' (shear),  J = 1: lambda drops out\n"
            "P = mu g (e_r e_O + e_o e_R);  stress_rr = 0,  stress_ro = mu g,  stress_oo = mu g^2\n"
            "body_force_r = -R alpha_t^2 + (mu/rho) R alpha'^2\n"
            "body_force_o = R alpha_tt - (mu/rho)(3 alpha' + R alpha'')\n"
            "e_R, e_O: polar directions at X; e_r, e_o: at x, turned by alpha. A form in e_R, e_O that circulates in\n"
            "public codes has + R alpha_t^2 where - is right; this one satisfies the balance of momentum.\n" +
            manufactured_law() +
            "\nComponents are along x and y. h = h' = 0 on both rims: at rest and free of traction, so held or free\n"
            "boundaries are both right. c = sqrt(E / rho); omega is 2 pi c / (r_i + r_o) when not given.\n"
            "Elasticity: any two of E, nu, K, G, lambda, M. Refused: points off the ring; r_i >= r_o;\n"
            "omega t > 1e12, where the phase is lost. Constants: E nu K G lambda M c omega",
        .example = "vortex_mms --t 0.5 --x 1:0,0.7:0.6",
        .parameters = parameters(),
        .fields = manufactured_fields(),
        .smoothness = "analytic in x and t",
        .accuracy = "1e-15 (4 r_o / (r_o - r_i) + omega t) (1 + |A|) of each field's amplitude",
        .bind = bind};
}

}  // namespace ordo::oracles

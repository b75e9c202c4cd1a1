#include "oracles/manufactured/axis_aligned_mms.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/manufactured/half_turns.hpp"
#include "oracles/manufactured/neo_hookean.hpp"

namespace ordo::oracles {
namespace {

constexpr double pi = boost::math::constants::pi<double>();
constexpr const char* where = "oracle axis_aligned_mms";

AxisAlignedMms body_of(const Values& values) {
    AxisAlignedMms body{.L = values.number("L"),
                        .A = values.number("A"),
                        .rho = values.number("rho"),
                        .k = values.whole("k"),
                        .phase = {values.number("phase_x"), values.number("phase_y"), values.number("phase_z")},
                        .elastic = elastic_constants(values, AxisAlignedMms{}.elastic, where)};
    if (values.has("c")) body.speed = values.number("c");
    const double fastest = std::max(body.c(), std::sqrt(body.elastic.M / body.rho));
    require_representable(body.elastic, body.rho, body.k * fastest / body.L, where);
    if (!(body.k * pi * std::abs(body.A) < body.L))
        throw InputError(where, "A = " + shortest(body.A) + " m with k = " + std::to_string(body.k) +
                                    " turns the body inside out (det F <= 0); must be below L/(k pi) = " +
                                    shortest(body.L / (body.k * pi)) + " in size");
    return body;
}

template <std::size_t dim>
Exact exact(const AxisAlignedMms& body) {
    return {
        .dim = dim,
        .coordinates = Coordinates::material,
        .lower = std::vector<double>(dim, 0.0),
        .upper = std::vector<double>(dim, body.L),
        .times = times_up_to(body.omega()),
        .fields = manufactured_fields(),
        .sample = material_points<dim>(body),
        .jumps = no_jumps,
        .features = no_features,
        .constants = [body](std::optional<double>) { return motion_constants(body.elastic, body.c(), body.omega()); }};
}

Exact bind(const Values& values) {
    const AxisAlignedMms body = body_of(values);
    return values.whole("dim") == 2 ? exact<2>(body) : exact<3>(body);
}

std::vector<Parameter> parameters() {
    return appended(appended({whole("dim", 2, between(2, 3), "space dimension")}, elastic_parameters("E 1e7, nu 0.3")),
                    {number("L", "m", 1, positive, "edge of the square or cube"),
                     number("rho", "kg/m^dim", 1000, positive, "density"),
                     number("A", "m", 0.05, finite, "amplitude of the displacement, below L/(k pi) in size"),
                     whole("k", 1, between(1, 1000), "half waves along an edge"),
                     number("phase_x", "rad", 0, between(-1000, 1000), "phase of the motion along x"),
                     number("phase_y", "rad", pi, between(-1000, 1000), "phase of the motion along y"),
                     number("phase_z", "rad", pi, between(-1000, 1000), "phase of the motion along z, in 3D"),
                     without_default(number("c", "m/s", 0, positive, "speed of the motion; absent: sqrt(E / rho)"))});
}

/// (k^2 M - rho c^2) / rho, what is left of inertia and stiffness where nothing is strained [m^2/s^2].
double detuning(const AxisAlignedMms& body) {
    const double waves = static_cast<double>(body.k) * body.k;
    if (body.speed) return waves * body.elastic.M / body.rho - *body.speed * *body.speed;
    return ((waves - 1) * body.elastic.M + wave_excess(body.elastic)) / body.rho;
}

/// k X / L less whole turns of 2: the product's rounding is carried along, so that high waves keep their digits.
double half_turns(double k, double X, double L) {
    const double product = k * X;
    return (std::remainder(product, 2 * L) + std::fma(k, X, -product)) / L;
}

}  // namespace

double AxisAlignedMms::c() const { return speed.value_or(std::sqrt(elastic.E / rho)); }
double AxisAlignedMms::omega() const { return pi * c() / L; }

template <std::size_t dim>
MaterialPoint<dim> AxisAlignedMms::at(const std::array<double, dim>& X, double t) const {
    const NeoHookean law(elastic);
    const double turn = omega() * t;
    MaterialPoint<dim> p{};
    std::array<double, dim> H{};
    double ln_J = 0;
    for (std::size_t a = 0; a < dim; ++a) {
        const double place = half_turns(k, X[a], L);
        const double in_space = sin_pi(place);
        const double in_time = std::sin(turn + phase[a]);
        p.u[a] = A * in_space * in_time;
        p.v[a] = A * omega() * in_space * std::cos(turn + phase[a]);
        H[a] = k * pi * (A / L) * cos_pi(place) * in_time;
        ln_J += std::log1p(H[a]);
    }
    const double J = std::exp(ln_J);
    const double base = detuning(*this);
    for (std::size_t a = 0; a < dim; ++a) {
        const std::size_t aa = a * dim + a;
        const double tau = law.kirchhoff(H[a], ln_J);
        p.stress[aa] = tau / J;
        p.strain[aa] = H[a];
        p.F[aa] = 1 + H[a];
        p.P[aa] = tau / (1 + H[a]);
        p.b[a] = (pi / L) * (pi / L) * p.u[a] * (base + k * (k * (law.hardening(H[a], ln_J) / rho)));
    }
    return p;
}

template MaterialPoint<2> AxisAlignedMms::at(const std::array<double, 2>& X, double t) const;
template MaterialPoint<3> AxisAlignedMms::at(const std::array<double, 3>& X, double t) const;

Oracle axis_aligned_mms() {
    return {.name = "axis_aligned_mms",
            .about = "Manufactured motion of a neo-Hookean square or cube along its axes, without shear",
            .source = {"WallstedtGuilkey2008"},
            .explanation =
                "u_a = A sin(k pi X_a / L) sin(omega t + phase_a),  omega = pi c / L,  a = x, y (, z)\n"
                "F_aa = 1 + (k pi A / L) cos(k pi X_a / L) sin(omega t + phase_a),  J = product of F_aa\n"
                "P_aa = lambda ln J / F_aa + mu (F_aa - 1/F_aa),  stress_aa = P_aa F_aa / J\n"
                "body_force_a = (pi^2 u_a / L^2) (k^2 mu/rho - c^2 + k^2 (lambda (1 - ln J) + mu) / (rho F_aa^2))\n" +
                manufactured_law() +
                "\nNormal displacement is 0 on every face and there is no shear: rollers (symmetry) all round. 2D is\n"
                "plane strain, without stress_zz. c is sqrt(E / rho) unless given, for instance sqrt(G / rho).\n"
                "Elasticity: any two of E, nu, K, G, lambda, M. Refused: k pi |A| >= L, where det F reaches 0;\n"
                "omega t > 1e12, where the phase is lost. Constants: E nu K G lambda M c omega",
            .example = "axis_aligned_mms --set dim=3 --t 0.003 --x 0.2:0.3:0.4,0.5:0.5:0.5",
            .parameters = parameters(),
            .fields = manufactured_fields(),
            .smoothness = "analytic in x and t",
            .accuracy =
                "1e-15 (4 + largest phase + omega t) of each field's amplitude (body_force with c given: of its "
                "largest term); over 10 (1 - k pi |A| / L) where that is below 1",
            .bind = bind};
}

}  // namespace ordo::oracles

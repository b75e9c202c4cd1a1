#include "oracles/manufactured/ring_mms.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/manufactured/annulus.hpp"
#include "oracles/manufactured/neo_hookean.hpp"

namespace ordo::oracles {
namespace {

constexpr double pi = boost::math::constants::pi<double>();
constexpr const char* where = "oracle ring_mms";

/// 1 - 3 r_i / r_o, rounded once before it is small.
double shape(const RingMms& ring) { return std::fma(-3.0, ring.r_i, ring.r_o) / ring.r_o; }

/// f / R, f' and R f'' at R [1/m].
struct Profile {
    double across, along, bending;
};

Profile profile(const RingMms& ring, double R) {
    const double in = (R - ring.r_i) / ring.r_o, out = (ring.r_o - R) / ring.r_o;
    const double share = 6 / shape(ring);
    return {.across = (1 + out - out * out * share / 3) / ring.r_o,
            .along = share * in * out / ring.r_o,
            .bending = share * (R / ring.r_o) * (out - in) / ring.r_o};
}

Exact bind(const Values& values) {
    const RingMms ring{.r_i = values.number("r_i"),
                       .r_o = values.number("r_o"),
                       .A = values.number("A"),
                       .rho = values.number("rho"),
                       .elastic = elastic_constants(values, RingMms{}.elastic, where)};
    require_ring(ring.r_i, ring.r_o, where);
    if (shape(ring) == 0) throw InputError(where, "r_o = 3 r_i leaves f without a value; any other ratio will do");
    if (!(ring.largest_strain() < 1))
        throw InputError(where, "A = " + shortest(ring.A) +
                                    " m turns the ring inside out (det F <= 0); must be below " +
                                    shortest(std::abs(ring.A) / ring.largest_strain()) + " in size");
    require_representable(ring.elastic, ring.rho, std::sqrt(ring.elastic.M / ring.rho) / ring.r_i, where);
    return {
        .dim = 2,
        .coordinates = Coordinates::material,
        .lower = {-ring.r_o, -ring.r_o},
        .upper = {ring.r_o, ring.r_o},
        .times = times_up_to(ring.omega()),
        .fields = manufactured_fields(),
        .sample = material_points<2>(ring),
        .jumps = no_jumps,
        .features = no_features,
        .constants = [ring](std::optional<double>) { return motion_constants(ring.elastic, ring.c(), ring.omega()); }};
}

std::vector<Parameter> parameters() {
    return appended(elastic_parameters("E 1e7, nu 0"),
                    {number("r_i", "m", 0.4, positive, "inner radius"),
                     number("r_o", "m", 0.6, positive, "outer radius; 3 r_i is not possible"),
                     number("rho", "kg/m^2", 1000, positive, "density"),
                     number("A", "m", 0.1, finite, "amplitude of the outer rim's displacement")});
}

/// along e_R e_R + across (I - e_R e_R), e = e_R.
std::array<double, 4> principal(double along, double across, const std::array<double, 2>& e) {
    const double more = along - across;
    return {along * e[0] * e[0] + across * e[1] * e[1], more * e[0] * e[1], more * e[0] * e[1],
            along * e[1] * e[1] + across * e[0] * e[0]};
}

}  // namespace

double RingMms::c() const { return std::sqrt(elastic.E / rho); }
double RingMms::omega() const { return pi * c() / (r_i + r_o); }

double RingMms::largest_strain() const {
    // f' is largest half-way. f / R is monotonic for r_o < 3 r_i; else its largest value between the rims, at most 9/8
    // of that on the outer rim, is below the largest f', at least 3/2 of it.
    const double most = std::max({std::abs(profile(*this, r_i).across), std::abs(profile(*this, r_o).across),
                                  std::abs(profile(*this, r_i + (r_o - r_i) / 2).along)});
    return std::abs(A) * most;
}

MaterialPoint<2> RingMms::at(const std::array<double, 2>& X, double t) const {
    const NeoHookean law(elastic);
    const double R = radius_in(r_i, r_o, X, where);
    const std::array<double, 2> e{X[0] / R, X[1] / R};
    const auto [across, along, bending] = profile(*this, R);
    const double T = A * std::sin(omega() * t);
    const double T_t = A * omega() * std::cos(omega() * t);
    const double H_R = T * along, H_O = T * across;
    const double F_R = 1 + H_R, F_O = 1 + H_O, J = F_R * F_O;
    const double ln_J = std::log1p(H_R) + std::log1p(H_O);
    const double P_R = law.kirchhoff(H_R, ln_J) / F_R, P_O = law.kirchhoff(H_O, ln_J) / F_O;
    // R times Div P; P_R - P_O and R dF_O/dR both hold the factor F_R - F_O.
    const double divergence = T * bending * (elastic.M + law.hardening(H_R, ln_J)) +
                              (H_R - H_O) * (law.mu + (law.mu + law.lambda * (1 - ln_J)) / J);
    const double b = -omega() * omega() * T * across * R - divergence / rho / R;
    return {.u = {T * across * X[0], T * across * X[1]},
            .v = {T_t * across * X[0], T_t * across * X[1]},
            .stress = principal(P_R / F_O, P_O / F_R, e),
            .strain = principal(H_R, H_O, e),
            .b = {b * e[0], b * e[1]},
            .F = principal(F_R, F_O, e),
            .P = principal(P_R, P_O, e)};
}

Oracle ring_mms() {
    return {
        .name = "ring_mms",
        .about = "Manufactured breathing of a neo-Hookean ring, its rims free of traction where nu = 0",
        .source = {"WallstedtGuilkey2008"},
        .explanation =
            "u = T f(R) e_R,  T = A sin(omega t),  omega = pi c / (r_i + r_o),  c = sqrt(E / rho)\n"
            "f = (R / r_o)(1 + e - 2 e^2 / (1 - 3 r_i/r_o)),  e = 1 - R/r_o;  f' = 0 on both rims, f(r_o) = 1\n"
            "F_R = 1 + T f',  F_O = 1 + T f/R (along the circle),  J = F_R F_O\n"
            "P_R = lambda ln J / F_R + mu (F_R - 1/F_R), P_O alike;  stress_R = P_R/F_O, stress_O = P_O/F_R\n"
            "body_force_R = T'' f - (dP_R/dR + (P_R - P_O)/R) / rho\n" +
            manufactured_law() +
            "\nComponents are along x and y; plane strain, unit thickness. The rims are free of traction only with\n"
            "lambda = 0 (nu = 0); else each carries the nominal traction P_R = lambda ln F_O.\n"
            "Elasticity: any two of E, nu, K, G, lambda, M. Refused: points off the ring; r_i >= r_o; r_o = 3 r_i,\n"
            "where f has no value; A with det F <= 0 somewhere; omega t > 1e12, where the phase is lost.\n"
            "Constants: E nu K G lambda M c omega",
        .example = "ring_mms --t 0.003 --x 0.5:0,0.3:0.4",
        .parameters = parameters(),
        .fields = manufactured_fields(),
        .smoothness = "analytic in x and t",
        .accuracy =
            "1e-15 (8 + omega t) of each field's amplitude; over 10 (1 - |A| max(|f'|, |f/R|)) where that is "
            "below 1",
        .bind = bind};
}

}  // namespace ordo::oracles

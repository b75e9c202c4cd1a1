#pragma once
// Generalized vortex: manufactured turning of the circles of a neo-Hookean ring against each other.
#include <optional>

#include "oracles/manufactured/material_point.hpp"

namespace ordo::oracles {

/// Every circle turns by alpha = T(t) h(R) about the origin: x = Q(alpha) X,  T = A sin(omega t),
///
///   h = 16 (R - r_i)^2 (r_o - R)^2 / (r_o - r_i)^4:   h = h' = 0 on both rims, h = 1 half-way
///   F = Q (I + g e_O e_R),   g = R alpha' (shear),   J = 1, so that lambda drops out
///   P = mu g (e_r e_O + e_o e_R);   Cauchy stress_rr = 0, stress_ro = mu g, stress_oo = mu g^2
///   b_r = -R alpha_t^2 + (mu / rho) R alpha'^2,   b_o = R alpha_tt - (mu / rho)(3 alpha' + R alpha'')
///
/// e_R, e_O are the polar directions at X, e_r, e_o those at x: turned by alpha. The rims are at rest and free of
/// traction. A body force that circulates, written in e_R and e_O, has the sign of one alpha_t^2 wrong.
///
/// X        position (x, y) in the undeformed ring, r_i <= R <= r_o [m]      t   time [s]
/// error    at() throws InputError off the ring (by more than 4 ulp of R)
/// accurate 1e-15 (4 r_o / (r_o - r_i) + omega t) (1 + |A|) of each field's amplitude
///          (gate: tests/oracles/manufactured)
/// source   [Kamojjala2015], with the body force corrected
struct VortexMms {
    double r_i = 0.75;                 ///< inner radius [m]
    double r_o = 1.25;                 ///< outer radius [m]
    double A = 1;                      ///< amplitude of the turn half-way [rad]
    double rho = 1000;                 ///< density [kg/m^2]
    std::optional<double> pulse = {};  ///< omega [1/s]; absent: 2 pi c / (r_i + r_o)
    ElasticConstants elastic = elastic_constants({Elastic::E, 1000}, {Elastic::nu, 0.3}, "");

    double c() const;      ///< sqrt(E / rho) [m/s]
    double omega() const;  ///< [1/s]
    MaterialPoint<2> at(const std::array<double, 2>& X, double t) const;
};

Oracle vortex_mms();

}  // namespace ordo::oracles

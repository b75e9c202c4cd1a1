#pragma once
// Manufactured breathing of a neo-Hookean ring.
#include "oracles/manufactured/material_point.hpp"

namespace ordo::oracles {

/// Every circle stays one: u = T(t) f(R) e_R,  T = A sin(omega t),  omega = pi c / (r_i + r_o),  c = sqrt(E / rho),
///
///   f = (R / r_o) (1 + e - 2 e^2 / (1 - 3 r_i / r_o)),  e = 1 - R / r_o:   f' = 0 on both rims, f(r_o) = 1, f(0) = 0
///   F_R = 1 + T f',   F_O = 1 + T f / R (along the circle),   J = F_R F_O
///   P_R = lambda ln J / F_R + mu (F_R - 1/F_R), P_O alike;   Cauchy stress_R = P_R / F_O, stress_O = P_O / F_R
///   b_R = T'' f - (dP_R/dR + (P_R - P_O) / R) / rho
///
/// With lambda = 0 both rims are free of traction; else they carry P_R = lambda ln F_O. Plane strain, unit thickness.
///
/// X        position (x, y) in the undeformed ring, r_i <= R <= r_o [m]      t   time [s]
/// error    at() throws InputError off the ring (by more than 4 ulp of R)
/// accurate 1e-15 (8 + omega t) of each field's amplitude; over 10 (1 - largest_strain()) where that is below 1
///          (gate: tests/oracles/manufactured)
/// source   [WallstedtGuilkey2008]; there f = c1 R + c2 R^2 + c3 R^3
struct RingMms {
    double r_i = 0.4;   ///< inner radius [m]
    double r_o = 0.6;   ///< outer radius [m], not 3 r_i
    double A = 0.1;     ///< amplitude of the outer rim's displacement [m]
    double rho = 1000;  ///< density [kg/m^2]
    ElasticConstants elastic = elastic_constants({Elastic::E, 1e7}, {Elastic::nu, 0}, "");

    double c() const;               ///< [m/s]
    double omega() const;           ///< [1/s]
    double largest_strain() const;  ///< |A| times the largest |f'| or |f / R| [-]; the ring is crushed from 1 on
    MaterialPoint<2> at(const std::array<double, 2>& X, double t) const;
};

Oracle ring_mms();

}  // namespace ordo::oracles

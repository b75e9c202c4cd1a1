#pragma once
// Manufactured motion of a neo-Hookean square or cube along its axes, without shear.
#include <optional>

#include "oracles/manufactured/material_point.hpp"

namespace ordo::oracles {

/// u_a(X, t) = A sin(k pi X_a / L) sin(omega t + phase_a),   omega = pi c / L,   a = x, y (, z)
///
///   F_aa = 1 + (k pi A / L) cos(k pi X_a / L) sin(omega t + phase_a),   J = product of F_aa
///   P_aa = lambda ln J / F_aa + mu (F_aa - 1/F_aa),   Cauchy stress_aa = P_aa F_aa / J
///   b_a  = (pi^2 u_a / L^2) ( k^2 mu / rho - c^2 + k^2 (lambda (1 - ln J) + mu) / (rho F_aa^2) )
///
/// In 2D this is plane strain; stress_zz is not among the fields.
///
/// X        position in the undeformed body, 0 <= X_a <= L [m]      t   time [s]
/// accurate 1e-15 (4 + largest phase + omega t) of each field's amplitude, whatever k; over 10 (1 - k pi |A| / L) where
///          that is below 1. body_force with a `speed` of one's own: of its largest term, pi^2 A k^2 M / (rho L^2)
///          (gate: tests/oracles/manufactured)
/// source   [WallstedtGuilkey2008]
struct AxisAlignedMms {
    double L = 1;                          ///< edge [m]
    double A = 0.05;                       ///< amplitude of the displacement [m], k pi |A| < L
    double rho = 1000;                     ///< density [kg/m^dim]
    int k = 1;                             ///< half waves along an edge
    std::array<double, 3> phase{0, 0, 0};  ///< [rad]
    std::optional<double> speed = {};      ///< c of the motion [m/s]; sqrt(E / rho) when absent
    ElasticConstants elastic = elastic_constants({Elastic::E, 1e7}, {Elastic::nu, 0.3}, "");

    double c() const;      ///< [m/s]
    double omega() const;  ///< [1/s]
    template <std::size_t dim>
    MaterialPoint<dim> at(const std::array<double, dim>& X, double t) const;
};

Oracle axis_aligned_mms();

}  // namespace ordo::oracles

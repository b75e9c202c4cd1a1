#pragma once
// Manufactured motion of a neo-Hookean bar with both ends held.
#include "oracles/manufactured/material_point.hpp"
#include "oracles/manufactured/neo_hookean.hpp"

namespace ordo::oracles {

/// u(X, t) = A sin(pi X / L) sin(omega t),   omega = pi c / L,   c = sqrt(E / rho)
///
///   F = 1 + (pi A / L) cos(pi X / L) sin(omega t)
///   P = lambda ln F / F + mu (F - 1/F), the Cauchy stress as well: the bar is as thick as ever
///   b = (pi^2 u / (rho L^2)) ( lambda (1 - ln F) / F^2 + mu (1 + 1/F^2) - E )
///
/// X        position in the undeformed bar, 0 <= X <= L [m]      t   time [s]
/// accurate 1e-15 (4 + omega t) of each field's amplitude; over 10 (1 - pi |A| / L) where that is below 1
///          (gate: tests/oracles/manufactured)
/// source   [Nguyen2023], [Tran2020]; their amplitude G is called A here, for G is the shear modulus
struct BarMms {
    double L = 1;       ///< length [m]
    double A = 1e-4;    ///< amplitude of the displacement [m], pi |A| < L
    double rho = 1000;  ///< density [kg/m]
    ElasticConstants elastic = elastic_constants({Elastic::E, 1e7}, {Elastic::nu, 0}, "");

    /// The bar at one time: what all its points share.
    struct Moment;

    double c() const;      ///< [m/s]
    double omega() const;  ///< [1/s]
    Moment at(double t) const;
    MaterialPoint<1> at(const std::array<double, 1>& X, double t) const;
};

struct BarMms::Moment {
    double L, rho;
    double u, v;  ///< of the points that move most [m], [m/s]
    double H;     ///< largest strain [-]
    double wave_excess;
    NeoHookean law;

    MaterialPoint<1> at(double X) const;
};

Oracle bar_mms();

}  // namespace ordo::oracles

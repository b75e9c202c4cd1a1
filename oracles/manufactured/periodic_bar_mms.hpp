#pragma once
// Manufactured standing wave of a periodic neo-Hookean bar.
#include "oracles/manufactured/material_point.hpp"

namespace ordo::oracles {

/// u(X, t) = A sin(2 pi X / L) cos(omega t),   omega = pi c / L,   c = sqrt(E / rho)
///
///   F = 1 + (2 pi A / L) cos(2 pi X / L) cos(omega t)
///   P = (E / 2)(F - 1/F), the Cauchy stress as well; the neo-Hookean law with lambda = 0, mu = E/2
///   b = omega^2 u (1 + 2 / F^2)
///
/// X        position in the undeformed bar, 0 <= X <= L, L the period [m]      t   time [s]
/// accurate 1e-15 (4 + omega t) of each field's amplitude; over 10 (1 - 2 pi |A| / L) where that is below 1
///          (gate: tests/oracles/manufactured)
/// source   [Steffen2008b], eqs 47 to 49; their bar length h is called L here
struct PeriodicBarMms {
    double L = 1;      ///< length and period [m]
    double A = 0.001;  ///< amplitude of the displacement [m], 2 pi |A| < L
    double rho = 1;    ///< density [kg/m]
    double E = 1e6;    ///< Young's modulus [Pa]

    double c() const;      ///< [m/s]
    double omega() const;  ///< [1/s]
    MaterialPoint<1> at(const std::array<double, 1>& X, double t) const;
};

Oracle periodic_bar_mms();

}  // namespace ordo::oracles

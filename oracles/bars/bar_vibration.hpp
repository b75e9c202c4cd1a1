#pragma once
// One mode of an elastic bar, fixed at one end or at both, or periodic.
#include "oracles/oracle.hpp"

namespace ordo::oracles {

/// Standing wave of the linear bar u_tt = (E/rho) u_XX, started from rest position by a sine of velocity.
///
///   u(X, t) = (v0 / omega) sin(omega t) sin(k X),   omega = k sqrt(E / rho)
///   fixed_free:  k = (2n - 1) pi / (2L)             fixed_fixed:  k = n pi / L
///   periodic:    k = 2 n pi / L
///
/// X        position in the undeformed bar, 0 <= X <= L [m]      t   time [s]
/// means    over a cell [a, b]: the value at its middle times sinc(k (b - a) / 2), for all four fields
/// accurate 2 ulp times (1 + k X + omega t), relative to the amplitude  (gate:
/// tests/oracles/bars/bar_vibration_test.cpp) source   [WobbesTielen2015]; exact for any strain where the nominal
/// stress is E (F - 1)
struct BarVibration {
    enum class Ends { fixed_free, fixed_fixed, periodic };

    double L = 25;    ///< length [m]
    double E = 100;   ///< Young's modulus [Pa]
    double rho = 1;   ///< density [kg/m]
    double v0 = 0.1;  ///< amplitude of the velocity at t = 0 [m/s]
    int mode = 1;     ///< n >= 1
    Ends ends = Ends::fixed_free;

    double wave_number() const;                     ///< k [1/m]
    double frequency() const;                       ///< omega [1/s]
    double displacement(double X, double t) const;  ///< [m]
    double velocity(double X, double t) const;      ///< [m/s]
    double strain(double X, double t) const;        ///< du/dX [-]
    double stress(double X, double t) const;        ///< E du/dX [Pa], tension positive
    double cell_factor(double a, double b) const;   ///< mean of any of them over [a, b] by its value at (a + b) / 2 [-]
};

Oracle bar_vibration();

}  // namespace ordo::oracles

#pragma once
// An elastic column at rest that gravity, or a load on its top, sets in motion.
#include "oracles/bars/bar.hpp"

namespace ordo::oracles {

/// rho u_tt = E u_yy - rho g r(t) on 0 <= y <= H;  u(0, t) = 0,  E u_y(H, t) = p0 for t > 0,  at rest at t = 0.
///
///   exact   (terms = 0) by images: the step load of bar_traction, and free fall that waves from the base take back,
///           u = -G(t) + sum_{m >= 0} (-1)^m [ G(t - (2mH + y)/c) + G(t - ((2m+2)H - y)/c) ],   G'' = g r, c^2 = E/rho
///   series  (terms = N) (rho g/2E) y^2 + (p0 - rho g H) y/E + sum_{n <= N} u_n cos(omega_n t) sin(k_n y),
///           u_n = 16 rho g H^2 / ((2n-1)^3 pi^3 E) + 8 H p0 (-1)^n / ((2n-1)^2 pi^2 E),  k_n = (2n-1) pi / (2H);
///           ramped, the parts of gravity follow r and int r'(s) cos(omega_n (t - s)) ds
///   r       1, or over the time `ramp` = T the quintic s^3 (10 - 15 s + 6 s^2) of s = t/T, twice differentiable
///
/// y        position in the undeformed column [m]      t   time [s]
/// accurate 1e-14 (1 + c t / H) of the largest value of a period 4H/c, away from the front of p0
///          (gate: tests/oracles/bars/oedometer_test.cpp)
/// source   [WobbesTielen2015], [MPMtry]; exact for any strain where the nominal stress is E (F - 1)
struct Oedometer {
    double H = 25;    ///< height [m]
    double E = 5e4;   ///< confined modulus [Pa]
    double rho = 1;   ///< density [kg/m]
    double g = 9.81;  ///< gravity, towards -y [m/s^2]
    double p0 = 0;    ///< nominal traction on the top from t = 0 on, tension positive [Pa]
    int terms = 0;    ///< of the series; 0 is exact
    double ramp = 0;  ///< time over which gravity grows to g [s]

    double wave_speed() const;             ///< c [m/s]
    double first_eigenfrequency() const;   ///< pi c / (2H) [1/s]
    double load_front(double t) const;     ///< where the front of p0 is, t > 0 [m]
    double gravity_front(double t) const;  ///< where the front of gravity's start is [m]

    bars::Fields at(double y, double t) const;                           ///< u, v and strain; at a jump the right state
    bars::Fields mean(double a, double b, double t) const;               ///< their means over [a, b]
    bars::Fields series(double a, double b, double t, int terms) const;  ///< means of the series; a = b is a point
    double series_bound(int terms) const;                                ///< no less than |u - u of the series| [m]

    double displacement(double y, double t) const;  ///< [m]
    double velocity(double y, double t) const;      ///< [m/s]
    double strain(double y, double t) const;        ///< du/dy [-]
    double stress(double y, double t) const;        ///< E du/dy [Pa], tension positive
};

Oracle oedometer();

}  // namespace ordo::oracles

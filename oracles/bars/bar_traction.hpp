#pragma once
// An elastic bar at rest, fixed at one end, that a traction at the other end sets in motion.
#include "oracles/bars/bar.hpp"

namespace ordo::oracles {

/// rho u_tt = E u_XX on 0 <= X <= L;  u(0, t) = 0,  E u_X(L, t) = load(t),  u = u_t = 0 at t = 0.
///
///   load   tau sin(omega t) for profile sine, tau for profile step (t > 0); nominal, tension positive
///   u      by images, with I(s) = (c/E) int_0^s load and c = sqrt(E / rho):
///          sum_{m >= 0} (-1)^m [ I(t - ((2m+1) L - X)/c) - I(t - ((2m+1) L + X)/c) ]   (finite, any omega)
///
/// X        position in the undeformed bar, 0 <= X <= L [m]      t   time [s], at any of which a point costs the same
/// accurate 1e-14 (1 + omega t) of the largest value until t (step: 1e-14 (1 + c t / L), away from the front)
///          (gate: tests/oracles/bars/bar_traction_test.cpp)
/// source   [Steffen2008], [MPMtry]; exact for any strain where the nominal stress is E (F - 1)
struct BarTraction {
    enum class Profile { sine, step };

    double L = 1;                      ///< length [m]
    double E = 100;                    ///< Young's modulus [Pa]
    double rho = 100;                  ///< density [kg/m]
    double tau = 1;                    ///< traction [Pa]
    double omega = 3.141592653589793;  ///< angular frequency of the sine [1/s]
    Profile profile = Profile::sine;

    double wave_speed() const;           ///< c [m/s]
    double eigenfrequency(int n) const;  ///< omega_n = (2n - 1) pi c / (2L), n >= 1 [1/s]
    double resonant_mode() const;        ///< n where omega is omega_n to 4 ulp, else 0
    double front(double t) const;        ///< where the front is, t > 0 [m]

    bars::Fields at(double X, double t) const;              ///< u, v and strain; at a jump the right state
    bars::Fields mean(double a, double b, double t) const;  ///< their means over [a, b]
    double displacement(double X, double t) const;          ///< [m]
    double velocity(double X, double t) const;              ///< [m/s]
    double strain(double X, double t) const;                ///< du/dX [-]
    double stress(double X, double t) const;                ///< E du/dX [Pa]

    /// A second route to u: q_1(t) sin(k_1 X) + ... with `terms` terms, also at resonance (oracles/bars/series.cpp).
    double modal_displacement(double X, double t, int terms) const;
    /// No less than |u - modal_displacement|, round-off apart; infinite while omega >= terms pi c / L.
    double modal_bound(int terms) const;

    /// A third route: the forced (step: static) solution in closed form plus free modes, which fall off one power of n
    /// faster for the sine. Not at resonance, next to which its parts cancel.
    double lifted_displacement(double X, double t, int terms) const;
    /// No less than |u - lifted_displacement|; infinite while omega >= terms pi c / L and at resonance.
    double lifted_bound(int terms) const;
};

Oracle bar_traction();

}  // namespace ordo::oracles

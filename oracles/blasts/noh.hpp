#pragma once
// Noh's implosion: a cold gas that runs into a wall, an axis or a centre.
#include <optional>

#include "oracles/oracle.hpp"

namespace ordo::oracles {

/// Ideal gas without pressure that flows towards r = 0 everywhere with speed v0, stopped by a shock that runs outwards.
///
///   r_shock = S t,  S = (gamma - 1) v0 / 2          j = 1 planar, 2 cylindrical, 3 spherical
///   r < r_shock   u = 0     rho = rho0 ((gamma + 1) / (gamma - 1))^j    e = v0^2 / 2   p = (gamma - 1) rho e
///   r >= r_shock  u = -v0   rho = rho0 (1 + v0 t / r)^(j - 1)           e = 0          p = 0
///
/// r        distance from the wall, the axis or the centre, r >= 0 [m]      t   time, t >= 0 (t = 0: the data) [s]
/// accurate 8 ulp of every value, 16 of a mean, 2 of r_shock (gate: tests/oracles/blasts/noh_test.cpp)      source
/// [Noh1987]
struct Noh {
    enum class Geometry { planar = 1, cylindrical, spherical };

    /// Fields of one point, or their means over a shell.
    struct State {
        double velocity;  ///< [m/s], outwards positive
        double density;   ///< [kg/m^3]
        double pressure;  ///< [Pa]
        double energy;    ///< specific internal energy [J/kg]
    };

    Geometry geometry = Geometry::spherical;
    double gamma = 5.0 / 3;  ///< ratio of the specific heats, > 1 [-]
    double rho0 = 1;         ///< density at t = 0 [kg/m^3]
    double v0 = 1;           ///< inflow speed, > 0 [m/s]

    double shock_speed() const;  ///< S [m/s]
    State post_shock() const;
    State at(double r, double t) const;              ///< at the shock itself what lies ahead of it
    State mean(double a, double b, double t) const;  ///< over a < r < b by volume, r^(j-1) dr
};

Oracle noh();

}  // namespace ordo::oracles

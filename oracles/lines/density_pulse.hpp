#pragma once
// A pulse of density that a uniform stream carries round and round.
#include <vector>

#include "oracles/oracle.hpp"
#include "oracles/riemann/gas_fan.hpp"

namespace ordo::oracles {

/// Gas of the density rho_pulse on begin <= x < begin + width, and of stream.rho elsewhere, in a periodic domain
/// [0, L). Velocity and pressure are the same everywhere, so that nothing happens but transport:
///
///   rho(x, t) = rho(x - v t, 0),   v and p constant
///
/// x        position in space, 0 <= x <= L [m];   t   time [s];   at a jump the state on the right
/// accurate places 4 ulp of |v t| + L, values 2 ulp  (gate: tests/oracles/lines/density_pulse_test.cpp)
/// source   [Toro2009, section 2.4]: a contact is a linearly degenerate wave
struct DensityPulse {
    Gas stream;
    double rho_pulse = 2;  ///< [kg/m^3]
    double begin = 0.25;   ///< of the pulse at t = 0, in [0, L) [m]
    double width = 0.5;    ///< < L [m]
    double L = 1;          ///< period [m]

    double place(double t) const;  ///< where the pulse begins, in [0, L) [m]
    GasFields at(double x, double t) const;
    GasFields mean(double a, double b, double t) const;  ///< over a < x < b, 0 <= a, b <= L
    std::vector<double> jumps(double t) const;           ///< in [0, L), rising: where it begins and where it ends

private:
    GasFields fields(bool inside) const;
};

Oracle density_pulse();

}  // namespace ordo::oracles

#pragma once
// A uniform gas beside a rigid wall that begins to move, or that it runs into.
#include <vector>

#include "oracles/oracle.hpp"
#include "oracles/riemann/riemann_gas.hpp"

namespace ordo::oracles {

/// The gas fills x > x0 at t = 0 and has the velocity v; the wall on its left moves with V from then on. One wave runs
/// to the right, a shock where V > v and a fan where V < v, and behind it the gas moves with the wall. In the wall's
/// mirror the gas has the velocity 2 V - v: both together are a Riemann problem whose contact is the wall. With
/// M = |V - v| / a the pressure on the wall is
///
///   V > v:  p* = p (1 + gamma (gamma + 1) / 4 M^2 + gamma M sqrt(1 + ((gamma + 1) M / 4)^2))
///   V < v:  p* = p (1 - (gamma - 1) / 2 M)^(2 gamma / (gamma - 1)), and 0, a vacuum, from M = 2 / (gamma - 1) on
///
/// x        position in space, x >= wall(t) [m]      t   time, t >= 0 [s]
/// accurate as RiemannGas (gate: tests/oracles/lines/gas_piston_test.cpp); throws as it does
/// source   [Toro2009, section 6.3] for the mirrored gas
class GasPiston {
public:
    GasPiston(const Gas& gas, double V, double x0 = 0);

    double wall(double t) const { return x0_ + V_ * t; }  ///< its place [m]
    double wall_pressure() const { return both_.star().p; }
    GasFields at(double x, double t) const;              ///< throws InputError behind the wall
    GasFields mean(double a, double b, double t) const;  ///< over a < x < b; the same
    std::vector<Wave> waves(double t) const;             ///< at most one; a vacuum's edge is none
    std::vector<double> jumps(double t) const;

private:
    void check(double x, double t) const;

    double x0_;
    double V_;
    RiemannGas both_;  ///< the gas and its mirror image
};

Oracle gas_piston();

}  // namespace ordo::oracles

#pragma once
// Fields at a point and their means over cells: uniform gas, the inside of a fan, and nothing at all.
#include <array>

#include "oracles/riemann/gas_side.hpp"

namespace ordo::oracles {

/// What is sampled. In a vacuum velocity and energy have no value (NaN).
struct GasFields {
    double density;       ///< rho [kg/m^3]
    double velocity;      ///< v [m/s]
    double pressure;      ///< p [Pa]
    double energy;        ///< specific internal, e = (p + gamma p_inf) / ((gamma - 1) rho) [J/kg]
    double momentum;      ///< rho v [kg/(m^2 s)]
    double total_energy;  ///< rho (e + v^2 / 2) [J/m^3]

    std::array<double, 6> row() const { return {density, velocity, pressure, energy, momentum, total_energy}; }
    /// Adds share times part.
    void add(double share, const GasFields& part) {
        density += share * part.density;
        velocity += share * part.velocity;
        pressure += share * part.pressure;
        energy += share * part.energy;
        momentum += share * part.momentum;
        total_energy += share * part.total_energy;
    }
    bool operator==(const GasFields&) const = default;
};

/// The fields of a gas. P = p + p_inf is given apart from p, since either may be lost in the other.
GasFields fields_of(const Gas& gas, double P);

/// No gas, where the pressure is that of the cavity: 0, or -p_inf where a stiffened gas came apart. Its total energy
/// -p makes its walls conserve energy.
GasFields nothing(double p);

/// The fan of one gas at a depth behind its head [m/s], which runs outwards with speed a:
///
///   c = 1 - depth / ((n + 1) a),  v = v_K -+ n depth / (n + 1) (left +),  rho = rho_K c^n,  P = P_K c^(n + 2)
struct GasFan {
    const GasSide& side;
    double inwards;  ///< +1 on the left, -1 on the right: the sign of the gas's acceleration
    double least;    ///< c at the tail, below which round-off may not carry it; 0 next to a vacuum

    double contraction(double depth) const;  ///< c
    GasFields at(double depth) const;

    /// Means over depths from `outer` to `inner`, every one by the exact integral of its power of c.
    GasFields mean(double outer, double inner) const;
};

/// The integrals of (1 + q x)^k x^j over 0 < x < 1 for j = 0, 1, 2, for -1 <= q <= 0 and k > 0, to a few ulp.
std::array<double, 3> moments(double k, double q);

}  // namespace ordo::oracles

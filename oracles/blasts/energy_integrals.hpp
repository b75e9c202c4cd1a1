#pragma once
// How much energy a point blast of given front holds.
#include "oracles/blasts/similarity.hpp"

namespace ordo::oracles {

/// J1 and J2 of the blast, and alpha: energy = alpha rho0 r_shock^(j + 2 - omega) / t^2.
///
///   J1 = 16 / ((gamma^2 - 1) n^2)  integral_0^1 g f^2 lambda^(j - 1) dlambda       (kinetic)
///   J2 = 8 / ((gamma + 1) n^2)     integral_0^1 h lambda^(j - 1) dlambda           (internal)
///   alpha = J1 / 2 + J2 / (gamma - 1)                        planar, one side
///   alpha = (j - 1) pi (J1 + 2 J2 / (gamma - 1))             cylindrical, spherical
///
/// By double exponential quadrature over the parameter q of the profiles, in which the integrands are analytic and fall
/// exponentially: no end point is singular.
///
/// accurate to 1e-14, relative (gate: tests/oracles/sedov)
/// source   [KammTimmes2007]
struct EnergyIntegrals {
    double J1, J2, alpha;
};

EnergyIntegrals energy_integrals(const Similarity& profiles, int j, double gamma, double omega);

}  // namespace ordo::oracles

#pragma once
// Largest stable Courant numbers C = c dt / h in closed form, c = sqrt(E / rho).
#include <optional>
#include <span>

namespace ordo::oracles {

/// Which of the schemes whose limits are known: particles that take velocity increments (FLIP) through tents.
struct TentScheme {
    enum class Order { stress_last, stress_first_or_remapped };  ///< USL, or USF and MUSL
    bool consistent = false;                                     ///< mass matrix; else lumped
    Order order = Order::stress_last;
};

/// Mean of (1 - 2 xi)^2 over the particles of a cell, xi their places in it, 0 to 1.
double saw_tooth_share(std::span<const double> xi);

/// Limit on a periodic bar of equal cells with these particles in each, held where they are, for all wave lengths that
/// fit into `cells` (an even number; 0: all there are). With s = sin^2 of half the phase from node to node, the grid's
/// stiffness is 4 s and its consistent mass mu = 1 - (1 - kappa) s, both over those of one cell, and
///
///   lumped, stress last                C^2 s (2 - mu) <= 1    1 / sqrt(2 - kappa)
///   lumped, stress first or remapped   C^2 s mu <= 1          2 sqrt(1 - kappa); 1 / sqrt(kappa) for kappa > 1/2
///   consistent                         C^2 s / mu <= 1        sqrt(kappa)
///
/// accuracy round-off          source   derived here; gate: tests/oracles/stability/mpm_limits_test.cpp
double largest_courant(const TentScheme& scheme, std::span<const double> xi, int cells = 0);

/// One cell, its left node held, one particle at xi of it: 2 sqrt(xi / (2 - xi)) for lumped mass and stress last, 2 for
/// stress first or remapped. The small-mass node in closed form.
double largest_courant_of_one_cell(TentScheme::Order order, double xi);

/// Finite elements of equal length on a bar held at its lower end, free or held at its upper one, with lumped mass.
double largest_courant_of_elements(int elements, bool free_end);

}  // namespace ordo::oracles

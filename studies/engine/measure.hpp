#pragma once
// From a snapshot to error figures: where solver and truth meet in numbers.
#include <vector>

#include "oracles/oracle.hpp"
#include "solvers/solver.hpp"
#include "studies/engine/result.hpp"

namespace ordo::studies {

/// Each quantity that is measured against the exact solution or itself, at the snapshot's time: at its points; where it
/// has cells, l1 and l2 are integrals over them, and the places of waves are found in them. Throws InputError where
/// cells leave the box in which the solution holds.
std::vector<RunFigure> errors_against_exact(const std::vector<Quantity>& quantities, const solvers::Snapshot& shot,
                                            const oracles::Exact& exact);

/// One quantity against another run of the same points. Throws std::logic_error where the points differ in number.
double error_against(const Quantity& quantity, const solvers::Snapshot& shot, const solvers::Snapshot& reference);

}  // namespace ordo::studies

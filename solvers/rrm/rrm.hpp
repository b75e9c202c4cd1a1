#pragma once
// The Repeated Replacement Method for gas and elastic lines. Read line.hpp first: a line is uniform cells with fronts
// between them, and time goes on by one event after the other. The four verbs have a file each:
//
//   find.hpp       when a front will have changed as much as it may, and when a cell's core is used up
//   chop_out.hpp   the interval that is taken out: one front, or the two that have met
//   flatten.hpp    what it becomes: one cell, or two on both sides of a contact
//   put_back.hpp   where it is put, and the fronts to its neighbours; waves.hpp, jumps.hpp: waves that need no front
#include "solvers/solver.hpp"

namespace ordo::solvers::rrm {

Solver solver();

}  // namespace ordo::solvers::rrm

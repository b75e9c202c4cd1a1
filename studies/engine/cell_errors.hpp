#pragma once
// How far fields on cells are from an exact solution, as integrals over the cells and not at points.
#include <span>
#include <vector>

#include "oracles/oracle.hpp"
#include "studies/engine/profile.hpp"

namespace ordo::studies {

/// A field on cells, and where it stands in a row of the exact solution.
struct CellField {
    Profile found;
    std::size_t offset = 0;
};

/// Integrals of a field's error e(x) = found - exact over all cells; NaN where the exact field has no value.
struct CellErrors {
    double l1 = 0;       ///< integral of |e| [field m]
    double l2 = 0;       ///< sqrt(integral of e^2) [field m^(1/2)]
    double l1_fans = 0;  ///< integral of |e| over the middle half of every fan, NaN without one [field m]
    double l1_near = 0;  ///< integral of |e| no further than `near` from what is not smooth [field m]
    double l1_away = 0;  ///< and over the rest: l1 is both
};

/// The errors of each field at time t. Each cell is cut at the exact solution's jumps and at the edges and quarters of
/// its fans. On each part e is a polynomial through 17 nodes, integrated exactly between its zeros; the part is halved
/// as long as Gauss's rule of 7 nodes differs from Kronrod's of 15. All nodes lie strictly inside, so that the states
/// at the very place of a jump count nothing. Points are sampled in one call a level.
///
/// With `near` [m], cells are cut there too.
///
/// fields   all on the same cells: n + 1 rising edges [m]
/// exact    in space and one dimension
/// errors   throws InputError where the cells leave the box in which the solution holds
/// accurate 1e-10 of the field's range and 1e-12 of its size, times the length of all cells, where the exact solution
///          is analytic between its waves; two changes of sign between neighbouring nodes go unseen
///          (gate: tests/studies/engine/cell_errors_test.cpp)
std::vector<CellErrors> cell_errors(std::span<const CellField> fields, const oracles::Exact& exact, double t,
                                    double near = 0);

}  // namespace ordo::studies

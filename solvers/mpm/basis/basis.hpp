#pragma once
// From positions to stencils, for each basis of the family.
#include "solvers/mpm/basis/stencil.hpp"
#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/particles.hpp"

namespace ordo::solvers::mpm {

/// How far a filling came: the first point that no cell holds, or their number; how many changed their cell, and
/// whether one stands on a face.
struct Filled {
    std::size_t rows;
    long crossed;
    bool on_face;  ///< a point stands exactly on a face between cells
};

/// Fills the row of every point at x with the grid's own functions (tents or B-splines) there, and `cell` with where it
/// was found.
template <int dim>
Filled fill_at_points(const Grid<dim>& grid, std::span<const Vec<dim>> x, std::span<Cell<dim>> cell,
                      Stencils<dim>& stencils);

/// The same for particles, by the basis chosen: at their points, or over the boxes that they stand for.
/// In the total frame the positions are those of the undeformed body.
template <int dim>
Filled fill(const Grid<dim>& grid, const Options& options, Particles<dim>& particles, Stencils<dim>& stencils);

}  // namespace ordo::solvers::mpm

#pragma once
// Points on the faces of the body: where traction acts and where it ends. They have no mass and move with the grid.
#include <optional>
#include <vector>

#include "solvers/mpm/basis/stencil.hpp"
#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/particles.hpp"

namespace ordo::solvers::mpm {

/// Points, placed as the particles are, of each free face that carries a load; where its ends matter to the grid or to
/// a reconstruction, of every face.
template <int dim>
struct Boundary {
    std::optional<VectorField<dim>> traction;  ///< nominal [Pa]
    std::vector<Vec<dim>> X, x;                ///< [m]
    std::vector<double> area;                  ///< undeformed [m^(dim-1)]
    std::vector<Cell<dim>> cell;
    Stencils<dim> stencils;

    Boundary(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution,
             const Particles<dim>& particles);

    bool moves() const { return particle_.empty() && !x.empty(); }

    /// Their own stencils, or those of the particles that stand for them. Throws Diverged when one has left the grid.
    void meet_grid(const Grid<dim>& grid, bool total, const Stencils<dim>& of_particles);

    /// out_i += sum S_i area traction; returns the total [N]. A node without mass cannot take its part: the others do.
    Vec<dim> pull(double t, const Grid<dim>& grid, std::vector<Vec<dim>>& out);

    void move(double dt, const Grid<dim>& grid);

private:
    /// use(node, weight) for the nodes of point k that have mass; their weights sum to one. False where none has.
    template <class Use>
    bool massive_nodes(std::size_t k, const Grid<dim>& grid, Use&& use) const;

    std::vector<std::size_t> particle_;  ///< the particle that takes a point's load; empty: none does
    std::vector<Vec<dim>> force_;
};

}  // namespace ordo::solvers::mpm

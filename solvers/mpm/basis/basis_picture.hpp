#pragma once
// A line of particles on a grid of unit cells, as pictures of the method draw it: the functions of the grid as
// particles see them; those of the particles are in particle_basis.hpp. The weights are those of the running method:
// fill() and fill_at_points(). Lengths are in cells; the grid begins at x = 0.
#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "solvers/mpm/options.hpp"
#include "solvers/mpm/particles.hpp"

namespace ordo::solvers::mpm {

/// A body in the middle of the grid, parted into round(ppc (cells - 2 margin)) equal boxes with a particle in the
/// middle of each; then stretched about its middle and shifted, boxes and all.
struct Lineup {
    Basis basis = Basis::linear;
    int cells = 6;         ///< of the grid
    int margin = 1;        ///< cells on either side of the undeformed body, >= 1
    double ppc = 2;        ///< particles a cell of the undeformed body
    double translate = 0;  ///< [cells]
    double stretch = 1;    ///< F
};

/// Weights, singular values and lengths below this are round-off: those that are meant are of order 1, or vanish.
inline constexpr double negligible = 1e-12;

/// Rows of weights: of a point or particle each, a column a node.
using Weights = Eigen::MatrixXd;

struct Picture {
    Lineup lineup;
    Grid<1> grid;
    Particles<1> particles;
    Weights S;                    ///< S_pi of n particles
    std::vector<bool> touched;    ///< nodes that any particle touches by more than round-off
    std::vector<double> corners;  ///< lower and upper end of each box

    int nodes() const { return grid.nodes(); }
    Eigen::Index count() const { return S.rows(); }
    Eigen::VectorXd positions() const;  ///< x_p
};

/// What --cells and the like accept: names, units, defaults, ranges.
std::vector<Parameter> lineup_parameters();

/// Throws InputError where no cell is left for the body, and where it leaves the grid; `where` opens the message.
Picture picture_of(const Lineup& lineup, const std::string& where = "");

/// S_i for a particle centred at each x, with the box that the particles of the picture have. A box that reaches beyond
/// the grid is cut there, as the method does.
Weights grid_basis(const Picture& picture, std::span<const double> x);

/// The grid's own functions, tents or splines, at each x.
Weights grid_functions(const Picture& picture, std::span<const double> x);

/// The tents interpolated between the corners of the boxes, which CPDI puts in their place: NaN outside all boxes.
/// source [Brannon2013]
Weights interpolated_tents(const Picture& picture, std::span<const double> x);

/// Points from one end of the grid to the other, `points_a_cell` a cell, with all corners and particles among them.
std::vector<double> drawing_points(const Picture& picture);
inline constexpr int points_a_cell = 40;

/// Those of them that lie between the outermost particles.
std::vector<double> points_between_particles(const Picture& picture);

}  // namespace ordo::solvers::mpm

#pragma once
// Quadrature points in the place of particles: fields are reconstructed from the particles, taken at points where a
// rule knows how to integrate, and gathered from there. One dimension.
#include <array>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "solvers/mpm/basis/stencil.hpp"
#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/particles.hpp"
#include "solvers/mpm/reconstruction/samplers.hpp"

namespace ordo::solvers::mpm {

/// What stands for the particles on their way to the grid.
///
/// cubic_spline   not-a-knot spline through the particles' values, 2 x 2 Gauss points a cell       [Tielen2017]
/// tls            Taylor least squares in each cell about its mean, 2 Gauss points: sums over points of V f are those
///                over the cell's particles                                                        [Wobbes2019]
/// mls            moving least squares of a given degree, 4 Gauss points a cell, scaled to the particles' mass
/// impm           moving linear least squares at cell centres, and at nodes for the velocity       [SulskyGong2016]
///
/// Density, momentum, stress and body force are sampled; what a rule gathers differs from the integral by the error of
/// the sampling: h^4 (cubic_spline), h^3 (tls), h^(degree + 1) (mls), h^2 (impm). Particles stand in the order of their
/// positions. Throws Diverged where too few of them are near a point.
class Reconstruction1D {
public:
    explicit Reconstruction1D(const Options& options);

    /// Points in every cell of a grid that ends where the body does, their stencils and masses.
    void place(const Grid<1>& grid, const Particles<1>& particles);
    void sample_velocity(const Particles<1>& particles);
    /// Stress, and force per unit mass b unless it is empty.
    void sample_forces(const Particles<1>& particles, std::span<const Vec<1>> b);

    bool knows_node_velocities() const { return at_nodes_.has_value(); }  ///< impm: and b acts at the particles

    Points<1> points;  ///< X is not known and left empty
    Stencils<1> stencils;
    std::vector<Vec<1>> b;       ///< force per unit mass at the points
    std::vector<Vec<1>> node_v;  ///< where node velocities are known

private:
    void meet(const Grid<1>& grid);
    void sample(std::span<const double> f, std::span<double> out);
    void sample_by_mass(const Particles<1>& particles, std::span<const Vec<1>> f, std::vector<Vec<1>>& out);

    std::vector<double> xi_, weight_;  ///< of the rule on (0, 1)
    int degree_;
    std::variant<SplineSampler, MovingSampler, TaylorSampler> sampler_;
    std::optional<MovingSampler> at_nodes_;
    Stencils<1> on_unit_cells_;  ///< of the points, were the grid's cells as wide as 1
    std::vector<TaylorSampler::Stretch> stretches_;
    std::vector<double> nodes_;    ///< positions of the grid's nodes, where velocities are taken there
    std::vector<double> f_, rho_;  ///< scratch: a field of the particles; density at the points
};

}  // namespace ordo::solvers::mpm

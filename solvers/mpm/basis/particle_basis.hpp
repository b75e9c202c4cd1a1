#pragma once
// The functions of the particles: how values of particles become fields of the grid, and what this makes of a constant
// and of a linear field.
#include <array>
#include <span>
#include <vector>

#include "solvers/mpm/basis/basis_picture.hpp"

namespace ordo::solvers::mpm {

/// How values of particles become values of nodes: f_i = sum_p T_ip f_p.   source [Brannon2013]
enum class Mapping {
    weighted,        ///< option 1: T_ip = S_pi / sum_q S_qi
    pseudo_inverse,  ///< option 2: T is the pseudo-inverse of S, the least squares fit of least norm
};

/// T, nodes x particles, and the rank of S (in the columns of touched nodes). Nodes that no particle touches get none
/// of any particle: their rows are zero. Singular directions below `negligible` of the largest count as none.
struct NodalMap {
    Weights T;
    Eigen::Index rank = 0;
};
NodalMap nodal_map(const Picture& picture, Mapping mapping);

/// Phi_p at each x: sum_i S_i(x) T_ip by the grid's own functions; a column a particle. NaN where a function of an
/// untouched node is felt: the method has no field there.
Weights particle_basis(const Picture& picture, const NodalMap& map, std::span<const double> x);

/// The field f from particles to nodes and back: to the particles by S, and to each x by the grid's own functions.
struct Reproduced {
    Eigen::VectorXd at_particles;
    Eigen::VectorXd at_x;  ///< NaN as in particle_basis
};
Reproduced reproduced(const Picture& picture, const NodalMap& map, const Eigen::VectorXd& f, std::span<const double> x);

/// Largest errors for f = 1 and for f = x: back at the particles, and at many points between the outermost particles.
/// NaN where no such point has a field.
struct Errors {
    std::array<double, 2> at_particles{};
    std::array<double, 2> between{};  ///< where there is a field
    double without_field = 0;         ///< share of those points that feel a node which no particle touches
    double amplification = 0;         ///< largest sum_p |Phi_p| there: by how much errors of particles may grow
};
Errors errors_of(const Picture& picture, const NodalMap& map);

}  // namespace ordo::solvers::mpm

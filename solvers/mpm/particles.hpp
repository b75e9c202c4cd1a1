#pragma once
// The particles: one array a field, and how they are seeded.
#include <array>
#include <vector>

#include "solvers/mpm/grid.hpp"

namespace ordo::solvers::mpm {

/// Local coordinate in (0, 1) and share of the cell's length of each particle along one axis.
struct Seed {
    double xi;
    double share;
};
std::vector<Seed> seeds(Placement placement, int ppc);
/// The same, spread and shifted; not for placement body_centred.
std::vector<Seed> seeds_in_cell(const Options& options, const Resolution& resolution);

/// Distance of a particle along one axis from where the body begins, and the length that it stands for [m].
struct Stretch {
    double distance;
    double length;
};
std::vector<Stretch> along_edge(const Options& options, const Resolution& resolution, double edge);
double count_along_edge(const Options& options, const Resolution& resolution, double edge);  ///< of them

/// visit(distance, length) for each place that one stretch an axis makes, axis 0 fastest.
template <int dim, class Visit>
void for_each_place(const std::array<std::vector<Stretch>, dim>& line, Visit&& visit) {
    std::size_t total = 1;
    for (const auto& stretches : line) total *= stretches.size();
    for (std::size_t k = 0; k < total; ++k) {
        Vec<dim> distance;
        Vec<dim> length;
        std::size_t rest = k;
        for (int axis = 0; axis < dim; ++axis) {
            const Stretch& stretch = line[axis][rest % line[axis].size()];
            rest /= line[axis].size();
            distance[axis] = stretch.distance;
            length[axis] = stretch.length;
        }
        visit(distance, length);
    }
}

/// +1 or -1 along each axis for corner k of a box, axis 0 fastest.
template <int dim>
Vec<dim> corner_signs(int k) {
    Vec<dim> sign;
    for (int axis = 0; axis < dim; ++axis) sign[axis] = (k >> axis & 1) == 0 ? -1 : 1;
    return sign;
}

/// Points that carry mass, momentum and stress to the grid: the particles, or what a reconstruction puts in their
/// place.
template <int dim>
struct Points {
    std::vector<Vec<dim>> X;         ///< position in the undeformed body [m]
    std::vector<Vec<dim>> x;         ///< position now [m]
    std::vector<Vec<dim>> v;         ///< [m/s]
    std::vector<double> m;           ///< [kg]
    std::vector<double> volume;      ///< [m^dim]; of the undeformed body in the total frame
    std::vector<Tensor<dim>> sigma;  ///< Cauchy stress [Pa]

    std::size_t size() const { return x.size(); }
};

/// Arrays that only some choices need are empty with the others.
template <int dim>
struct Particles : Points<dim> {
    std::vector<Tensor<dim>> F;           ///< deformation gradient [-]
    std::vector<Vec<dim>> half;           ///< half edges of the undeformed particle's box [m]
    std::vector<Tensor<dim>> L;           ///< affine velocity field around the particle: its gradient [1/s]
    std::vector<Vec<dim>> corners;        ///< of the particle's box now, 2^dim each, axis 0 fastest [m]
    std::vector<J2Law::History> history;  ///< of a law with memory
    std::vector<Cell<dim>> cell;          ///< where it was found last
};

/// The body filled with particles by the placement chosen, with the scene's velocity (none: at rest) and deformation at
/// t = 0.
/// `with_F`: somebody asks for the deformation gradient.
template <int dim>
Particles<dim> seeded(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution, bool with_F);

}  // namespace ordo::solvers::mpm

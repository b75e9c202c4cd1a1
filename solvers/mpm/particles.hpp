#pragma once
// The particles: one array a field, and how they are seeded.
#include <array>
#include <vector>

#include "solvers/mpm/options.hpp"

namespace ordo::solvers::mpm {

/// Local coordinate in (0, 1) and share of the cell's length of each particle along one axis.
struct Seed {
    double xi;
    double share;
};
std::vector<Seed> seeds(Placement placement, int ppc);

template <int dim>
struct Particles {
    std::vector<Vec<dim>> X;         ///< position in the undeformed body [m]
    std::vector<Vec<dim>> x;         ///< position now [m]
    std::vector<Vec<dim>> v;         ///< [m/s]
    std::vector<double> m;           ///< [kg]
    std::vector<double> volume;      ///< [m^dim]
    std::vector<Tensor<dim>> sigma;  ///< Cauchy stress [Pa]
    std::vector<Tensor<dim>> F;      ///< deformation gradient; empty when nobody asked for strain
    std::vector<int> base;           ///< first node of the particle's cell
    std::vector<Vec<dim>> xi;        ///< local coordinate in that cell

    std::size_t size() const { return x.size(); }
};

/// ppc^dim particles in every cell of the body, at rest stress-free, with the scene's velocity.
template <int dim>
Particles<dim> seeded(const SolidScene<dim>& scene, const Resolution& resolution, Placement placement, bool with_F);

}  // namespace ordo::solvers::mpm

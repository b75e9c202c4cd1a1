#include "solvers/mpm/particles.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace ordo::solvers::mpm {
namespace {

/// Gauss-Legendre points and weights on (0, 1): eigenpairs of the Jacobi matrix of the Legendre recursion.
/// [GolubWelsch1969]
std::vector<Seed> gauss_points(int count) {
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(count);
    Eigen::VectorXd beside(count - 1);
    for (int k = 1; k < count; ++k) beside[k - 1] = k / std::sqrt(4.0 * k * k - 1.0);
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal, beside);
    std::vector<Seed> points;
    for (int k = 0; k < count; ++k) {
        const double first = solver.eigenvectors()(0, k);
        points.push_back({0.5 * (1 + solver.eigenvalues()[k]), first * first});
    }
    return points;
}

}  // namespace

std::vector<Seed> seeds(Placement placement, int ppc) {
    if (placement == Placement::gauss) return gauss_points(ppc);
    std::vector<Seed> points;
    for (int k = 1; k <= ppc; ++k) {
        const double centred = (2.0 * k - 1.0) / (2.0 * ppc);
        const double even = static_cast<double>(k) / (ppc + 1.0);
        points.push_back({placement == Placement::cell_centred ? centred : even, 1.0 / ppc});
    }
    return points;
}

template <int dim>
Particles<dim> seeded(const SolidScene<dim>& scene, const Resolution& resolution, Placement placement, bool with_F) {
    const auto line = seeds(placement, resolution.ppc);
    const double h = resolution.h;
    std::array<long, dim> along{};
    long total = 1;
    for (int axis = 0; axis < dim; ++axis) {
        along[axis] = std::lround((scene.upper[axis] - scene.lower[axis]) / h) * resolution.ppc;
        total *= along[axis];
    }
    Particles<dim> particles;
    for (long p = 0; p < total; ++p) {
        Vec<dim> X;
        double volume = 1;
        long rest = p;
        for (int axis = 0; axis < dim; ++axis) {
            const long k = rest % along[axis];
            rest /= along[axis];
            const Seed& seed = line[static_cast<std::size_t>(k % resolution.ppc)];
            X[axis] = scene.lower[axis] + (static_cast<double>(k / resolution.ppc) + seed.xi) * h;
            volume *= seed.share * h;
        }
        particles.X.push_back(X);
        particles.volume.push_back(volume);
        particles.m.push_back(scene.rho * volume);
    }
    const auto count = static_cast<std::size_t>(total);
    particles.x = particles.X;
    particles.v.assign(count, Vec<dim>::Zero());
    scene.velocity(particles.X, 0.0, particles.v);
    particles.sigma.assign(count, Tensor<dim>::Zero());
    if (with_F) particles.F.assign(count, Tensor<dim>::Identity());
    particles.base.assign(count, -1);
    particles.xi.assign(count, Vec<dim>::Zero());
    return particles;
}

template Particles<1> seeded(const SolidScene<1>&, const Resolution&, Placement, bool);
template Particles<2> seeded(const SolidScene<2>&, const Resolution&, Placement, bool);
template Particles<3> seeded(const SolidScene<3>&, const Resolution&, Placement, bool);

}  // namespace ordo::solvers::mpm

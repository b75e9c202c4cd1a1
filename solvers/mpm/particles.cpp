#include "solvers/mpm/particles.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

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

long cells_along(const Options& options, const Resolution& resolution, double edge) {
    return options.cells_span_grid ? resolution.cells : std::lround(edge / resolution.h);
}

}  // namespace

double count_along_edge(const Options& options, const Resolution& resolution, double edge) {
    return std::round(resolution.ppc * static_cast<double>(cells_along(options, resolution, edge)));
}

std::vector<Stretch> along_edge(const Options& options, const Resolution& resolution, double edge) {
    std::vector<Stretch> line;
    if (options.placement == Placement::body_centred) {
        const double count = count_along_edge(options, resolution, edge);
        for (double k = 0; k < count; ++k) line.push_back({(k + 0.5) / count * edge, edge / count});
    } else {
        const auto cell = seeds_in_cell(options, resolution);
        for (long c = 0; c < cells_along(options, resolution, edge); ++c) {
            for (const auto& [xi, share] : cell)
                line.push_back({(static_cast<double>(c) + xi) * resolution.h, share * resolution.h});
        }
    }
    if (options.volume_of_cell) {
        for (auto& stretch : line) stretch.length = resolution.h / resolution.ppc;
    }
    return line;
}

namespace {

template <int dim>
void place(Particles<dim>& particles, const SolidScene<dim>& scene, const Options& options,
           const Resolution& resolution) {
    std::array<std::vector<Stretch>, dim> line;
    for (int axis = 0; axis < dim; ++axis)
        line[axis] = along_edge(options, resolution, scene.upper[axis] - scene.lower[axis]);
    std::mt19937_64 random;  // the standard says which numbers follow
    for_each_place<dim>(line, [&](const Vec<dim>& distance, const Vec<dim>& length) {
        particles.X.push_back(scene.lower + distance);
        if (resolution.scatter > 0) {
            for (int axis = 0; axis < dim; ++axis) {
                const double part = std::ldexp(static_cast<double>(random() >> 11), -53) - 0.5;
                particles.X.back()[axis] += resolution.scatter * part * length[axis];
            }
        }
        particles.half.push_back(0.5 * length);
        particles.volume.push_back(length.prod());
        particles.m.push_back(scene.rho * particles.volume.back());
    });
}

/// Position, F, stress and volume of a body that starts deformed.
template <int dim>
void deform(Particles<dim>& particles, const SolidScene<dim>& scene, const Options& options) {
    const std::size_t count = particles.size();
    std::vector<Vec<dim>> u(count);
    std::vector<Tensor<dim>> F(count);
    scene.deformed->displacement(particles.X, 0.0, u);
    scene.deformed->F(particles.X, 0.0, F);
    for (std::size_t p = 0; p < count; ++p) {
        particles.x[p] += u[p];
        if (options.frame == Frame::updated) particles.volume[p] *= F[p].determinant();
        std::visit(
            [&]<class L>(const L& law) {
                if constexpr (ClosedLaw<L, dim>) particles.sigma[p] = law.template cauchy<dim>(F[p]);
            },
            scene.law);
    }
    particles.F = std::move(F);
}

template <int dim>
std::vector<Vec<dim>> corners_of(const Particles<dim>& particles, bool undeformed) {
    std::vector<Vec<dim>> corners;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        for (int k = 0; k < 1 << dim; ++k) {
            Vec<dim> to_corner = particles.half[p].cwiseProduct(corner_signs<dim>(k));
            if (!undeformed && !particles.F.empty()) to_corner = particles.F[p] * to_corner;
            corners.push_back((undeformed ? particles.X[p] : particles.x[p]) + to_corner);
        }
    }
    return corners;
}

bool asks_for_F(const Options& options, const Law& law) {
    const bool closed_only = std::holds_alternative<NeoHookeanLaw>(law) || std::holds_alternative<HenckyLaw>(law);
    return options.frame == Frame::total || options.stress_from_F || closed_only || options.basis == Basis::cpgimp ||
           options.basis == Basis::cpdi;
}

}  // namespace

std::vector<Seed> seeds(Placement placement, int ppc) {
    if (placement == Placement::gauss) return gauss_points(ppc);
    std::vector<Seed> points;
    for (int k = 1; k <= ppc; ++k) {
        const double centred = (2.0 * k - 1.0) / (2.0 * ppc);
        const double even = static_cast<double>(k) / (ppc + 1.0);
        points.push_back({placement == Placement::even_interior ? even : centred, 1.0 / ppc});
    }
    return points;
}

std::vector<Seed> seeds_in_cell(const Options& options, const Resolution& resolution) {
    auto points = seeds(options.placement, static_cast<int>(resolution.ppc));
    for (auto& [xi, share] : points) {
        if (resolution.spread != 1) xi = 0.5 + resolution.spread * (xi - 0.5);
        xi += resolution.shift * share;
    }
    return points;
}

template <int dim>
Particles<dim> seeded(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution, bool with_F) {
    Particles<dim> particles;
    place(particles, scene, options, resolution);
    particles.x = particles.X;
    const std::size_t count = particles.X.size();
    particles.v.assign(count, Vec<dim>::Zero());
    if (scene.velocity) scene.velocity(particles.X, 0.0, particles.v);
    particles.sigma.assign(count, Tensor<dim>::Zero());
    particles.cell.assign(count, Cell<dim>::Constant(nowhere));
    if (with_F || asks_for_F(options, scene.law)) particles.F.assign(count, Tensor<dim>::Identity());
    if (scene.deformed) deform(particles, scene, options);
    if (options.affine()) particles.L.assign(count, Tensor<dim>::Zero());
    if (options.basis == Basis::cpdi2) particles.corners = corners_of(particles, options.frame == Frame::total);
    if (std::holds_alternative<J2Law>(scene.law)) particles.history.resize(count);
    return particles;
}

template Particles<1> seeded(const SolidScene<1>&, const Options&, const Resolution&, bool);
template Particles<2> seeded(const SolidScene<2>&, const Options&, const Resolution&, bool);
template Particles<3> seeded(const SolidScene<3>&, const Options&, const Resolution&, bool);

}  // namespace ordo::solvers::mpm

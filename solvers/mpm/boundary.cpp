#include "solvers/mpm/boundary.hpp"

#include <cmath>

#include "solvers/mpm/basis/basis.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::mpm {
namespace {

/// Points of one face, placed as the particles are along its edges, each with its share of the area.
template <int dim>
void add_face(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution, int axis, int side,
              Boundary<dim>& boundary) {
    std::array<std::vector<Stretch>, dim> line;
    for (int other = 0; other < dim; ++other) {
        const double edge = scene.upper[other] - scene.lower[other];
        if (other == axis) line[other] = {{side == 0 ? 0 : edge, 1}};
        else line[other] = along_edge(options, resolution, edge);
    }
    for_each_place<dim>(line, [&](const Vec<dim>& distance, const Vec<dim>& length) {
        boundary.X.push_back(scene.lower + distance);
        boundary.area.push_back(length.prod());
    });
}

template <int dim>
std::size_t nearest(const Particles<dim>& particles, const Vec<dim>& X) {
    std::size_t best = 0;
    for (std::size_t p = 1; p < particles.size(); ++p) {
        if ((particles.X[p] - X).squaredNorm() < (particles.X[best] - X).squaredNorm()) best = p;
    }
    return best;
}

}  // namespace

template <int dim>
Boundary<dim>::Boundary(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution,
                        const Particles<dim>& particles)
    : traction(scene.traction) {
    const bool ends_matter = options.beyond_grid == BeyondGrid::follow;
    for (int axis = 0; axis < dim; ++axis) {
        for (int side = 0; side < 2; ++side) {
            if (ends_matter || (traction && scene.faces[axis][side] == Face::free))
                add_face(scene, options, resolution, axis, side, *this);
        }
    }
    x = X;
    if (scene.deformed && !X.empty()) {
        std::vector<Vec<dim>> u(X.size());
        scene.deformed->displacement(X, 0.0, u);
        for (std::size_t k = 0; k < X.size(); ++k) x[k] += u[k];
    }
    cell.assign(X.size(), Cell<dim>::Constant(nowhere));
    force_.assign(X.size(), Vec<dim>::Zero());
    if (!options.last_particle_loaded) return;
    for (const auto& point : X) particle_.push_back(nearest(particles, point));
}

template <int dim>
void Boundary<dim>::meet_grid(const Grid<dim>& grid, bool total, const Stencils<dim>& of_particles) {
    if (x.empty()) return;
    if (particle_.empty()) {
        const std::span<const Vec<dim>> at = total ? X : x;
        if (fill_at_points<dim>(grid, at, cell, stencils).rows != x.size())
            throw Diverged("a face of the body left the grid");
        return;
    }
    stencils.clear();
    for (const std::size_t p : particle_) {
        of_particles.row(p, [&](int i, double w, const Vec<dim>& grad_w) { stencils.add(i, w, grad_w); });
        stencils.close_row();
    }
}

template <int dim>
Vec<dim> Boundary<dim>::pull(double t, const Grid<dim>& grid, std::vector<Vec<dim>>& out) {
    Vec<dim> total = Vec<dim>::Zero();
    if (!traction) return total;
    (*traction)(X, t, force_);
    for (std::size_t k = 0; k < X.size(); ++k) {
        const Vec<dim> pull = area[k] * force_[k];
        if (!massive_nodes(k, grid, [&](std::size_t i, double w) { out[i] += w * pull; }))
            throw Diverged("a loaded face has lost the particles");
        total += pull;
    }
    return total;
}

template <int dim>
void Boundary<dim>::move(double dt, const Grid<dim>& grid) {
    if (!moves()) return;
    for (std::size_t k = 0; k < x.size(); ++k)
        massive_nodes(k, grid, [&](std::size_t i, double w) { x[k] += dt * w * grid.v[i]; });
}

template <int dim>
template <class Use>
bool Boundary<dim>::massive_nodes(std::size_t k, const Grid<dim>& grid, Use&& use) const {
    const auto each = [&](auto&& visit) {
        stencils.row(k, [&](int i, double w, const Vec<dim>&) {
            if (grid.m[static_cast<std::size_t>(i)] > 0) visit(static_cast<std::size_t>(i), w);
        });
    };
    double sum = 0;
    each([&](std::size_t, double w) { sum += w; });
    if (!(sum > 0)) return false;
    each([&](std::size_t i, double w) { use(i, w / sum); });
    return true;
}

template struct Boundary<1>;
template struct Boundary<2>;
template struct Boundary<3>;

}  // namespace ordo::solvers::mpm

#include "solvers/mpm/reconstruction/reconstruction.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solvers/mpm/basis/basis.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::mpm {
namespace {

using Kind = Reconstruction;

/// Points and weights on (0, 1): Gauss's, or two in each half for the spline.
std::vector<Seed> rule_of(Kind kind) {
    if (kind != Kind::cubic_spline) return seeds(Placement::gauss, kind == Kind::impm ? 1 : kind == Kind::tls ? 2 : 4);
    std::vector<Seed> rule;
    for (const double from : {0.0, 0.5}) {
        for (const auto& [xi, share] : seeds(Placement::gauss, 2)) rule.push_back({from + 0.5 * xi, 0.5 * share});
    }
    return rule;
}

std::span<const double> numbers(std::span<const Vec<1>> f) { return {f.data()->data(), f.size()}; }

}  // namespace

Reconstruction1D::Reconstruction1D(const Options& options) : degree_(options.degree) {
    const Kind kind = options.reconstruction;
    for (const auto& [xi, share] : rule_of(kind)) {
        xi_.push_back(xi);
        weight_.push_back(share);
    }
    if (kind == Kind::impm) {
        degree_ = 1;
        at_nodes_.emplace(1);
    }
    if (kind == Kind::tls) sampler_ = TaylorSampler{};
    else if (kind != Kind::cubic_spline) sampler_ = MovingSampler(degree_);
}

void Reconstruction1D::place(const Grid<1>& grid, const Particles<1>& particles) {
    const auto behind = [](const Vec<1>& a, const Vec<1>& b) { return !(a[0] < b[0]); };
    if (std::ranges::adjacent_find(particles.x, behind) != particles.x.end() || !(grid.h > 0))
        throw Diverged("particles have passed each other");
    if (!std::isfinite(grid.lower[0]) || !std::isfinite(grid.h)) throw Diverged("the body left the grid");
    const std::size_t a_cell = xi_.size();
    const std::size_t count = a_cell * static_cast<std::size_t>(grid.cells[0]);
    points.x.resize(count);
    points.v.resize(count);
    points.m.resize(count);
    points.volume.resize(count);
    points.sigma.resize(count);
    rho_.resize(count);
    stretches_.clear();
    for (std::size_t k = 0; k < count; k += a_cell) {
        const auto cell = static_cast<double>(k / a_cell);
        const double from = grid.lower[0] + cell * grid.h;
        const double to = grid.lower[0] + (cell + 1) * grid.h;
        stretches_.push_back({from, to});
        for (std::size_t i = 0; i < a_cell; ++i) {
            points.x[k + i][0] = from + xi_[i] * (to - from);
            points.volume[k + i] = weight_[i] * (to - from);
        }
    }
    meet(grid);

    // Wide enough for degree + 2 particles on either side of a regular line-up, so that the fit is overdetermined by as
    // much again; two cells for impm, as published.
    const double spacing = grid.h * grid.cells[0] / static_cast<double>(particles.size());
    const double radius = at_nodes_ ? 2 * grid.h : 1.5 * (degree_ + 1.5) * spacing;
    const Layout layout{numbers(particles.x), particles.volume, numbers(points.x)};
    if (auto* spline = std::get_if<SplineSampler>(&sampler_)) spline->prepare(layout);
    if (auto* moving = std::get_if<MovingSampler>(&sampler_)) moving->prepare(layout, radius);
    if (auto* taylor = std::get_if<TaylorSampler>(&sampler_)) taylor->prepare(layout, stretches_);
    if (at_nodes_) {
        nodes_.clear();
        for (int i = 0; i < grid.nodes(); ++i) nodes_.push_back(grid.position(i)[0]);
        node_v.resize(nodes_.size());
        at_nodes_->prepare({numbers(particles.x), particles.volume, nodes_}, radius);
    }

    f_.resize(particles.size());
    for (std::size_t p = 0; p < particles.size(); ++p) f_[p] = particles.m[p] / particles.volume[p];
    sample(f_, rho_);
    for (std::size_t k = 0; k < count; ++k) points.m[k] = rho_[k] * points.volume[k];
    if (at_nodes_ || !std::holds_alternative<MovingSampler>(sampler_)) return;
    const double wanted = std::accumulate(particles.m.begin(), particles.m.end(), 0.0);
    const double scale = wanted / std::accumulate(points.m.begin(), points.m.end(), 0.0);
    for (double& m : points.m) m *= scale;
}

/// Points stand at the same places of every cell: S_ip is found once, on cells of width 1.
void Reconstruction1D::meet(const Grid<1>& grid) {
    if (on_unit_cells_.points() != points.size()) {
        Grid<1> unit = grid;
        unit.fit(0, grid.cells[0]);
        std::vector<Vec<1>> x;
        for (int cell = 0; cell < grid.cells[0]; ++cell) {
            for (const double xi : xi_) x.push_back(Vec<1>(cell + xi));
        }
        std::vector<Cell<1>> cells(x.size(), Cell<1>::Constant(nowhere));
        fill_at_points<1>(unit, std::span<const Vec<1>>(x), cells, on_unit_cells_);
        stencils = on_unit_cells_;
    }
    stencils.take_gradients(on_unit_cells_, grid.h);
}

void Reconstruction1D::sample_velocity(const Particles<1>& particles) {
    if (at_nodes_) at_nodes_->sample(numbers(particles.v), {node_v.data()->data(), node_v.size()});
    else sample_by_mass(particles, particles.v, points.v);
}

void Reconstruction1D::sample_forces(const Particles<1>& particles, std::span<const Vec<1>> force) {
    sample({particles.sigma.data()->data(), particles.size()}, {points.sigma.data()->data(), points.size()});
    b.resize(force.empty() || at_nodes_ ? 0 : points.size());
    if (!b.empty()) sample_by_mass(particles, force, b);
}

/// Density times f is what is sampled, so that sums of m f have a meaning of their own.
void Reconstruction1D::sample_by_mass(const Particles<1>& particles, std::span<const Vec<1>> f,
                                      std::vector<Vec<1>>& out) {
    for (std::size_t p = 0; p < particles.size(); ++p) f_[p] = particles.m[p] / particles.volume[p] * f[p][0];
    sample(f_, {out.data()->data(), out.size()});
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = rho_[k] > 0 ? Vec<1>(out[k] / rho_[k]) : Vec<1>(0.0);
}

void Reconstruction1D::sample(std::span<const double> f, std::span<double> out) {
    std::visit([&](auto& sampler) { sampler.sample(f, out); }, sampler_);
}

}  // namespace ordo::solvers::mpm

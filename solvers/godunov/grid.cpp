// The grid: contents of its cells, what is beyond its ends, and the step. Read godunov.hpp first.
#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "solvers/godunov/godunov.hpp"

namespace ordo::solvers::godunov {
namespace {

using Kind = LineEnd::Kind;

/// The scene's ends, with what a reservoir holds.
std::array<LineEnd, 2> ends_of(const LineScene& scene) {
    auto ends = scene.ends;
    for (std::size_t side = 0; side < 2; ++side) {
        if (ends[side].kind == Kind::reservoir)
            ends[side].outside = side == 0 ? scene.pieces.front() : scene.pieces.back();
    }
    return ends;
}

/// Mean contents of the pieces over a < x < b.
Contents mean_of(const LineScene& scene, double a, double b) {
    Contents sum;
    const auto after = std::upper_bound(scene.edges.begin() + 1, scene.edges.end() - 1, a);
    for (auto k = static_cast<std::size_t>(after - scene.edges.begin()) - 1; k < scene.pieces.size(); ++k) {
        const double from = std::max(a, scene.edges[k]);
        const double to = std::min(b, scene.edges[k + 1]);
        if (from <= a && to >= b) return scene.pieces[k];
        if (to > from) sum += ((to - from) / (b - a)) * scene.pieces[k];
        if (scene.edges[k + 1] >= b) break;
    }
    return sum;
}

Contents absolute(const Contents& q) { return {std::abs(q.mass), std::abs(q.momentum), std::abs(q.energy)}; }

void advance(std::vector<double>& q, const std::vector<double>& through, double step_by_h) {
    for (std::size_t i = 2; i + 2 < q.size(); ++i) q[i] += step_by_h * (through[i - 1] - through[i]);
}

}  // namespace

Grid::Grid(const LineScene& scene, const Options& options, const Resolution& resolution)
    : n_(static_cast<std::size_t>(resolution.cells)),
      from_(scene.edges.front()),
      to_(scene.edges.back()),
      h_(resolution.h),
      medium_(scene.medium),
      options_(options),
      ends_(ends_of(scene)),
      cells_(n_ + 2 * ghosts),
      through_(n_ + 2 * ghosts) {
    for (std::size_t i = 0; i < n_; ++i) cells_.q.set(i + ghosts, mean_of(scene, edge(i), edge(i + 1)));
    fill_ghosts();
}

double Grid::edge(std::size_t i) const { return i == n_ ? to_ : from_ + static_cast<double>(i) * h_; }

double Grid::fastest(double t) {
    const double speed = measure_cells(medium_, cells_);
    if (std::isfinite(speed)) return speed;
    for (std::size_t i = 0; i < n_; ++i) {
        const Flow f = std::visit([&](const auto& kind) { return kind.flow(mean(i)); }, medium_);
        if (!f.physical())
            throw Diverged("the cell at x = " + shortest(0.5 * (edge(i) + edge(i + 1))) + " has the density " +
                           shortest(f.rho) + " and the pressure " + shortest(f.p) + " at t = " + shortest(t));
    }
    throw Diverged("beyond an end of the line is no matter at t = " + shortest(t));
}

void Grid::step(double dt) {
    const double step_by_h = dt / h_;
    if (!options_.second_order) {
        pass_faces(medium_, options_, cells_.q, cells_.q, through_);
    } else {
        reconstruct(medium_, options_.limiter, step_by_h, cells_);
        if (!pass_faces(medium_, options_, cells_.right, cells_.left, through_)) {
            repair(medium_, cells_);
            pass_faces(medium_, options_, cells_.right, cells_.left, through_);
        }
    }
    advance(cells_.q.mass, through_.mass, step_by_h);
    advance(cells_.q.momentum, through_.momentum, step_by_h);
    advance(cells_.q.energy, through_.energy, step_by_h);
    pass_ends(dt);
    fill_ghosts();
}

void Grid::reconstruct_now() {
    measure_cells(medium_, cells_);
    reconstruct(medium_, options_.limiter, 0, cells_);
    repair(medium_, cells_);
}

void Grid::pass_ends(double dt) {
    const Contents in = dt * through_[ghosts - 1];
    const Contents out = dt * through_[ghosts + n_ - 1];
    passed_ += in - out;
    passed_size_ += absolute(in) + absolute(out);
}

void Grid::fill_ghosts() {
    for (std::size_t depth = 0; depth < ghosts; ++depth) {
        cells_.q.set(ghosts - 1 - depth, ghost(0, depth));
        cells_.q.set(ghosts + n_ + depth, ghost(1, depth));
    }
}

Contents Grid::ghost(std::size_t side, std::size_t depth) const {
    const std::size_t beside = side == 0 ? depth : n_ - 1 - depth;
    const std::size_t across = side == 0 ? n_ - 1 - depth : depth;
    switch (ends_[side].kind) {
        case Kind::wall: return {mean(beside).mass, -mean(beside).momentum, mean(beside).energy};
        case Kind::periodic: return mean(across);
        default: return ends_[side].outside;
    }
}

Grid::Balance Grid::balance() const {
    Balance balance{.held = {}, .held_size = {}, .passed = passed_, .passed_size = passed_size_};
    for (std::size_t i = 0; i < n_; ++i) {
        balance.held += h_ * mean(i);
        balance.held_size += h_ * absolute(mean(i));
    }
    return balance;
}

}  // namespace ordo::solvers::godunov

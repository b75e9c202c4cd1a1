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

void advance(std::vector<double>& q, const std::vector<double>& through, double step_by_h, Stretch cells) {
    for (std::size_t i = cells.from; i < cells.to; ++i) q[i] += step_by_h * (through[i - 1] - through[i]);
}

/// The same and one more on each side.
Stretch widened(const Stretch& cells) { return {cells.from - 1, cells.to + 1}; }

/// The faces of cells, or the one where there is none; face i is on the right of cell i.
Stretch faces_of(const Stretch& cells) { return {cells.from - 1, cells.to}; }

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
      through_(n_ + 2 * ghosts),
      active_({ghosts, ghosts + n_}, ghosts, options.second_order ? 2 : 1) {
    for (std::size_t i = 0; i < n_; ++i) cells_.q.set(i + ghosts, mean_of(scene, edge(i), edge(i + 1)));
    fill_ghosts();
    measure_cells(medium_, {0, cells_.q.size()}, cells_);
    if (options.skip_quiet) active_.find(cells_.q);
}

double Grid::edge(std::size_t i) const { return i == n_ ? to_ : from_ + static_cast<double>(i) * h_; }

double Grid::fastest(double t) const {
    double speed = 0;
    for (const Stretch& s :
         active_.stretches()) {  // with one quiet cell on each side, which stands for all up to the next
        const Stretch cells = widened(s);
        const double here = fastest_of(std::span(cells_.speed).subspan(cells.from, cells.size()));
        if (!(here <= speed)) speed = here;
        if (!std::isfinite(here)) refuse(t);
    }
    return speed;
}

/// Throws Diverged, with the place of the first cell that waves cannot run through.
void Grid::refuse(double t) const {
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
    pass(step_by_h);
    for (const Stretch& s : active_.stretches()) {
        advance(cells_.q.mass, through_.mass, step_by_h, s);
        advance(cells_.q.momentum, through_.momentum, step_by_h, s);
        advance(cells_.q.energy, through_.energy, step_by_h, s);
    }
    pass_ends(dt);
    fill_ghosts();
    measure();
}

/// What passes the faces of all stretches.
void Grid::pass(double step_by_h) {
    const auto through = [&](const Columns& before, const Columns& behind) {
        bool matter = true;
        for (const Stretch& s : active_.stretches())
            matter &= pass_faces(medium_, options_, before, behind, faces_of(s), through_);
        return matter;
    };
    if (!options_.second_order) {
        through(cells_.q, cells_.q);
        return;
    }
    for (const Stretch& s : active_.stretches()) reconstruct(medium_, options_.limiter, step_by_h, widened(s), cells_);
    if (through(cells_.right, cells_.left)) return;
    for (const Stretch& s : active_.stretches()) repair(medium_, widened(s), cells_);
    through(cells_.right, cells_.left);
}

/// Of cells that a step has changed what follows from their contents; then which cells the next one can change.
void Grid::measure() {
    for (const Stretch& s : active_.stretches()) measure_cells(medium_, s, cells_);
    measure_cells(medium_, {0, ghosts}, cells_);
    measure_cells(medium_, {ghosts + n_, ghosts + n_ + ghosts}, cells_);
    active_.follow(cells_.q);
}

void Grid::reconstruct_now() {
    const Stretch all{ghosts, ghosts + n_};
    reconstruct(medium_, options_.limiter, 0, widened(all), cells_);
    repair(medium_, widened(all), cells_);
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

#pragma once
// Cells and fronts by number: flat arrays whose slots are used again.
#include "solvers/rrm/line.hpp"

namespace ordo::solvers::rrm {

template <class M>
int Line<M>::add_cell(const State& state, double width) {
    int c = static_cast<int>(cells_.size());
    if (unused_cells_.empty()) {
        cells_.emplace_back();
    } else {
        c = unused_cells_.back();
        unused_cells_.pop_back();
    }
    cell(c) = {state.q, state.f, -1, -1, width};
    return c;
}

template <class M>
int Line<M>::add_front() {
    if (unused_fronts_.empty()) {
        fronts_.emplace_back();
        schedule_.reserve(fronts_.size());
        return static_cast<int>(fronts_.size()) - 1;
    }
    const int f = unused_fronts_.back();
    unused_fronts_.pop_back();
    return f;
}

template <class M>
void Line<M>::release_front(int f) {
    front(f).wraps = false;
    unused_fronts_.push_back(f);
}

/// The end that lies between two neighbours; a reservoir where none does.
template <class M>
LineEnd::Kind Line<M>::end_between(int L, int R) const {
    const int side = side_of(L, R);
    return side < 0 ? LineEnd::Kind::reservoir : ends_[at(side)].kind;
}

/// The pieces of the scene as cells, ghosts beyond the ends, and a front between each two.
template <class M>
void Line<M>::fill(const LineScene& scene) {
    constexpr double without_end = std::numeric_limits<double>::infinity();
    const std::size_t n = scene.pieces.size();
    std::vector<int> line;
    std::vector<double> borders(scene.edges.begin() + 1, scene.edges.end() - 1);
    for (std::size_t i = 0; i < n; ++i) {
        const State state{scene.pieces[i], medium_.flow(scene.pieces[i])};
        const bool outer = (i == 0 && ends_[0].kind == LineEnd::Kind::reservoir) ||
                           (i + 1 == n && ends_[1].kind == LineEnd::Kind::reservoir);
        line.push_back(add_cell(state, outer ? without_end : scene.edges[i + 1] - scene.edges[i]));
    }
    const bool ring = ends_[0].kind == LineEnd::Kind::periodic;
    for (const std::size_t side : {0, 1}) {
        if (ring || ends_[side].kind == LineEnd::Kind::reservoir) continue;
        const Contents& outside = ends_[side].outside;
        const bool prescribed = ends_[side].kind == LineEnd::Kind::prescribed;
        const Contents& q = prescribed ? outside : scene.pieces[side == 0 ? 0 : n - 1];
        ghosts_[side] = add_cell({q, medium_.flow(q)}, without_end);
        line.insert(side == 0 ? line.begin() : line.end(), ghosts_[side]);
        borders.insert(side == 0 ? borders.begin() : borders.end(), bounds_[side]);
    }
    outer_ = {line.front(), line.back()};
    const auto differ = [&](int a, int b) { return options_.keep == Keep::contacts && !(cell(a).q == cell(b).q); };
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        meet(line[i], line[i + 1], borders[i], 0, differ(line[i], line[i + 1]), false);
    if (ring) meet(line.back(), line.front(), bounds_[1], 0, differ(line.back(), line.front()), true);
    for (std::size_t f = 0; f < fronts_.size(); ++f) reschedule(static_cast<int>(f));
}

}  // namespace ordo::solvers::rrm

#pragma once
// Cells and fronts by number: flat arrays whose slots are used again.
#include "solvers/rrm/line.hpp"

namespace ordo::solvers::rrm {

template <class M>
inline int Line<M>::add_cell(const State& state, double width) {
    int c = unused_cell_;
    if (c < 0) {
        c = one_more_cell();
    } else {
        unused_cell_ = cell(c).left;
    }
    cell(c) = {state.q, state.f, -1, -1, width};
    return c;
}

template <class M>
[[gnu::noinline]] int Line<M>::one_more_cell() {
    cells_.emplace_back();
    return static_cast<int>(cells_.size()) - 1;
}

template <class M>
inline int Line<M>::add_front() {
    const int f = unused_front_;
    if (f >= 0) {
        unused_front_ = front(f).left;
        return f;
    }
    return one_more_front();
}

template <class M>
[[gnu::noinline]] int Line<M>::one_more_front() {
    fronts_.emplace_back();
    schedule_.reserve(fronts_.size());
    return static_cast<int>(fronts_.size()) - 1;
}

template <class M>
inline void Line<M>::release_cell(int c) {
    cell(c).left = unused_cell_;
    unused_cell_ = c;
}

template <class M>
inline void Line<M>::release_front(int f) {
    front(f).wraps = false;
    front(f).kind = Front::Kind::unused;
    front(f).left = unused_front_;
    unused_front_ = f;
}

/// A front that is no more, unless its slot is in use again, does not act.
template <class M>
inline void Line<M>::silence(int f) {
    if (front(f).kind == Front::Kind::unused) schedule_.set(f, Schedule::never);
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

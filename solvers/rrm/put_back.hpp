#pragma once
// Put back: new cells, and the fronts between them.
#include <algorithm>

#include "solvers/rrm/line.hpp"

namespace ordo::solvers::rrm {

/// A row of cells between L and R, and a front at each of its borders.
template <class M>
inline void Line<M>::put_back(int L, int R, Row& row, double t, bool wraps) {
    if (prescribes(L, 0)) clip(row, 0, L, R, t);
    if (prescribes(R, 1)) clip(row, 1, R, L, t);
    int before = L;
    for (int i = 0; i < row.n; ++i) {
        meet(before, row.cells[at(i)], row.borders[at(i)], t, row.tags[at(i)], false);
        before = row.cells[at(i)];
    }
    meet(before, R, row.borders[at(row.n)], t, row.tags[at(row.n)], wraps);
    reschedule_from(L, R);
}

/// Where the outside has come in through a prescribed end, it is a cell like others, so that the end stays in place.
template <class M>
[[gnu::noinline]] void Line<M>::fill_up(Row& row, std::size_t side, int ghost) {
    const double place = bounds_[side];
    const double outer = side == 0 ? row.borders[0] : row.borders[at(row.n)];
    const int filled = add_cell({cell(ghost).q, cell(ghost).f}, std::abs(outer - place));
    if (side == 0) {
        std::shift_right(row.cells.begin(), row.cells.end(), 1);
        std::shift_right(row.borders.begin(), row.borders.end(), 1);
        std::shift_right(row.tags.begin(), row.tags.end(), 1);
    }
    const int i = side == 0 ? 0 : row.n;
    row.cells[at(i)] = filled;
    ++row.n;
    const int border = side == 0 ? 0 : row.n;
    row.borders[at(border)] = place;
    row.tags[at(border)] = false;
}

/// At a prescribed end the ghost is put back up to the end's place: what lies beyond it leaves the line.
template <class M>
[[gnu::noinline]] void Line<M>::clip(Row& row, std::size_t side, int ghost, int inner, double t) {
    const bool left = side == 0;
    const double sign = left ? 1 : -1;
    double& outer = left ? row.borders[0] : row.borders[at(row.n)];
    if (sign * (outer - bounds_[side]) > 0) return fill_up(row, side, ghost);
    if (row.n == 0) return;
    const int next = left ? cell(inner).right : cell(inner).left;  // no cell may end beyond its neighbour's core
    double place = bounds_[side];
    if (next >= 0) {
        const Front& f = front(next);
        const double edge = left ? f.x_l + f.S_l * (t - f.t) : f.x_r + f.S_r * (t - f.t);
        place = left ? std::min(place, edge) : std::max(place, edge);
    }
    if (sign * (place - outer) <= 0) return;
    received_ += sign * (place - outer) * cell(ghost).q;
    outer = place;
    while (row.n > 0) {
        const int c = left ? row.cells[0] : row.cells[at(row.n - 1)];
        double& from = left ? row.borders[0] : row.borders[at(row.n)];
        const double to = left ? row.borders[1] : row.borders[at(row.n - 1)];
        const double before = left ? to - cell(c).width : to + cell(c).width;
        if (sign * (to - place) > 0) {
            received_ += -sign * (place - before) * cell(c).q;
            from = place;
            cell(c).width = std::abs(to - place);
            return;
        }
        received_ += -cell(c).width * cell(c).q;
        release_cell(c);
        if (left) {
            std::shift_left(row.cells.begin(), row.cells.end(), 1);
            std::shift_left(row.borders.begin(), row.borders.end(), 1);
            std::shift_left(row.tags.begin(), row.tags.end(), 1);
        }
        --row.n;
    }
    double& last = row.borders[0];
    received_ += -sign * (place - last) * cell(inner).q;
    last = place;
}

/// Whether two cells that meet at (x, t) send waves along; `tagged` where they should, but none were found.
template <class M>
[[gnu::noinline]] bool Line<M>::keeps_waves(int L, int R, double x, double t, bool wraps, bool& tagged) {
    mirror_ghost(L, R);
    const double space = std::min({room(L, x, t, true), room(R, wraps ? x - length_ : x, t, false), length_});
    tagged = worth_keeping(cell(L), cell(R), space);
    return tagged && send_waves(L, R, x, t, wraps, std::min(3 * space, length_));
}

/// Two cells meet at (x, t): waves of no width where keeping them is worth it, else a fresh front.
template <class M>
inline void Line<M>::meet(int L, int R, double x, double t, bool tagged, bool wraps) {
    if (options_.keep == Keep::waves && keeps_waves(L, R, x, t, wraps, tagged)) return;
    const int id = add_front();
    front(id).wraps = wraps;
    start(id, L, R, x, t, tagged);
}

/// Undisturbed width of a cell on one side of x.
template <class M>
double Line<M>::room(int c, double x, double t, bool on_left) const {
    const int next = on_left ? cell(c).left : cell(c).right;
    if (next < 0) return cell(c).width;
    const Front& f = front(next);
    const double edge = on_left ? f.x_r + f.S_r * (t - f.t) + shifted(f, c) : f.x_l + f.S_l * (t - f.t);
    return std::max(0.0, on_left ? x - edge : edge - x);
}

}  // namespace ordo::solvers::rrm

#pragma once
// The line at one time: as it is shown, and as it is counted.
#include "solvers/rrm/line.hpp"

namespace ordo::solvers::rrm {

/// Cores as they are and open fronts flattened, from left to right, in the frame of the first cell. Nothing changes.
template <class M>
std::vector<typename Line<M>::Stretch> Line<M>::stretches(double t) const {
    std::vector<Stretch> line;
    const auto edges = reach(t);
    const int first = first_cell();
    const auto show_front = [&](const Front& f) {
        if (f.kind == Front::Kind::kept || !(f.width() > 0)) return;
        const Flattened put = flattened(f);
        const double middle = put.count == 2 ? put.x : f.x_r;
        line.push_back({f.x_l, middle, put.states[0], 0, {}});
        if (put.count == 2) line.push_back({middle, f.x_r, put.states[1], 0, {}});
    };
    double from = edges[0];
    for (int c = first;;) {
        const bool hidden =
            (is_ghost(c, 0) || is_ghost(c, 1)) && ends_[is_ghost(c, 0) ? 0 : 1].kind != LineEnd::Kind::prescribed;
        const int next = cell(c).right;
        Front f{};
        if (next >= 0) bring(f = front(next), t);
        const double to = next >= 0 ? f.x_l : edges[1];
        if (!hidden && to > from)
            line.push_back({from, to, {cell(c).q, cell(c).f}, next >= 0 ? spreading(f) : 0, {f.x_0, f.t_0}});
        if (next < 0) return line;
        show_front(f);
        if (f.wraps) return line;
        from = f.x_r;
        c = f.right;
    }
}

/// -1 or 1 for a kept jump of a fan, by the side it runs to; 0 for other fronts.
template <class M>
int Line<M>::spreading(const Front& f) const {
    if (f.kind != Front::Kind::kept) return 0;
    const Flow& l = cell(f.left).f;
    const Flow& r = cell(f.right).f;
    const double relative = f.S_l - 0.5 * (l.v + r.v);
    const double a = std::min(l.a, r.a);
    if (std::abs(relative) < 0.1 * a) return 0;
    const int side = relative > 0 ? 1 : -1;
    return r.v + side * r.a - (l.v + side * l.a) > 1e-9 * a ? side : 0;
}

/// A fan's jumps as one continuous ramp: each uniform cell of it holds its state at one place only, which parts it in
/// the ratio of the jumps at its two sides, and the fields rise linearly between two such places. Contents stay.
template <class M>
std::vector<Piece> Line<M>::pieces(double t) const {
    const std::vector<Stretch> line = stretches(t);
    const std::size_t n = line.size();
    const auto rise = [&](std::size_t i) { return std::abs(line[i + 1].state.f.v - line[i].state.f.v); };
    const auto fan_at = [&](std::size_t i) { return i + 1 < n ? line[i].fan : 0; };  // between i and i + 1
    const auto width = [&](std::size_t i) { return line[i].to - line[i].from; };
    const auto between = [&](std::size_t i) { return i > 0 && fan_at(i) != 0 && fan_at(i) == fan_at(i - 1); };
    // of one fan: its jumps were born together, or it is about as wide as its neighbours; a plateau between fans is not
    const auto inside = [&](std::size_t i) {
        if (!between(i)) return false;
        constexpr double much_wider = 3;
        return line[i].birth == line[i - 1].birth || (between(i - 1) && width(i) < much_wider * width(i - 1)) ||
               (between(i + 1) && width(i) < much_wider * width(i + 1));
    };
    const auto node = [&](std::size_t i) {
        return (line[i].from * rise(i) + line[i].to * rise(i - 1)) / (rise(i - 1) + rise(i));
    };
    const auto middle = [&](std::size_t i) { return 0.5 * (line[i].from + line[i].to); };
    // where the ramp over the jump between i and i + 1 begins and ends: at the edges of a fan as far out as in, but not
    // beyond the middle of the outer cell; a lone jump stays one
    const auto begin = [&](std::size_t i) {
        if (fan_at(i) == 0) return line[i].to;
        if (inside(i)) return node(i);
        return inside(i + 1) ? std::max(middle(i), 2 * line[i].to - node(i + 1)) : line[i].to;
    };
    const auto end = [&](std::size_t i) {
        if (fan_at(i) == 0) return line[i].to;
        if (inside(i + 1)) return node(i + 1);
        return inside(i) ? std::min(middle(i + 1), 2 * line[i].to - node(i)) : line[i].to;
    };
    std::vector<Piece> shown;
    double from = n > 0 ? line[0].from : 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double to = i + 1 < n ? begin(i) : line[i].to;
        if (to > from) shown.push_back({from, to, line[i].state.q, line[i].state.q, line[i].state.q});
        if (i + 1 == n) break;
        from = end(i);
        if (!(from > to)) continue;
        const Contents both = (line[i].to - to) * line[i].state.q + (from - line[i].to) * line[i + 1].state.q;
        shown.push_back({to, from, (1 / (from - to)) * both, line[i].state.q, line[i + 1].state.q});
    }
    return shown;
}

/// The leftmost cell; of a ring the one behind the front that wraps.
template <class M>
int Line<M>::first_cell() const {
    if (ends_[0].kind != LineEnd::Kind::periodic) return outer_[0];
    for (std::size_t f = 0; f < fronts_.size(); ++f) {
        if (fronts_[f].wraps && cell(fronts_[f].right).left == static_cast<int>(f)) return fronts_[f].right;
    }
    return outer_[0];
}

/// The places between which contents are counted: walls, free ends; elsewhere what no wave has reached by t.
template <class M>
std::array<double, 2> Line<M>::reach(double t) const {
    std::array<double, 2> places = bounds_;
    const int first = first_cell();
    if (ends_[0].kind == LineEnd::Kind::periodic) {
        Front f = front(cell(first).left);
        bring(f, t);
        return {f.x_r - length_, f.x_r};
    }
    for (const std::size_t side : {0, 1}) {
        const int id = side == 0 ? cell(outer_[0]).right : cell(outer_[1]).left;
        if (id < 0) continue;
        Front f = front(id);
        bring(f, t);
        const double edge = side == 0 ? f.x_l : f.x_r;
        if (lies_at(f, side) && one_sided(f)) places[side] = edge;
        else places[side] = side == 0 ? std::min(places[0], edge) - length_ : std::max(places[1], edge) + length_;
    }
    return places;
}

/// What has come in through those places since t = 0: flow of the states out there, and the push of walls.
template <class M>
Contents Line<M>::received(double t) const {
    Contents sum = received_;
    if (ends_[0].kind == LineEnd::Kind::periodic) return sum;
    for (const std::size_t side : {0, 1}) {
        const int c = outer_[side];
        const int id = side == 0 ? cell(c).right : cell(c).left;
        if (id >= 0 && lies_at(front(id), side)) {
            Front f = front(id);
            sum += passed_end(f, t);
            bring(f, t);
            sum += owed_by_wall(f);
            if (one_sided(f)) continue;
        }
        sum += (side == 0 ? t : -t) * flux(cell(c).q, cell(c).f);
    }
    return sum;
}

}  // namespace ordo::solvers::rrm

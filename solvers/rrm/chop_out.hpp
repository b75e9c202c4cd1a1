#pragma once
// Chop out: which interval is taken out of the line.
#include <utility>

#include "solvers/rrm/line.hpp"

namespace ordo::solvers::rrm {

/// On to t with the contents that came in, and with the moments that the metric needs where they are asked for; a fresh
/// front with moments is an open one from then on. What is swept is counted by the edges as they are, round-off and
/// all. Nothing comes in through a wall or a free end.
template <class M>
template <bool with_moments>
inline void Line<M>::bring(Front& f, double t) const {
    const double tau = t - f.t;
    const double x_l = f.x_l + f.S_l * tau;
    const double x_r = f.x_r + f.S_r * tau;
    if (f.kind != Front::Kind::kept) {
        const Cell& l = cell(f.left);
        const Cell& r = cell(f.right);
        const double t_l = takes_from_left(f) ? tau : 0;
        const double t_r = takes_from_right(f) ? tau : 0;
        const double w_l = takes_from_left(f) ? l.f.v * tau - (x_l - f.x_l) : 0;
        const double w_r = takes_from_right(f) ? (x_r - f.x_r) - r.f.v * tau : 0;
        const Contents from_l = swept(l, w_l, l.f.p * t_l);
        const Contents from_r = swept(r, w_r, -r.f.p * t_r);
        f.l.content += f.tagged ? from_l : from_l + from_r;
        if (f.tagged) f.r.content += from_r;
        if constexpr (with_moments) {
            f.kind = Front::Kind::open;
            if (f.tagged) {
                sweep(f.l, w_l, watched_of(l.f), f.base, watched);
                sweep(f.r, w_r, watched_of(r.f), f.base, watched);
            } else {
                sweep(f.l, w_l, w_r, watched_of(l.f), watched_of(r.f), f.base, watched);
            }
        }
    }
    f.x_l = x_l;
    f.x_r = x_r;
    f.x_c += f.v_c * tau;
    f.t = t;
}

/// What passed a kept front at an end since its time: the push of a wall; at a prescribed end the inner flow in place
/// of the outer one.
template <class M>
Contents Line<M>::passed_end(const Front& f, double t) const {
    if (f.kind != Front::Kind::kept || f.end == LineEnd::Kind::reservoir || f.end == LineEnd::Kind::free) return {};
    const std::size_t side = end_of(f);
    const double tau = side == 0 ? t - f.t : f.t - t;
    const Cell& inner = cell(side == 0 ? f.right : f.left);
    if (f.end == LineEnd::Kind::wall) return tau * Contents{0, inner.f.p, inner.f.p * ends_[side].velocity};
    const Cell& ghost = cell(ghosts_[side]);
    return tau * (flux(inner.q, inner.f) - flux(ghost.q, ghost.f));
}

/// The push of a wall that an open front has not passed on yet: what brings its contents to the wall's velocity.
template <class M>
Contents Line<M>::owed_by_wall(const Front& f) const {
    if (f.end != LineEnd::Kind::wall || f.kind == Front::Kind::kept) return {};
    const Contents total = f.content();
    const double push = total.mass * f.v_c - total.momentum;
    return {0, push, push * f.v_c};
}

/// A front has changed as much as it may.
template <class M>
[[gnu::flatten]] void Line<M>::chop_out(int id, double t) {
    ++counts_.chop_outs;
    Front& f = front(id);
    bring(f, t);
    const int L = f.left;
    const int R = f.right;
    const bool wraps = f.wraps;
    Row row;
    add_flattened(row, f);
    release_front(id);
    put_back(L, R, row, t, wraps);
    silence(id);
}

/// A cell's core is used up, so that its two fronts meet: they unite, or both are chopped out.
template <class M>
void Line<M>::use_up(int c, double t) {
    const int i1 = cell(c).left;
    const int i2 = cell(c).right;
    if (i1 == i2) return chop_out(i1, t);  // the only cell of a ring
    for (const int id : {i1, i2}) {
        if (front(id).kind == Front::Kind::kept) received_ += passed_end(front(id), t);
        bring<true>(front(id), t);
    }
    if (front(i1).wraps) {  // both in the frame of the left one
        for (double* x : {&front(i2).x_l, &front(i2).x_r, &front(i2).x_c, &front(i2).x_0}) *x += length_;
    }
    share_rest(front(i1), front(i2), cell(c).q);
    if (!unite(c, t)) chop_both(c, t);
}

/// What round-off leaves between two fronts that meet goes to both, or to the one that is not kept.
template <class M>
void Line<M>::share_rest(Front& f1, Front& f2, const Contents& q) const {
    const double rest = f2.x_l - f1.x_r;
    const bool to_1 = f1.kind != Front::Kind::kept;
    const bool to_2 = f2.kind != Front::Kind::kept;
    const double x = to_1 == to_2 ? 0.5 * (f1.x_r + f2.x_l) : to_1 ? f2.x_l : f1.x_r;
    const double share = to_1 == to_2 ? 0.5 * rest : rest;
    if (to_1) (f1.tagged ? f1.r : f1.l).content += share * q;
    if (to_2) f2.l.content += share * q;
    f1.x_r = f2.x_l = x;
}

/// No contact any more.
template <class M>
void Line<M>::untag(Front& f) const {
    f.tagged = false;
    add(f.l, f.base, f.r, f.base, watched);
}

/// Both fronts as one, where that costs no more than is allowed; true where they could. Fronts of no width always
/// unite, for several events at one time are the rule in linear elasticity. What lies beyond a contact stays beyond it.
template <class M>
[[gnu::flatten]] bool Line<M>::unite(int c, double t) {
    const int i1 = cell(c).left;
    const int i2 = cell(c).right;
    Front& f1 = front(i1);
    Front& f2 = front(i2);
    if (f1.kind == Front::Kind::kept || f2.kind == Front::Kind::kept) return false;
    const double tiny = 1e-9 * (f1.width() + f2.width() + std::min(cell(c).width, length_));
    const bool no_width = f1.width() <= tiny || f2.width() <= tiny;
    const bool end1 = f1.end != LineEnd::Kind::reservoir;
    const bool end2 = f2.end != LineEnd::Kind::reservoir;
    if (no_width && (f1.tagged || end1) && (f2.tagged || end2)) {  // a contact gives way to an end, or to a wider one
        Front& gives_way = end1 ? f2 : end2 || f1.width() < f2.width() ? f1 : f2;
        if (gives_way.tagged) untag(gives_way);
    }
    const bool held1 = f1.tagged || end1;
    const bool held2 = f2.tagged || end2;
    if (held1 && held2) return false;
    const bool rightwards = held2 || (!held1 && f2.width() > f1.width());
    Front& into = rightwards ? f2 : f1;
    const Front& from = rightwards ? f1 : f2;
    const bool beyond = into.tagged && !rightwards;
    Side grown = beyond ? into.r : into.l;
    add(grown, into.base, from.l, from.base, watched);
    if (!no_width && too_much(into, grown, beyond ? into.l : into.r)) return false;
    ++counts_.unions;
    (beyond ? into.r : into.l) = grown;
    into.left = f1.left;
    into.x_l = f1.x_l;
    into.right = f2.right;
    into.x_r = f2.x_r;
    into.wraps = f1.wraps || f2.wraps;
    release_cell(c);
    const auto [id, gone] = rightwards ? std::pair{i2, i1} : std::pair{i1, i2};
    release_front(gone);
    silence(gone);
    cell(into.left).right = id;
    cell(into.right).left = id;
    const Cell& l = cell(into.left);
    const Cell& r = cell(into.right);
    set_speeds(into, l.f, r.f);
    into.t_chop = t + open_until(into, watched_of(l.f), watched_of(r.f));
    if (l.left >= 0) reschedule(l.left);
    reschedule(id);
    return true;
}

/// Both are flattened by themselves. A kept wave has no contents and is met anew.
template <class M>
[[gnu::flatten]] void Line<M>::chop_both(int c, double t) {
    const int i1 = cell(c).left;
    const int i2 = cell(c).right;
    const int L = front(i1).left;
    const int R = front(i2).right;
    const bool wraps = front(i1).wraps || front(i2).wraps;
    Row row;
    row.borders[0] = front(i1).x_r;
    for (const int id : {i1, i2}) {
        const Front& f = front(id);
        if (f.kind == Front::Kind::kept || !(f.width() > 0 && f.content().mass > 0)) continue;
        ++counts_.chop_outs;
        add_flattened(row, f);
    }
    release_front(i1);
    release_front(i2);
    release_cell(c);
    put_back(L, R, row, t, wraps);
    silence(i1);
    silence(i2);
}

}  // namespace ordo::solvers::rrm

#pragma once
// Chop out: which interval is taken out of the line.
#include "solvers/rrm/line.hpp"

namespace ordo::solvers::rrm {

/// On to t: edges, contact and contents. Nothing comes in through a wall or a free end.
template <class M>
void Line<M>::bring(Front& f, double t) const {
    const double tau = t - f.t;
    if (f.kind != Front::Kind::kept) {
        const Cell& L = cell(f.left);
        const Cell& R = cell(f.right);
        if (takes_from_left(f)) f.l.content += (L.f.v - f.S_l) * tau * L.q + tau * Contents{0, L.f.p, L.f.p * L.f.v};
        if (takes_from_right(f)) f.r.content += (f.S_r - R.f.v) * tau * R.q - tau * Contents{0, R.f.p, R.f.p * R.f.v};
    }
    f.x_l += f.S_l * tau;
    f.x_r += f.S_r * tau;
    f.x_c += f.v_c * tau;
    f.t = t;
}

/// The same with what the metric needs; a fresh front is an open one from then on.
template <class M>
void Line<M>::bring_with_moments(Front& f, double t) const {
    if (f.kind == Front::Kind::kept) return bring(f, t);
    const double tau = t - f.t;
    const Cell& L = cell(f.left);
    const Cell& R = cell(f.right);
    if (f.kind == Front::Kind::fresh) {
        f.kind = Front::Kind::open;
        f.base = watched_of(takes_from_left(f) ? L.f : R.f);
        if (f.end == LineEnd::Kind::wall) f.base[1] = f.v_c;
        if (f.end == LineEnd::Kind::free) f.base[2] = 0;
        f.l = f.r = Side{};
    }
    if (takes_from_left(f)) sweep(f.l, (L.f.v - f.S_l) * tau, watched_of(L.f), f.base, watched);
    if (takes_from_right(f)) sweep(f.r, (f.S_r - R.f.v) * tau, watched_of(R.f), f.base, watched);
    bring(f, t);
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
void Line<M>::chop_out(int id, double t) {
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
}

/// A cell's core is used up, so that its two fronts meet: they unite, or both are chopped out.
template <class M>
void Line<M>::use_up(int c, double t) {
    const int i1 = cell(c).left;
    const int i2 = cell(c).right;
    if (i1 == i2) return chop_out(i1, t);  // the only cell of a ring
    received_ += passed_end(front(i1), t) + passed_end(front(i2), t);
    bring_with_moments(front(i1), t);
    bring_with_moments(front(i2), t);
    if (front(i1).wraps) {  // both in the frame of the left one
        for (double* x : {&front(i2).x_l, &front(i2).x_r, &front(i2).x_c, &front(i2).x_0}) *x += length_;
    }
    if (!unite(c, t)) chop_both(c, t);
}

/// Both fronts as one, where that costs no more than is allowed; true where they could. Fronts of no width always
/// unite, for several events at one time are the rule in linear elasticity.
template <class M>
bool Line<M>::unite(int c, double t) {
    const int i1 = cell(c).left;
    const int i2 = cell(c).right;
    Front& f1 = front(i1);
    Front& f2 = front(i2);
    if (f1.kind == Front::Kind::kept || f2.kind == Front::Kind::kept) return false;
    const double tiny = 1e-9 * (f1.width() + f2.width() + std::min(cell(c).width, length_));
    const bool no_width = f1.width() <= tiny || f2.width() <= tiny;
    if (no_width && f1.tagged && f2.tagged) (f1.width() <= tiny ? f1 : f2).tagged = false;
    const bool held1 = f1.tagged || f1.end != LineEnd::Kind::reservoir;
    const bool held2 = f2.tagged || f2.end != LineEnd::Kind::reservoir;
    if (held1 && held2) return false;
    Front both = united(f1, f2);
    if (!no_width && excess(both) > 1) return false;
    ++counts_.unions;
    release_cell(c);
    release_front(i2);
    set_speeds(both);
    both.t_chop = t + open_until(both);
    front(i1) = both;
    cell(both.right).left = i1;
    if (cell(both.left).left >= 0) reschedule(cell(both.left).left);
    reschedule(i1);
    return true;
}

/// The contents and moments of both; what lies beyond the tagged one's contact stays beyond it.
template <class M>
Front Line<M>::united(const Front& f1, const Front& f2) const {
    Front both = f1;
    both.right = f2.right;
    both.x_r = f2.x_r;
    both.wraps = f1.wraps || f2.wraps;
    Side l = f2.l;
    Side r = f2.r;
    const bool to_right = f2.tagged || f2.end != LineEnd::Kind::reservoir;  // then f2's base and contact hold
    Watched shift;
    for (std::size_t k = 0; k < watched; ++k) shift[k] = f2.base[k] - f1.base[k];
    if (to_right) {
        for (double& s : shift) s = -s;
        rebase(both.l, shift, watched);
        rebase(both.r, shift, watched);
        both.base = f2.base;
        both.tagged = f2.tagged;
        both.end = f2.end;
        both.x_0 = f2.x_0;
        both.t_0 = f2.t_0;
        both.x_c = f2.x_c;
        add(both.l, both.r, watched);
        add(both.l, l, watched);
        both.r = r;
    } else {
        rebase(l, shift, watched);
        rebase(r, shift, watched);
        add(both.r, l, watched);
        add(both.r, r, watched);
    }
    return both;
}

/// Both are flattened by themselves. A kept wave has no contents and is met anew.
template <class M>
void Line<M>::chop_both(int c, double t) {
    const int i1 = cell(c).left;
    const int i2 = cell(c).right;
    const int L = front(i1).left;
    const int R = front(i2).right;
    const bool wraps = front(i1).wraps || front(i2).wraps;
    Row row;
    row.borders[0] = front(i1).x_r;
    for (const int id : {i1, i2}) {
        const Front& f = front(id);
        if (f.kind == Front::Kind::kept || !(f.width() > 0)) continue;
        ++counts_.chop_outs;
        add_flattened(row, f);
    }
    release_front(i1);
    release_front(i2);
    release_cell(c);
    put_back(L, R, row, t, wraps);
}

}  // namespace ordo::solvers::rrm

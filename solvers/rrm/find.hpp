#pragma once
// Find: when is which front active.
#include "solvers/rrm/line.hpp"

namespace ordo::solvers::rrm {

/// Signal speeds: both edges of a front, or the inner one where the other lies at a wall or a free end.
template <class M>
void Line<M>::set_speeds(Front& f) const {
    const Flow& l = cell(f.left).f;
    const Flow& r = cell(f.right).f;
    const bool davis = options_.speeds == Speeds::davis;
    f.S_l = davis ? std::min(l.v - l.a, r.v - r.a) : l.v - l.a;
    f.S_r = davis ? std::max(l.v + l.a, r.v + r.a) : r.v + r.a;
    if (f.kind == Front::Kind::open && f.width() > 0) {
        const Flow flat = medium_.flow((1 / f.width()) * f.content());
        if (flat.physical()) {
            f.S_l = std::min(f.S_l, flat.v - flat.a);
            f.S_r = std::max(f.S_r, flat.v + flat.a);
        }
    }
    f.v_c = 0;
    if (!f.tagged && f.end == LineEnd::Kind::reservoir) return;
    const std::size_t side = end_of(f);
    const Contents total = f.content();
    const double from_left = l.rho * (l.v - f.S_l);
    const double from_right = r.rho * (f.S_r - r.v);
    if (f.kind == Front::Kind::open && total.mass > 0) f.v_c = total.momentum / total.mass;
    else if (f.end == LineEnd::Kind::free) f.v_c = side == 0 ? r.v - r.p / from_right : l.v + l.p / from_left;
    else f.v_c = (from_left * l.v + from_right * r.v + l.p - r.p) / (from_left + from_right);
    if (!one_sided(f)) return;
    if (f.end == LineEnd::Kind::wall) f.v_c = ends_[side].velocity;
    (side == 0 ? f.S_l : f.S_r) = f.v_c;
}

/// A wall mirrors the cell before it, in its own frame; beyond a free end is the same without pressure.
template <class M>
void Line<M>::mirror_ghost(int L, int R) {
    const LineEnd::Kind kind = end_between(L, R);
    if (kind != LineEnd::Kind::wall && kind != LineEnd::Kind::free) return;
    const std::size_t side = is_ghost(L, 0) ? 0 : 1;
    Cell& ghost = cell(side == 0 ? L : R);
    const Cell& inner = cell(side == 0 ? R : L);
    ghost.q = inner.q;
    ghost.f = inner.f;
    if (kind == LineEnd::Kind::free) {
        ghost.f.p = 0;
        return;
    }
    const double v = inner.f.v;
    ghost.f.v = 2 * ends_[side].velocity - v;
    ghost.q.momentum = ghost.f.rho * ghost.f.v;
    ghost.q.energy += 0.5 * ghost.f.rho * (ghost.f.v * ghost.f.v - v * v);
}

/// A fresh front between two cells.
template <class M>
void Line<M>::start(int id, int L, int R, double x, double t, bool tagged) {
    Front& f = front(id);
    f.kind = Front::Kind::fresh;
    f.left = L;
    f.right = R;
    f.tagged = tagged;
    f.end = end_between(L, R);
    f.t = f.t_0 = t;
    f.x_l = f.x_r = f.x_0 = f.x_c = x;
    f.l.content = f.r.content = {};
    cell(L).right = id;
    cell(R).left = id;
    mirror_ghost(L, R);
    set_speeds(f);
    f.t_chop = t + fresh_until(f);
}

/// Two uniform pieces have the flattening error sqrt(w_l w_r) |difference|; a tagged front keeps density and
/// temperature apart. At a wall the velocity has its mirror image, at a free end the pressure: |difference| / 2 of the
/// half that is.
template <class M>
double Line<M>::fresh_until(const Front& f) const {
    const Watched l = watched_of(cell(f.left).f);
    const Watched r = watched_of(cell(f.right).f);
    const double w_l = l[1] - f.S_l;
    const double w_r = f.S_r - r[1];
    double rate = 0;
    if (one_sided(f)) {
        const double w = takes_from_right(f) ? w_r : w_l;
        const Watched& inner = takes_from_right(f) ? r : l;
        rate = f.end == LineEnd::Kind::wall ? w * std::abs(inner[1] - f.v_c) / options_.allowed[1]
                                            : w * std::abs(inner[2]) / options_.allowed[2];
    } else {
        for (std::size_t k = f.tagged ? 1 : 0; k < (f.tagged ? 3 : watched); ++k)
            rate = std::max(rate, std::abs(l[k] - r[k]) / options_.allowed[k]);
        rate *= std::sqrt(w_l * w_r);
    }
    return rate > 0 ? 1 / rate : Schedule::never;
}

/// The moments that flattening would even out: at a wall or a free end those of an odd field, about its value there.
template <class M>
Moments Line<M>::watched_moments(const Front& f, std::size_t k) const {
    Moments both = moments(f.l, k) + moments(f.r, k);
    if ((f.end == LineEnd::Kind::wall && k == 1) || (f.end == LineEnd::Kind::free && k == 2)) both.s = 0;
    return both;
}

/// The largest flattening error that an open front has, in units of what is allowed, squared.
template <class M>
double Line<M>::excess(const Front& f) const {
    double worst = 0;
    for (std::size_t k = 0; k < watched; ++k) {
        double error = watched_moments(f, k).square();
        if (f.tagged && (k == 0 || k == 3)) {
            const double sum = std::sqrt(moments(f.l, k).square()) + std::sqrt(moments(f.r, k).square());
            error = sum * sum;
        }
        worst = std::max(worst, error / (options_.allowed[k] * options_.allowed[k]));
    }
    return worst;
}

/// How long until an open front has changed as much as it may.
template <class M>
double Line<M>::open_until(const Front& f) const {
    const Watched l = watched_of(cell(f.left).f);
    const Watched r = watched_of(cell(f.right).f);
    double until = Schedule::never;
    for (std::size_t k = 0; k < watched; ++k) {
        const double allowed = options_.allowed[k];
        const Moments from_l = piece(takes_from_left(f) ? l[1] - f.S_l : 0, l[k] - f.base[k]);
        const Moments from_r = piece(takes_from_right(f) ? f.S_r - r[1] : 0, r[k] - f.base[k]);
        if (f.tagged && (k == 0 || k == 3)) {
            until = std::min(
                {until, time_until(moments(f.l, k), from_l, allowed), time_until(moments(f.r, k), from_r, allowed)});
        } else {
            Moments rate = from_l + from_r;
            const Moments now = watched_moments(f, k);
            if ((f.end == LineEnd::Kind::wall && k == 1) || (f.end == LineEnd::Kind::free && k == 2)) rate.s = 0;
            until = std::min(until, time_until(now, rate, allowed));
        }
    }
    return until;
}

/// When the core of a front's right cell will be used up, and the earlier of that and its chop-out.
template <class M>
void Line<M>::reschedule(int id) {
    Front& f = front(id);
    f.t_vanish = Schedule::never;
    const int next = cell(f.right).right;
    if (next >= 0 && f.right != ghosts_[1]) {
        const Front& g = front(next);
        const double t = std::max(f.t, g.t);
        const double gap = (g.x_l + g.S_l * (t - g.t)) - (f.x_r + f.S_r * (t - f.t) + shifted(f, f.right));
        const double closing = f.S_r - g.S_l;
        if (closing > 0) f.t_vanish = t + std::max(0.0, gap) / closing;
    }
    schedule_.set(id, std::min(f.t_chop, f.t_vanish));
}

/// All fronts from that before L to that before R.
template <class M>
void Line<M>::reschedule_from(int L, int R) {
    if (cell(L).left >= 0) reschedule(cell(L).left);
    for (int c = L;;) {
        const int f = cell(c).right;
        reschedule(f);
        c = front(f).right;
        if (c == R) return;
    }
}

}  // namespace ordo::solvers::rrm

#pragma once
// Find: when is which front active.
#include "solvers/rrm/line.hpp"

namespace ordo::solvers::rrm {

/// Signal speeds: both edges of a front, or the inner one where the other lies at a wall or a free end.
template <class M>
inline void Line<M>::set_speeds(Front& f, const Flow& l, const Flow& r) const {
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
    if (f.tagged || f.end != LineEnd::Kind::reservoir) set_contact_speed(f, l, r);
}

/// The speed of a contact, or of the end of the line that a front lies at.
template <class M>
[[gnu::noinline]] void Line<M>::set_contact_speed(Front& f, const Flow& l, const Flow& r) const {
    const std::size_t side = end_of(f);
    if (f.end == LineEnd::Kind::free) hurry_release(f, side);
    const Contents total = f.content();
    const double from_left = l.rho * (l.v - f.S_l);
    const double from_right = r.rho * (f.S_r - r.v);
    if (f.kind == Front::Kind::open && total.mass > 0) f.v_c = total.momentum / total.mass;
    else if (f.end == LineEnd::Kind::free) f.v_c = side == 0 ? r.v - r.p / from_right : l.v + l.p / from_left;
    else f.v_c = ((from_left * l.v + from_right * r.v) + (l.p - r.p)) / (from_left + from_right);
    if (!one_sided(f)) return;
    if (f.end == LineEnd::Kind::wall) f.v_c = ends_[side].velocity;
    (side == 0 ? f.S_l : f.S_r) = f.v_c;
}

/// A stretched line that is let go sends a shock, which outruns the sound of what lies before it.
template <class M>
void Line<M>::hurry_release(Front& f, std::size_t side) const {
    const Cell& inner = cell(side == 0 ? f.right : f.left);
    if (!(inner.f.p < 0)) return;
    const Toward inwards = side == 0 ? Toward::right : Toward::left;
    const State state{inner.q, inner.f};
    const auto wave = released(medium_, state, inwards, {first_strength(medium_, inner.f, -inner.f.p), 1});
    if (!wave) return;
    const double speed = through_wave(medium_, state, *wave, inwards).speed;
    if (side == 0) f.S_r = std::max(f.S_r, speed);
    else f.S_l = std::min(f.S_l, speed);
}

/// A wall mirrors the cell before it, in its own frame; beyond a free end is the same without pressure.
template <class M>
[[gnu::noinline]] void Line<M>::mirror_ghost(int L, int R) {
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
inline void Line<M>::start(int id, int L, int R, double x, double t, bool tagged) {
    Front& f = front(id);
    f.kind = Front::Kind::fresh;
    f.left = L;
    f.right = R;
    f.tagged = tagged;
    f.end = end_between(L, R);
    f.t = f.t_0 = t;
    f.x_l = f.x_r = f.x_0 = f.x_c = x;
    f.l.clear();
    if (tagged) f.r.clear();
    cell(L).right = id;
    cell(R).left = id;
    if (f.end != LineEnd::Kind::reservoir) mirror_ghost(L, R);
    const Flow& l = cell(L).f;
    const Flow& r = cell(R).f;
    set_speeds(f, l, r);
    const Watched a = watched_of(l);
    const Watched b = watched_of(r);
    for (std::size_t k = 0; k < watched; ++k) f.base[k] = 0.5 * (a[k] + b[k]);
    f.t_chop = t + (one_sided(f) ? end_until(f) : fresh_until(f, a, b));
}

/// Two uniform pieces that grow by w_l and w_r a second have the flattening error sqrt(w_l w_r) |difference|: this in
/// units of what is allowed. A tagged front keeps density and temperature apart.
template <class M>
inline double Line<M>::rate_of_change(const Watched& l, const Watched& r, double w_l, double w_r, bool tagged) const {
    double change = 0;
    for (std::size_t k = 0; k < watched; ++k) {
        const double of_this = apart(tagged, k) ? 0 : std::abs(l[k] - r[k]) * per_allowed_[k];
        change = of_this > change ? of_this : change;
    }
    return change * std::sqrt(w_l * w_r);
}

template <class M>
inline double Line<M>::fresh_until(const Front& f, const Watched& l, const Watched& r) const {
    const double rate = rate_of_change(l, r, l[1] - f.S_l, f.S_r - r[1], f.tagged);
    return rate > 0 ? 1 / rate : Schedule::never;
}

/// A fresh front at a wall or a free end has an inner piece only. At a wall the velocity has its mirror image, at a
/// free end the pressure: |difference| / 2 of the half that is, and the mean of that odd field is its value there.
template <class M>
[[gnu::noinline]] double Line<M>::end_until(Front& f) const {
    const bool right = takes_from_right(f);
    const Watched inner = watched_of(cell(right ? f.right : f.left).f);
    const double w = right ? f.S_r - inner[1] : inner[1] - f.S_l;
    const std::size_t k = f.end == LineEnd::Kind::wall ? 1 : 2;
    f.base = inner;
    f.base[k] = k == 1 ? f.v_c : 0;
    const double rate = w * std::abs(inner[k] - f.base[k]) * per_allowed_[k];
    return rate > 0 ? 1 / rate : Schedule::never;
}

/// The square of the flattening error of one field, of which a front has these moments on its two sides.
template <class M>
inline double Line<M>::square_of_error(const Front& f, std::size_t k, const Moments& l, const Moments& r) const {
    if (!f.tagged) return odd(f, k) ? l.w * l.q : l.square();
    if (!apart(f.tagged, k)) return (l + r).square();
    return l.square() + r.square() + 2 * std::sqrt(l.square() * r.square());
}

/// Whether the flattening error of a front is more than is allowed, if it had these two sides.
template <class M>
inline bool Line<M>::too_much(const Front& f, const Side& l, const Side& r) const {
    bool much = false;  // of all fields, for a processor guesses badly which one is first
    for (std::size_t k = 0; k < watched; ++k)
        much |= square_of_error(f, k, moments(l, k), moments(r, k)) > allowed_square_[k];
    return much;
}

/// How long until an open front has changed as much as it may.
template <class M>
inline double Line<M>::open_until(const Front& f, const Watched& l, const Watched& r) const {
    const double w_l = takes_from_left(f) ? l[1] - f.S_l : 0;
    const double w_r = takes_from_right(f) ? f.S_r - r[1] : 0;
    double until = Schedule::never;
    for (std::size_t k = 0; k < watched; ++k) {
        const Moments from_l = piece(w_l, l[k] - f.base[k]);
        const Moments from_r = piece(w_r, r[k] - f.base[k]);
        if (apart(f.tagged, k)) {
            until = earlier(until, moments(f.l, k), from_l, 0, allowed_square_[k]);
            until = earlier(until, moments(f.r, k), from_r, 0, allowed_square_[k]);
            continue;
        }
        Moments now = moments(f.l, k);
        if (f.tagged) now = now + moments(f.r, k);
        Moments rate = from_l + from_r;
        double A = w_l * w_r * ((l[k] - r[k]) * (l[k] - r[k]));
        if (odd(f, k)) {
            now.s = rate.s = 0;
            A = rate.w * rate.q;
        }
        until = earlier(until, now, rate, A, allowed_square_[k]);
    }
    return until;
}

/// When the core of a front's right cell will be used up, and the earlier of that and its chop-out.
template <class M>
inline void Line<M>::reschedule(int id) {
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

#pragma once
// Waves of no width in place of a front.
#include "solvers/rrm/line.hpp"

namespace ordo::solvers::rrm {

/// Whether a fresh front would have to be chopped out before sound has crossed the space that it has.
template <class M>
bool Line<M>::worth_keeping(const Cell& l, const Cell& r, double space) const {
    const double w_l = l.f.v - std::min(l.f.v - l.f.a, r.f.v - r.f.a);
    const double w_r = std::max(l.f.v + l.f.a, r.f.v + r.f.a) - r.f.v;
    return rate_of_change(watched_of(l.f), watched_of(r.f), w_l, w_r, false) * space > std::max(l.f.a, r.f.a);
}

/// How many jumps a wave needs so that flattening each over `length` would change no field by more than is allowed; a
/// fan is as wide as its speeds differ, a shock is one jump.
template <class M>
Strength Line<M>::resolved(const State& from, Strength wave, Toward toward, double length) const {
    const State to = through_wave(medium_, from, wave, toward).behind;
    const Watched a = watched_of(from.f);
    const Watched b = watched_of(to.f);
    const double side = static_cast<double>(toward);
    const double spread = std::abs(from.f.v + side * from.f.a - to.f.v - side * to.f.a) / from.f.a;
    double square = 1;
    for (std::size_t k = 0; k < watched; ++k) {
        const double change = std::abs(a[k] - b[k]) * std::min(1.0, spread) * length;
        square = std::max(square, change / (std::sqrt(12.0) * options_.allowed[k]));  // a ramp's standard deviation
    }
    constexpr double longest_step = 0.3;  // in the logarithm of the density
    const double strong = spread > 1e-9 ? std::abs(std::log(to.f.rho / from.f.rho)) / longest_step : 0;
    wave.jumps = static_cast<int>(std::clamp(std::ceil(std::max(std::sqrt(square), strong)), 1.0, 1e4));
    return wave;
}

/// The two waves between these states, with as many jumps as they need; nothing where none are in reach.
template <class M>
std::optional<Meeting> Line<M>::resolved_meeting(const State& l, const State& r, double length) const {
    const auto coarse = met(medium_, l, r);
    if (!coarse) return std::nullopt;
    return met(medium_, l, r,
               {resolved(l, coarse->left, Toward::left, length), resolved(r, coarse->right, Toward::right, length)});
}

/// A kept front between two cells.
template <class M>
int Line<M>::keep(int L, int R, double x, double t, double speed) {
    const int id = add_front();
    Front& f = front(id);
    f.kind = Front::Kind::kept;
    f.tagged = f.wraps = false;
    f.left = L;
    f.right = R;
    f.end = end_between(L, R);
    f.t = f.t_0 = t;
    f.x_l = f.x_r = f.x_0 = f.x_c = x;
    f.S_l = f.S_r = f.v_c = speed;
    f.t_chop = Schedule::never;
    f.l.content = f.r.content = {};
    cell(L).right = id;
    cell(R).left = id;
    ++counts_.kept_waves;
    return id;
}

/// The waves that L and R send along, as kept fronts with cells of no width between them; those of no strength are left
/// out, for their states are their neighbours'. False where no waves were found.
template <class M>
bool Line<M>::send_waves(int L, int R, double x, double t, bool wraps, double length) {
    if (const int side = side_of(L, R); side >= 0) return send_from_end(at(side), L, R, x, t, length);
    const double V = 0.5 * (cell(L).f.v + cell(R).f.v);  // at rest with both
    const State l = boosted({cell(L).q, cell(L).f}, -V);
    const State r = boosted({cell(R).q, cell(R).f}, -V);
    const auto meeting = resolved_meeting(l, r, length);
    if (!meeting) return false;
    ++counts_.chop_outs;
    const bool still_left = std::abs(meeting->left.y) < no_strength;
    const bool still_right = std::abs(meeting->right.y) < no_strength;
    row_left_.clear();
    row_right_.clear();
    if (!still_left) through_wave(medium_, l, meeting->left, Toward::left, &row_left_);
    if (!still_right) through_wave(medium_, r, meeting->right, Toward::right, &row_right_);
    int before = L;
    int last = -1;
    const auto wave = [&](int to, double speed) {
        last = keep(before, to, x, t, speed + V);
        before = to;
    };
    const auto put = [&](const State& state) { return add_cell(boosted(state, V), 0); };
    for (const Jump& jump : row_left_) wave(put(jump.behind), jump.speed);
    const State& a = still_left ? l : row_left_.back().behind;
    const State& b = still_right ? r : row_right_.back().behind;
    if (still_right || !alike(a.f, b.f)) wave(still_right ? R : put(b), 0.5 * (a.f.v + b.f.v));
    for (std::size_t i = row_right_.size(); i-- > 0;)
        wave(i > 0 ? put(row_right_[i - 1].behind) : R, row_right_[i].speed);
    front(last).wraps = wraps;
    return true;
}

/// What an end sends inwards: row_right_ holds the wave into the inner cell, row_left_ that into the outside of a
/// prescribed end. The speed of the end itself, or nothing where no waves were found.
template <class M>
std::optional<double> Line<M>::waves_at_end(std::size_t side, const State& in, const State& out, double length) {
    const Toward inwards = side == 0 ? Toward::right : Toward::left;
    const Toward outwards = side == 0 ? Toward::left : Toward::right;
    row_left_.clear();
    row_right_.clear();
    if (ends_[side].kind == LineEnd::Kind::free) {
        auto wave = released(medium_, in, inwards, {first_strength(medium_, in.f, -in.f.p), 4});
        if (wave) wave = released(medium_, in, inwards, resolved(in, *wave, inwards, length));
        if (!wave) return std::nullopt;
        through_wave(medium_, in, *wave, inwards, &row_right_);
        return row_right_.back().behind.f.v;
    }
    const State& left = side == 0 ? out : in;
    const State& right = side == 0 ? in : out;
    const auto meeting = resolved_meeting(left, right, length);
    if (!meeting) return std::nullopt;
    through_wave(medium_, in, side == 0 ? meeting->right : meeting->left, inwards, &row_right_);
    if (ends_[side].kind == LineEnd::Kind::wall) return ends_[side].velocity;
    through_wave(medium_, out, side == 0 ? meeting->left : meeting->right, outwards, &row_left_);
    return 0;
}

/// Waves from an end, put back from the inner cell towards it: those that run inwards, each with the state behind it.
template <class M>
bool Line<M>::send_from_end(std::size_t side, int L, int R, double x, double t, double length) {
    const double sign = side == 0 ? 1 : -1;
    const int ghost = side == 0 ? L : R;
    const int inner = side == 0 ? R : L;
    const State in{cell(inner).q, cell(inner).f};
    const State out{cell(ghost).q, cell(ghost).f};
    const auto edge = waves_at_end(side, in, out, length);
    if (!edge) return false;
    ++counts_.chop_outs;
    const bool all_inwards = ends_[side].kind != LineEnd::Kind::prescribed;
    int before = inner;
    const auto link = [&](int c, double speed) {
        side == 0 ? keep(c, before, x, t, speed) : keep(before, c, x, t, speed);
        before = c;
    };
    for (const Jump& jump : row_right_) {
        if (all_inwards || sign * jump.speed > 0) link(add_cell(jump.behind, 0), jump.speed);
    }
    if (!row_left_.empty() && sign * row_left_.back().behind.f.v > 0) {
        link(add_cell(row_left_.back().behind, 0), row_left_.back().behind.f.v);
        for (std::size_t i = row_left_.size(); i-- > 0;) {
            if (sign * row_left_[i].speed > 0)
                link(add_cell(i > 0 ? row_left_[i - 1].behind : out, 0), row_left_[i].speed);
        }
    }
    link(ghost, *edge);
    return true;
}

}  // namespace ordo::solvers::rrm

#pragma once
// Waves of no width: what two uniform states send along so that every jump between them balances mass, momentum and
// energy. Rarefactions are rows of small jumps, so that nothing but the jump conditions is needed.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "solvers/media/medium.hpp"

namespace ordo::solvers::rrm {

struct State {
    Contents q;
    Flow f;
};

/// The same for an observer who moves with -V: near rest the internal energy keeps its digits.
inline State boosted(const State& s, double V) {
    State moved = s;
    moved.f.v += V;
    moved.q.momentum += s.q.mass * V;
    moved.q.energy += V * (s.q.momentum + 0.5 * s.q.mass * V);
    return moved;
}

/// The state behind a jump, and the jump's speed.
struct Jump {
    State behind;
    double speed;
};

/// Which way a wave runs relative to the material: the state ahead lies on that side.
enum class Toward : int { left = -1, right = 1 };

/// Through one jump from `ahead` to the density rho. With v = 1/rho and internal energy e a unit of mass,
///   e - e_0 = -(p + p_0) (v - v_0) / 2,   m^2 = -(p - p_0) / (v - v_0),
/// linear in p because p is linear in the internal energy at fixed density: p divided by 1 + G (1 - rho / rho_0) / 2,
/// `divisor`, which whoever knows it to more digits gives. Exact to round-off; behind an expansion entropy falls by
/// O((rho - rho_0)^3).
template <class M>
inline Jump through_jump(const M& medium, const State& ahead, double rho, Toward toward, double divisor) {
    const auto& [q0, f0] = ahead;
    const double side = static_cast<double>(toward);
    const double v0 = 1 / f0.rho;
    const double dv = 1 / rho - v0;
    const double e0 = (q0.energy - 0.5 * q0.momentum * f0.v) / f0.rho;
    const double p = (medium.flow({rho, 0, 0}).p + medium.grueneisen() * rho * (e0 - 0.5 * f0.p * dv)) / divisor;
    const bool faint = std::abs(dv) < 1e-8 * v0;  // where the quotient would be round-off
    const double mass_flux = faint ? f0.rho * f0.a : std::sqrt(std::max(0.0, (f0.p - p) / dv));
    const double v = f0.v - side * mass_flux * dv;
    const double e = rho * (e0 - 0.5 * (p + f0.p) * dv);
    Flow f = medium.flow({rho, 0, e});  // at rest: no kinetic energy to lose digits to
    f.v = v;
    return {{{rho, rho * v, e + 0.5 * rho * v * v}, f}, f0.v + side * mass_flux * v0};
}

template <class M>
Jump through_jump(const M& medium, const State& ahead, double rho, Toward toward) {
    return through_jump(medium, ahead, rho, toward, 1 + 0.5 * medium.grueneisen() * (1 - rho / ahead.f.rho));
}

/// Strength of a wave: the density behind it. y >= 0 is a shock, with the limit (G + 2) / G of the density as y grows,
/// so that the pressure of an ideal gas is linear in y; y < 0 an expansion in `jumps` jumps of equal ratio.
struct Strength {
    double y = 0;
    int jumps = 1;
};

/// The end of a wave; `each` is called with all its jumps, outermost first.
template <class M, class Each>
[[gnu::always_inline]] inline Jump through_jumps(const M& medium, const State& ahead, Strength wave, Toward toward,
                                                 const Each& each) {
    const double G = medium.grueneisen();
    const int n = wave.y < 0 ? wave.jumps : 1;
    const double limit = 1 / (1 + std::max(0.0, wave.y) * G / (G + 2));  // 0 where a shock has no more density to gain
    const double ratio = wave.y < 0 ? std::exp(2 * wave.y / ((G + 2) * n)) : (1 + wave.y) * limit;
    const double divisor = wave.y < 0 ? 1 + 0.5 * G * (1 - ratio) : limit;
    Jump last{ahead, 0};
    for (int i = 0; i < n; ++i) {
        last = through_jump(medium, last.behind, last.behind.f.rho * ratio, toward, divisor);
        each(last);
    }
    return last;
}

/// The end of a wave, with nothing kept of the way there: a jump stays in registers.
template <class M>
inline Jump through_wave(const M& medium, const State& ahead, Strength wave, Toward toward) {
    return through_jumps(medium, ahead, wave, toward, [](const Jump&) {});
}

/// The same; all its jumps go to `row`.
template <class M>
Jump through_wave(const M& medium, const State& ahead, Strength wave, Toward toward, std::vector<Jump>* row) {
    return through_jumps(medium, ahead, wave, toward, [row](const Jump& jump) { row->push_back(jump); });
}

/// Waves weaker than this are round-off of the states.
inline constexpr double no_strength = 1e-13;

/// Whether two states of one pressure and one velocity are the same but for round-off.
inline bool alike(const Flow& a, const Flow& b) {
    return std::abs(a.rho - b.rho) <= no_strength * a.rho && std::abs(a.T - b.T) <= no_strength * std::abs(a.T);
}

struct Meeting {
    Strength left, right;
};

/// A step of Newton's iteration that does not leave the branch: expansions by at most two units, shocks not far below
/// 0.
inline double limited(double step, double y) { return y <= 0 ? std::max(step, -2.0) : std::max(step, -0.9 * y - 0.5); }

/// What acoustics says of the density behind a wave that changes the pressure by dp.
template <class M>
double first_strength(const M& medium, const Flow& f, double dp) {
    const double y = 0.5 * dp / (f.rho * f.a * f.a) * (medium.grueneisen() + 2);
    return y > -0.6 ? y : -0.6 - std::log1p(-0.6 - y);
}

/// The strengths that bring two states to one pressure and one velocity, by Newton's iteration from `wave`, with the
/// step halved where it does not help. Nothing where there is none in reach: vacuum, or strengths that no double holds.
template <class M>
[[gnu::flatten]] std::optional<Meeting> met(const M& medium, const State& left, const State& right, Meeting wave) {
    const auto ends = [&](const Meeting& w) {
        return std::pair{through_wave(medium, left, w.left, Toward::left).behind.f,
                         through_wave(medium, right, w.right, Toward::right).behind.f};
    };
    Meeting best = wave;
    double least = std::numeric_limits<double>::infinity();
    int idle = 0;
    while (idle < 40) {
        const auto [a, b] = ends(wave);
        const double dp = a.p - b.p;
        const double dv = a.v - b.v;
        const double scale = std::max({left.f.a, right.f.a, std::abs(a.v - left.f.v), std::abs(b.v - right.f.v)});
        const double size = a.physical() && b.physical()
                                ? (std::abs(dp) / (a.rho * a.a + b.rho * b.a) + std::abs(dv)) / scale
                                : std::numeric_limits<double>::infinity();
        idle = size < 0.5 * least ? 0 : idle + 1;
        const bool worse = !(size <= 2 * least);
        if (size < least) {
            least = size;
            best = wave;
        }
        if (least <= 1e-16 || (least < 1e-12 && idle > 4)) break;
        if (worse || std::isinf(size)) {
            wave.left.y = 0.5 * (wave.left.y + best.left.y);
            wave.right.y = 0.5 * (wave.right.y + best.right.y);
            continue;
        }
        const double hl = 1e-7 * (1 + std::abs(wave.left.y));
        const double hr = 1e-7 * (1 + std::abs(wave.right.y));
        const auto [a2, b2] = ends({{wave.left.y + hl, wave.left.jumps}, {wave.right.y + hr, wave.right.jumps}});
        const double pa = (a2.p - a.p) / hl;
        const double va = (a2.v - a.v) / hl;
        const double pb = (b2.p - b.p) / hr;
        const double vb = (b2.v - b.v) / hr;
        const double det = pb * va - pa * vb;
        wave.left.y += limited((dp * vb - pb * dv) / det, wave.left.y);
        wave.right.y += limited((dp * va - pa * dv) / det, wave.right.y);
        if (!std::isfinite(wave.left.y + wave.right.y)) break;
    }
    if (least > 1e-12) return std::nullopt;
    return best;
}

/// The same from two states alone.
template <class M>
std::optional<Meeting> met(const M& medium, const State& left, const State& right) {
    const double Zl = left.f.rho * left.f.a;
    const double Zr = right.f.rho * right.f.a;
    const double p = (Zr * left.f.p + Zl * right.f.p + Zl * Zr * (left.f.v - right.f.v)) / (Zl + Zr);
    const auto guess = [&](const Flow& f) {
        const double y = first_strength(medium, f, p - f.p);
        return Strength{y, y < -0.5 ? 32 : 4};  // a single jump cannot expand without limit
    };
    return met(medium, left, right, {guess(left.f), guess(right.f)});
}

/// The strength of the wave that brings a state to the pressure 0, as a free end does.
template <class M>
std::optional<Strength> released(const M& medium, const State& inner, Toward toward, Strength wave) {
    Strength best = wave;
    double least = std::numeric_limits<double>::infinity();
    for (int idle = 0; idle < 5 && least > 1e-16; ++idle) {
        const Flow f = through_wave(medium, inner, wave, toward).behind.f;
        if (!f.physical()) return std::nullopt;
        const double size = std::abs(f.p) / (f.rho * f.a * f.a);
        if (size < 0.5 * least) idle = 0;
        if (size < least) {
            least = size;
            best = wave;
        }
        const double h = 1e-7 * (1 + std::abs(wave.y));
        const double slope = (through_wave(medium, inner, {wave.y + h, wave.jumps}, toward).behind.f.p - f.p) / h;
        wave.y += limited(-f.p / slope, wave.y);
    }
    if (least > 1e-12) return std::nullopt;
    return best;
}

}  // namespace ordo::solvers::rrm

#pragma once
// How much flattening an interval would change it, and when that will be as much as is allowed.
#include <algorithm>
#include <cmath>

#include "solvers/rrm/front.hpp"

namespace ordo::solvers::rrm {

/// Length, and the first two moments of one field over it. The flattening error is sqrt(w q - s^2), that is length
/// times standard deviation; two pieces of equal length that differ by D give length * D / 2.
struct Moments {
    double w, s, q;

    friend Moments operator+(const Moments& a, const Moments& b) { return {a.w + b.w, a.s + b.s, a.q + b.q}; }
    double square() const { return std::max(0.0, w * q - s * s); }  ///< of the flattening error
};

inline Moments moments(const Side& side, std::size_t k) { return {side.width, side.sum[k], side.square[k]}; }

/// Those of a length w with the value d.
inline Moments piece(double w, double d) { return {w, d * w, d * d * w}; }

/// The earlier of `until` and the time that moments, which are `now` and grow by `rate` a second, take to the
/// flattening error whose square is `allowed_square`. `A` is the square of the error that the rate alone makes in a
/// second.
inline double earlier(double until, const Moments& now, const Moments& rate, double A, double allowed_square) {
    const double B = now.w * rate.q + rate.w * now.q - 2 * now.s * rate.s;
    const double C = now.square() - allowed_square;
    if (C >= 0) return 0;
    if (!(C + until * (B + until * A) > 0)) return until;  // so too where nothing changes: 0 times infinity
    const double root = std::sqrt(B * B - 4 * A * C);
    return B >= 0 ? -2 * C / (B + root) : (root - B) / (2 * A);
}

/// A length `width` in which the first n fields have the values `now` comes in.
inline void sweep(Side& side, double width, const Watched& now, const Watched& base, std::size_t n) {
    side.width += width;
    for (std::size_t k = 0; k < n; ++k) {
        const double d = now[k] - base[k];
        side.sum[k] += width * d;
        side.square[k] += width * d * d;
    }
}

/// The same from both sides at once, in an order that a mirror does not change.
inline void sweep(Side& all, double w_l, double w_r, const Watched& l, const Watched& r, const Watched& base,
                  std::size_t n) {
    all.width += w_l + w_r;
    for (std::size_t k = 0; k < n; ++k) {
        const Moments both = piece(w_l, l[k] - base[k]) + piece(w_r, r[k] - base[k]);
        all.sum[k] += both.s;
        all.square[k] += both.q;
    }
}

/// Adds a side whose moments are relative to another base.
inline void add(Side& to, const Watched& base, const Side& from, const Watched& other, std::size_t n) {
    to.content += from.content;
    to.width += from.width;
    for (std::size_t k = 0; k < n; ++k) {
        const double shift = other[k] - base[k];
        to.sum[k] += from.sum[k] + shift * from.width;
        to.square[k] += from.square[k] + shift * (2 * from.sum[k] + shift * from.width);
    }
}

}  // namespace ordo::solvers::rrm

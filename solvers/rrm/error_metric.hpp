#pragma once
// How much flattening an interval would change it, and when that will be as much as is allowed.
#include <algorithm>
#include <cmath>

#include "solvers/rrm/front.hpp"
#include "solvers/rrm/schedule.hpp"

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

/// How long until moments that are `now` and grow by `rate` a second have the flattening error `allowed`.
inline double time_until(const Moments& now, const Moments& rate, double allowed) {
    double A = rate.w * rate.q - rate.s * rate.s;
    if (A < 1e-12 * rate.w * rate.q) A = 0;  // round-off of a rate with one value only
    const double B = now.w * rate.q + rate.w * now.q - 2 * now.s * rate.s;
    const double C = now.square() - allowed * allowed;
    if (C >= 0) return 0;
    if (A == 0) return B > 0 ? -C / B : Schedule::never;
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

/// Moments of the first n fields relative to a base that lies lower by `shift`.
inline void rebase(Side& side, const Watched& shift, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
        side.square[k] += shift[k] * (2 * side.sum[k] + shift[k] * side.width);
        side.sum[k] += shift[k] * side.width;
    }
}

inline void add(Side& to, const Side& from, std::size_t n) {
    to.content += from.content;
    to.width += from.width;
    for (std::size_t k = 0; k < n; ++k) {
        to.sum[k] += from.sum[k];
        to.square[k] += from.square[k];
    }
}

}  // namespace ordo::solvers::rrm

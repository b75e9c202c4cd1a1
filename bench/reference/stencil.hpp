#pragma once
// The arithmetic of one particle, or of one particle in each lane of a vector V: what all reference loops share.
// V is double or a vector type of the compiler's; every template here has it as its argument, so that sources compiled
// for different instruction sets share no function.

namespace ordo::bench {

constexpr int power(int base, int exponent) { return exponent == 0 ? 1 : base * power(base, exponent - 1); }

/// Uniform B-splines of degree 1 or 2 at the local coordinate xi of a cell, and their slopes by x.
template <class V, int degree>
[[gnu::always_inline]] inline void splines(V xi, double inv_h, V (&w)[degree + 1], V (&slope)[degree + 1]) {
    if constexpr (degree == 1) {
        w[0] = 1.0 - xi;
        w[1] = xi;
        slope[1] = V{} + inv_h;
        slope[0] = -slope[1];
    } else {
        const V rest = 1.0 - xi;
        w[0] = 0.5 * rest * rest;
        w[2] = 0.5 * xi * xi;
        w[1] = 0.5 + xi * rest;
        slope[0] = -inv_h * rest;
        slope[2] = inv_h * xi;
        slope[1] = inv_h * (rest - xi);
    }
}

}  // namespace ordo::bench

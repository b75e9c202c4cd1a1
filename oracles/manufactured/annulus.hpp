#pragma once
// A full ring about the origin, r_i <= R <= r_o.
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::oracles {

/// Distance of X from the origin [m]. Throws InputError, opened by `where`, off the ring; 4 ulp are left to a rim's
/// points.
inline double radius_in(double r_i, double r_o, const std::array<double, 2>& X, const char* where) {
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    const double R = std::hypot(X[0], X[1]);
    if (R >= r_i * (1 - rounding) && R <= r_o * (1 + rounding)) return R;
    throw InputError(where, "(" + shortest(X[0]) + ", " + shortest(X[1]) + ") lies at R = " + shortest(R) +
                                " m, off the ring: R must be in [" + shortest(r_i) + ", " + shortest(r_o) + "]");
}

inline void require_ring(double r_i, double r_o, const char* where) {
    if (r_i < r_o) return;
    throw InputError(where, "r_i = " + shortest(r_i) + " m, but must be below r_o = " + shortest(r_o));
}

}  // namespace ordo::oracles

#pragma once
// How much a field rises across a cell, from its differences to both neighbours.
#include <algorithm>
#include <cmath>
#include <variant>

namespace ordo::solvers::godunov {

/// `size` with the sign that a and b share, or 0 where they have none in common. Without a branch, so that several
/// cells can be done at a time.
inline double where_agreed(double a, double b, double size) { return a * b > 0 ? std::copysign(size, a) : 0; }

/// Each: rise(a, b) from a = q_i - q_(i-1) and b = q_(i+1) - q_i. All but the last keep a monotone row monotone.
/// source   [VanLeer1979], [Toro2009, ch. 13]
struct Minmod {
    static double rise(double a, double b) { return where_agreed(a, b, std::min(std::abs(a), std::abs(b))); }
};
struct VanLeer {
    static double rise(double a, double b) { return where_agreed(a, b, 2 * std::abs(a * b / (a + b))); }
};
struct MonotonizedCentral {
    static double rise(double a, double b) {
        return where_agreed(a, b, std::min(2 * std::min(std::abs(a), std::abs(b)), 0.5 * std::abs(a + b)));
    }
};
struct Superbee {
    static double rise(double a, double b) {
        const double size_a = std::abs(a);
        const double size_b = std::abs(b);
        return where_agreed(a, b, std::max(std::min(2 * size_a, size_b), std::min(size_a, 2 * size_b)));
    }
};
struct Central {
    static double rise(double a, double b) { return 0.5 * (a + b); }
};

using Limiter = std::variant<Minmod, VanLeer, MonotonizedCentral, Superbee, Central>;

}  // namespace ordo::solvers::godunov

#include "solvers/mpm/reconstruction/least_squares.hpp"

#include <algorithm>
#include <cmath>

namespace ordo::solvers::mpm {
namespace {

constexpr std::size_t together = MovingLeastSquares::together;

/// Places by lanes, and the particles that their windows span.
struct Group {
    std::span<const double> x;
    std::array<double, together> at, per_radius;
    double* phi;  ///< to be filled, [particle][lane]
};

/// Cubic spline weight of s, a distance in radii, as [SulskyGong2016]. Vectors go by reference: how they are handed over
/// depends on the instruction set.
template <class V>
[[gnu::always_inline]] inline void weight_of(const V& s, V& w) {
    const V r = s < 0.0 ? -s : s;
    const V far = 1.0 - r;
    const V inner = 2.0 / 3 - 4.0 * r * r * far;
    const V outer = 4.0 / 3 * far * far * far;
    w = r >= 1.0 ? V{} : r <= 0.5 ? inner : outer;
}

/// c = G^-1 b(at), b(at) = (1, 0, ...): by Cholesky's factors of the Hankel matrix G_ij = S_{i+j}. False where G is not
/// positive in one of the lanes.
template <int size, class V>
[[gnu::always_inline]] inline bool solved(const V (&S)[2 * size - 1], V (&c)[size]) {
    constexpr int width = sizeof(V) / sizeof(double);
    V L[size][size];  // its diagonal inverted
    bool positive = true;
#pragma GCC unroll 7
    for (int j = 0; j < size; ++j) {
        V d = S[2 * j];
#pragma GCC unroll 7
        for (int k = 0; k < j; ++k) d -= L[j][k] * L[j][k];
        for (int lane = 0; lane < width; ++lane) {
            positive = positive && d[lane] > 0;
            d[lane] = std::sqrt(d[lane]);
        }
        L[j][j] = 1.0 / d;
#pragma GCC unroll 7
        for (int i = j + 1; i < size; ++i) {
            V rest = S[i + j];
#pragma GCC unroll 7
            for (int k = 0; k < j; ++k) rest -= L[i][k] * L[j][k];
            L[i][j] = rest * L[j][j];
        }
    }
#pragma GCC unroll 7
    for (int i = 0; i < size; ++i) {
        c[i] = i == 0 ? V{} + 1.0 : V{};
#pragma GCC unroll 7
        for (int k = 0; k < i; ++k) c[i] -= L[i][k] * c[k];
        c[i] *= L[i][i];
    }
#pragma GCC unroll 7
    for (int i = size - 1; i >= 0; --i) {
#pragma GCC unroll 7
        for (int k = i + 1; k < size; ++k) c[i] -= L[k][i] * c[k];
        c[i] *= L[i][i];
    }
    return positive;
}

/// phi_p = w_p c . b_p with c = G^-1 b(at), G = sum w b b^T and b the powers of the scaled distance, in the lanes of V
/// from `lane` on.
template <int degree, class V>
[[gnu::always_inline]] inline bool weigh(const Group& group, std::size_t lane) {
    constexpr std::size_t width = sizeof(V) / sizeof(double);
    V at, per_radius;
    for (std::size_t k = 0; k < width; ++k) {
        at[k] = group.at[lane + k];
        per_radius[k] = group.per_radius[lane + k];
    }
    V sums[2 * degree + 1] = {};
    for (const double x : group.x) {
        const V s = (x - at) * per_radius;
        V term;
        weight_of(s, term);
#pragma GCC unroll 13
        for (V& sum : sums) {
            sum += term;
            term *= s;
        }
    }
    V c[degree + 1];
    const bool determined = solved<degree + 1>(sums, c);
    for (std::size_t p = 0; p < group.x.size(); ++p) {
        const V s = (group.x[p] - at) * per_radius;
        V w;
        weight_of(s, w);
        V value = c[degree];
#pragma GCC unroll 7
        for (int k = degree - 1; k >= 0; --k) value = value * s + c[k];
        for (std::size_t k = 0; k < width; ++k) group.phi[p * together + lane + k] = w[k] * value[k];
    }
    return determined;
}

using Two = double __attribute__((vector_size(16)));
using Four = double __attribute__((vector_size(32)));
using Eight = double __attribute__((vector_size(64)));

template <int degree, class V>
[[gnu::always_inline]] inline bool weigh_all(const Group& group) {
    bool determined = true;
    for (std::size_t lane = 0; lane < together; lane += sizeof(V) / sizeof(double))
        determined = weigh<degree, V>(group, lane) && determined;
    return determined;
}
template <int degree>
[[gnu::flatten]] bool baseline(const Group& group) {
    return weigh_all<degree, Two>(group);
}
template <int degree>
[[gnu::flatten, gnu::target("avx2")]] bool avx2(const Group& group) {
    return weigh_all<degree, Four>(group);
}
template <int degree>
[[gnu::flatten, gnu::target("avx512f,avx512dq,prefer-vector-width=512")]] bool avx512(const Group& group) {
    return weigh_all<degree, Eight>(group);
}

template <int degree>
bool weigh(InstructionSet set, const Group& group) {
    switch (set) {
        case InstructionSet::avx512: return avx512<degree>(group);
        case InstructionSet::avx2: return avx2<degree>(group);
        default: return baseline<degree>(group);
    }
}

bool weigh(int degree, InstructionSet set, const Group& group) {
    switch (degree) {
        case 1: return weigh<1>(set, group);
        case 2: return weigh<2>(set, group);
        case 3: return weigh<3>(set, group);
        case 4: return weigh<4>(set, group);
        case 5: return weigh<5>(set, group);
        default: return weigh<MovingLeastSquares::highest_degree>(set, group);
    }
}

}  // namespace

bool MovingLeastSquares::fit(std::span<const double> places, double radius, std::size_t fewest) {
    Group group{};
    Window window = windows_[0];
    std::size_t high = 0;
    low_ = x_.size();
    for (std::size_t k = 0; k < together; ++k) {
        const double at = places[std::min(k, places.size() - 1)];
        double wide = radius;
        if (!widen(window, at, wide, fewest)) return false;
        windows_[k] = window;
        low_ = std::min(low_, window.first);
        high = std::max(high, window.last);
        group.at[k] = at;
        group.per_radius[k] = 1 / wide;
    }
    phi_.resize((high - low_) * together);
    group.x = x_.subspan(low_, high - low_);
    group.phi = phi_.data();
    return weigh(degree_, set_, group);
}

/// From a window nearby to that about `at`.
bool MovingLeastSquares::widen(Window& window, double at, double& radius, std::size_t fewest) const {
    if (x_.size() < fewest) return false;
    auto& [first, last] = window;
    while (first > 0 && x_[first - 1] > at - radius) --first;
    while (first < x_.size() && x_[first] <= at - radius) ++first;
    last = std::max(last, first);
    while (last < x_.size() && x_[last] < at + radius) ++last;
    while (last > first && x_[last - 1] >= at + radius) --last;
    while (last - first < fewest) {
        const bool left = first > 0 && (last == x_.size() || at - x_[first - 1] <= x_[last] - at);
        if (left) --first;
        else ++last;
        radius = std::max(radius, 1.2 * std::abs(x_[left ? first : last - 1] - at));
    }
    return true;
}

}  // namespace ordo::solvers::mpm

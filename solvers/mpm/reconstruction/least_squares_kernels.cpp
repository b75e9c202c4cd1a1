#include "solvers/mpm/reconstruction/least_squares_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ordo::solvers::mpm {
namespace {

using Lanes = MovingLeastSquares::Lanes;
constexpr std::size_t together = MovingLeastSquares::together;

/// Between memory and vectors, which go by reference: how they are handed over depends on the instruction set.
template <class V>
[[gnu::always_inline]] inline void load(const double* from, V& v) {
    std::memcpy(&v, from, sizeof(V));
}
template <class V>
[[gnu::always_inline]] inline void store(const V& v, double* to) {
    std::memcpy(to, &v, sizeof(V));
}

/// Cubic spline weight of s, a distance in radii, as [SulskyGong2016] but for the factor 4/3, which phi does not feel:
/// (1 - |s|)^3 - 4 (1/2 - |s|)^3, each where it is positive.
template <class V>
[[gnu::always_inline]] inline void weight_of(const V& s, V& w) {
    const V r = s < 0.0 ? -s : s;
    const V to_end = 1.0 - r;
    const V to_middle = 0.5 - r;
    const V outer = to_end > 0.0 ? to_end : V{};
    const V inner = to_middle > 0.0 ? to_middle : V{};
    w = outer * outer * outer - 4.0 * (inner * inner * inner);
}

/// c = G^-1 b(at), b(at) = (1, 0, ...): by the factors L D L^T of the Hankel matrix G_ij = S_{i+j}. False where G is
/// not positive in one of the lanes.
template <int size, class V>
[[gnu::always_inline]] inline bool solved(const V (&S)[2 * size - 1], V (&c)[size]) {
    V L[size][size], LD[size][size], per_d[size];
    V least = S[0];
#pragma GCC unroll 7
    for (int j = 0; j < size; ++j) {
#pragma GCC unroll 7
        for (int i = j; i < size; ++i) {
            V rest = S[i + j];
#pragma GCC unroll 7
            for (int k = 0; k < j; ++k) rest -= L[i][k] * LD[j][k];
            LD[i][j] = rest;
        }
        least = LD[j][j] < least ? LD[j][j] : least;
        per_d[j] = 1.0 / LD[j][j];
#pragma GCC unroll 7
        for (int i = j + 1; i < size; ++i) L[i][j] = LD[i][j] * per_d[j];
    }
#pragma GCC unroll 7
    for (int i = 0; i < size; ++i) {
        c[i] = i == 0 ? V{} + 1.0 : V{};
#pragma GCC unroll 7
        for (int k = 0; k < i; ++k) c[i] -= L[i][k] * c[k];
    }
#pragma GCC unroll 7
    for (int i = size - 1; i >= 0; --i) {
        c[i] *= per_d[i];
#pragma GCC unroll 7
        for (int k = i + 1; k < size; ++k) c[i] -= L[k][i] * c[k];
    }
    bool positive = true;
    for (std::size_t lane = 0; lane < sizeof(V) / sizeof(double); ++lane)
        positive = positive && least[lane] > 0 && !std::isnan(c[0][lane]);
    return positive;
}

/// phi_p = w_p c . b_p with c = G^-1 b(at), G = sum w b b^T and b the powers of the scaled distance, in the lanes of V
/// from `lane` on.
template <int degree, class V>
[[gnu::always_inline]] inline bool weigh(const Neighbours& near, std::size_t lane) {
    V at, per_radius;
    load(&near.at[lane], at);
    load(&near.per_radius[lane], per_radius);
    V sums[2 * degree + 1] = {};
    for (std::size_t p = 0; p < near.x.size(); ++p) {
        const V s = (near.x[p] - at) * per_radius;
        V term;
        weight_of(s, term);
        if (near.widened) [[unlikely]] {
            for (std::size_t k = 0; k < sizeof(V) / sizeof(double); ++k) {
                const auto& [first, last] = near.windows[lane + k];
                if (near.first + p < first || near.first + p >= last) term[k] = 0;
            }
        }
        store(term, &near.phi[p][lane]);
        sums[0] += term;
#pragma GCC unroll 12
        for (int k = 1; k <= 2 * degree; ++k) {
            term *= s;
            sums[k] += term;
        }
    }
    V c[degree + 1];
    const bool determined = solved<degree + 1>(sums, c);
    for (std::size_t p = 0; p < near.x.size(); ++p) {
        const V s = (near.x[p] - at) * per_radius;
        V value = c[degree];
#pragma GCC unroll 6
        for (int k = degree - 1; k >= 0; --k) value = value * s + c[k];
        V w;
        load(&near.phi[p][lane], w);
        store(V(w * value), &near.phi[p][lane]);
    }
    return determined;
}

/// The sums of neighbouring places.
template <class V>
[[gnu::always_inline]] inline void sum_up(std::span<const Lanes> phi, const double* f, Lanes& out) {
    constexpr std::size_t width = sizeof(V) / sizeof(double);
    V sums[together / width] = {};
    for (std::size_t p = 0; p < phi.size(); ++p) {
#pragma GCC unroll 4
        for (std::size_t k = 0; k < together / width; ++k) {
            V weights;
            load(&phi[p][k * width], weights);
            sums[k] += weights * f[p];
        }
    }
#pragma GCC unroll 4
    for (std::size_t k = 0; k < together / width; ++k) store(sums[k], &out[k * width]);
}

using Two = double __attribute__((vector_size(16)));
using Four = double __attribute__((vector_size(32)));
using Eight = double __attribute__((vector_size(64)));

template <int degree, class V>
[[gnu::always_inline]] inline bool weigh_all(const Neighbours& near) {
    bool determined = true;
    for (std::size_t lane = 0; lane < together; lane += sizeof(V) / sizeof(double))
        determined = weigh<degree, V>(near, lane) && determined;
    return determined;
}
template <class V>
[[gnu::always_inline]] inline void sum_all(const Sampled& sampled) {
    const auto& [groups, phi, f, out] = sampled;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const auto& [first, last] = groups[g].span;
        Lanes sums;
        sum_up<V>(phi.subspan(groups[g].phi, last - first), &f[first], sums);
        const std::size_t from = g * together;
        std::copy_n(sums.begin(), std::min(together, out.size() - from), &out[from]);
    }
}

template <int degree>
[[gnu::flatten]] bool baseline(const Neighbours& near) {
    return weigh_all<degree, Two>(near);
}
template <int degree>
[[gnu::flatten, gnu::target("avx2")]] bool avx2(const Neighbours& near) {
    return weigh_all<degree, Four>(near);
}
template <int degree>
[[gnu::flatten, gnu::target("avx512f,avx512dq,prefer-vector-width=512")]] bool avx512(const Neighbours& near) {
    return weigh_all<degree, Eight>(near);
}
[[gnu::flatten]] void baseline(const Sampled& sampled) { sum_all<Two>(sampled); }
[[gnu::flatten, gnu::target("avx2")]] void avx2(const Sampled& sampled) { sum_all<Four>(sampled); }
[[gnu::flatten, gnu::target("avx512f,avx512dq,prefer-vector-width=512")]] void avx512(const Sampled& sampled) {
    sum_all<Eight>(sampled);
}

template <int degree>
bool weigh(InstructionSet set, const Neighbours& near) {
    switch (set) {
        case InstructionSet::avx512: return avx512<degree>(near);
        case InstructionSet::avx2: return avx2<degree>(near);
        default: return baseline<degree>(near);
    }
}

}  // namespace

bool weigh(int degree, InstructionSet set, const Neighbours& near) {
    switch (degree) {
        case 1: return weigh<1>(set, near);
        case 2: return weigh<2>(set, near);
        case 3: return weigh<3>(set, near);
        case 4: return weigh<4>(set, near);
        case 5: return weigh<5>(set, near);
        default: return weigh<MovingLeastSquares::highest_degree>(set, near);
    }
}

void sum_up(InstructionSet set, const Sampled& sampled) {
    switch (set) {
        case InstructionSet::avx512: return avx512(sampled);
        case InstructionSet::avx2: return avx2(sampled);
        default: return baseline(sampled);
    }
}

}  // namespace ordo::solvers::mpm

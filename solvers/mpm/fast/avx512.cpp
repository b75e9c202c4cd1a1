// Kernels of eight lanes at once. Compiled for AVX-512; see kernel.hpp for what may be included here.
#include <immintrin.h>

#include "solvers/mpm/fast/instruction_sets.hpp"
#include "solvers/mpm/fast/kernel.hpp"

namespace ordo::solvers::mpm::fast {
namespace {

struct Avx512 {
    using V = __m512d;
    static constexpr int width = 8;

    static V load(const double* at) { return _mm512_loadu_pd(at); }
    static void store(double* at, V x) { _mm512_storeu_pd(at, x); }
    static V all(double x) { return _mm512_set1_pd(x); }
    static V count() { return _mm512_setr_pd(0, 1, 2, 3, 4, 5, 6, 7); }
    static V where_positive(V x, V value) {
        return _mm512_maskz_mov_pd(_mm512_cmp_pd_mask(x, _mm512_setzero_pd(), _CMP_GT_OQ), value);
    }
    static unsigned not_above_zero(V x) { return _mm512_cmp_pd_mask(x, _mm512_setzero_pd(), _CMP_NGT_UQ); }
    static unsigned not_within(V x, double from, double to) {
        return static_cast<unsigned>(_mm512_cmp_pd_mask(x, all(from), _CMP_NGE_UQ)) |
               static_cast<unsigned>(_mm512_cmp_pd_mask(x, all(to), _CMP_NLE_UQ));
    }
    /// x where it lies within, `other` elsewhere.
    static V where_within(V x, double from, double to, V other) {
        return _mm512_mask_mov_pd(x, static_cast<__mmask8>(not_within(x, from, to)), other);
    }
    /// The last k lanes of `before`, then the first of x.
    template <int k>
    static V shifted(V before, V x) {
        return __builtin_shufflevector(before, x, 8 - k, 9 - k, 10 - k, 11 - k, 12 - k, 13 - k, 14 - k, 15 - k);
    }
};

}  // namespace

template <int dim>
Kernels<dim> avx512_kernels(int degree, bool total) {
    return kernels_of<Avx512, dim>(degree, total);
}

template Kernels<1> avx512_kernels(int, bool);
template Kernels<2> avx512_kernels(int, bool);
template Kernels<3> avx512_kernels(int, bool);

}  // namespace ordo::solvers::mpm::fast

// Kernels of four lanes at once. Compiled for AVX2, with a vector type of its own width; see kernel.hpp for what may be
// included here.
#include <immintrin.h>

#include "solvers/mpm/fast/instruction_sets.hpp"
#include "solvers/mpm/fast/kernel.hpp"

namespace ordo::solvers::mpm::fast {
namespace {

struct Avx2 {
    using V = __m256d;
    static constexpr int width = 4;

    static V load(const double* at) { return _mm256_loadu_pd(at); }
    static void store(double* at, V x) { _mm256_storeu_pd(at, x); }
    static V all(double x) { return _mm256_set1_pd(x); }
    static V count() { return _mm256_setr_pd(0, 1, 2, 3); }
    static V where_positive(V x, V value) {
        return _mm256_and_pd(_mm256_cmp_pd(x, _mm256_setzero_pd(), _CMP_GT_OQ), value);
    }
    static unsigned not_above_zero(V x) { return bits(_mm256_cmp_pd(x, _mm256_setzero_pd(), _CMP_NGT_UQ)); }
    static unsigned not_within(V x, double from, double to) { return bits(outside(x, from, to)); }
    /// x where it lies within, `other` elsewhere.
    static V where_within(V x, double from, double to, V other) {
        return _mm256_blendv_pd(x, other, outside(x, from, to));
    }
    /// The last k lanes of `before`, then the first of x.
    template <int k>
    static V shifted(V before, V x) {
        return __builtin_shufflevector(before, x, 4 - k, 5 - k, 6 - k, 7 - k);
    }

private:
    static unsigned bits(V mask) { return static_cast<unsigned>(_mm256_movemask_pd(mask)); }
    static V outside(V x, double from, double to) {
        return _mm256_or_pd(_mm256_cmp_pd(x, all(from), _CMP_NGE_UQ), _mm256_cmp_pd(x, all(to), _CMP_NLE_UQ));
    }
};

}  // namespace

template <int dim>
Kernels<dim> avx2_kernels(int degree, bool total) {
    return kernels_of<Avx2, dim>(degree, total);
}

template Kernels<1> avx2_kernels(int, bool);
template Kernels<2> avx2_kernels(int, bool);
template Kernels<3> avx2_kernels(int, bool);

}  // namespace ordo::solvers::mpm::fast

// Kernels of two lanes at once. Compiled for what every x86-64 has; see kernel.hpp for what may be included here.
#include <emmintrin.h>

#include "solvers/mpm/fast/instruction_sets.hpp"
#include "solvers/mpm/fast/kernel.hpp"

namespace ordo::solvers::mpm::fast {
namespace {

struct Baseline {
    using V = __m128d;
    static constexpr int width = 2;

    static V load(const double* at) { return _mm_loadu_pd(at); }
    static void store(double* at, V x) { _mm_storeu_pd(at, x); }
    static V all(double x) { return _mm_set1_pd(x); }
    static V count() { return _mm_setr_pd(0, 1); }
    static V where_positive(V x, V value) { return _mm_and_pd(_mm_cmpgt_pd(x, _mm_setzero_pd()), value); }
    static unsigned not_above_zero(V x) { return bits(_mm_cmpngt_pd(x, _mm_setzero_pd())); }
    static unsigned not_within(V x, double from, double to) { return bits(outside(x, from, to)); }
    /// x where it lies within, `other` elsewhere.
    static V where_within(V x, double from, double to, V other) {
        const V mask = outside(x, from, to);
        return _mm_or_pd(_mm_and_pd(mask, other), _mm_andnot_pd(mask, x));
    }
    /// The last k lanes of `before`, then the first of x.
    template <int k>
    static V shifted(V before, V x) {
        return __builtin_shufflevector(before, x, 2 - k, 3 - k);
    }

private:
    static unsigned bits(V mask) { return static_cast<unsigned>(_mm_movemask_pd(mask)); }
    static V outside(V x, double from, double to) {
        return _mm_or_pd(_mm_cmpnge_pd(x, all(from)), _mm_cmpnle_pd(x, all(to)));
    }
};

}  // namespace

template <int dim>
Kernels<dim> baseline_kernels(int degree, bool total) {
    return kernels_of<Baseline, dim>(degree, total);
}

template Kernels<1> baseline_kernels(int, bool);
template Kernels<2> baseline_kernels(int, bool);
template Kernels<3> baseline_kernels(int, bool);

}  // namespace ordo::solvers::mpm::fast

#include "solvers/mpm/fast/instruction_sets.hpp"

#include <cstdlib>
#include <string>

#include "core/error.hpp"

namespace ordo::solvers::mpm::fast {

bool has(Set set) {
    switch (set) {
        case Set::avx512:
            return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                   __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
        case Set::avx2: return __builtin_cpu_supports("avx2");
        default: return true;
    }
}

Set chosen_set() {
    const char* word = std::getenv("ORDO_SIMD");
    if (word == nullptr) return has(Set::avx512) ? Set::avx512 : has(Set::avx2) ? Set::avx2 : Set::baseline;
    const std::string name = word;
    const Set set = name == "avx512" ? Set::avx512 : name == "avx2" ? Set::avx2 : Set::baseline;
    if (set == Set::baseline && name != "baseline")
        throw InputError("ORDO_SIMD", "'" + name + "' is no set of instructions (there are baseline, avx2, avx512)");
    if (!has(set)) throw InputError("ORDO_SIMD", "this machine has no " + name + " (nearest: baseline)");
    return set;
}

template <int dim>
Kernels<dim> kernels(int degree, bool total) {
    switch (chosen_set()) {
        case Set::avx512: return avx512_kernels<dim>(degree, total);
        case Set::avx2: return avx2_kernels<dim>(degree, total);
        default: return baseline_kernels<dim>(degree, total);
    }
}

template Kernels<1> kernels(int, bool);
template Kernels<2> kernels(int, bool);
template Kernels<3> kernels(int, bool);

}  // namespace ordo::solvers::mpm::fast

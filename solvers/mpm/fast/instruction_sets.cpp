#include "solvers/mpm/fast/instruction_sets.hpp"

#include "solvers/instruction_set.hpp"

namespace ordo::solvers::mpm::fast {

template <int dim>
Kernels<dim> kernels(int degree, bool total) {
    switch (instruction_set()) {
        case InstructionSet::avx512: return avx512_kernels<dim>(degree, total);
        case InstructionSet::avx2: return avx2_kernels<dim>(degree, total);
        default: return baseline_kernels<dim>(degree, total);
    }
}

template Kernels<1> kernels(int, bool);
template Kernels<2> kernels(int, bool);
template Kernels<3> kernels(int, bool);

}  // namespace ordo::solvers::mpm::fast

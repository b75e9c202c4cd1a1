#pragma once
// One source an instruction set, all from the same templates; chosen when the program runs.
#include "solvers/mpm/fast/sweep.hpp"

namespace ordo::solvers::mpm::fast {

template <int dim>
Kernels<dim> avx512_kernels(int degree, bool total);
template <int dim>
Kernels<dim> avx2_kernels(int degree, bool total);
template <int dim>
Kernels<dim> baseline_kernels(int degree, bool total);

/// Those of instruction_set(), asked when a run starts.
template <int dim>
Kernels<dim> kernels(int degree, bool total);

}  // namespace ordo::solvers::mpm::fast

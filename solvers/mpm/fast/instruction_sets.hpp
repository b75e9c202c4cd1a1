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

enum class Set { baseline, avx2, avx512 };

bool has(Set set);  ///< this machine

/// The widest set that this machine has, or what the environment variable ORDO_SIMD (baseline, avx2, avx512) says;
/// asked when a run starts. The bits of a run are the same with each. Throws InputError on another word and on a set
/// that the machine lacks.
Set chosen_set();

template <int dim>
Kernels<dim> kernels(int degree, bool total);

}  // namespace ordo::solvers::mpm::fast

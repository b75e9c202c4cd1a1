#pragma once
// Which instructions the loops of a run are made of.

namespace ordo::solvers {

enum class InstructionSet { baseline, avx2, avx512 };

bool has(InstructionSet set);  ///< this machine

/// The widest set that this machine has; the environment variable ORDO_SIMD (baseline, avx2, avx512) chooses another,
/// asked anew at each call. The bits of a run are the same with each. Throws InputError on another word, and on a set
/// that the machine lacks.
InstructionSet instruction_set();

}  // namespace ordo::solvers

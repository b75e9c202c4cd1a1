#pragma once
// The figures of a run whose study asks for stability.
#include "studies/engine/run.hpp"

namespace ordo::studies {

/// Names of the figures that may be asked for.
const std::vector<std::string>& stability_names();

/// What a figure is, in a line.
std::string stability_words(const std::string& name);

/// Whether a figure is of one Courant number, which the sweep must then give, and not a limit of them.
bool is_at_courant(const std::string& name);

/// One for each quantity, NaN where there is none. `run.reason` says what lies beyond a limit of runs. Throws
/// InputError, Diverged and Interrupted.
void find_stability(const RunSpec& spec, const Parts& parts, const solvers::Interrupt& interrupt, Run& run);

}  // namespace ordo::studies

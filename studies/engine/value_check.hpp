#pragma once
// Expectations of numbers that are no errors: a value, or that two of them agree.
#include <vector>

#include "studies/engine/result.hpp"

namespace ordo::studies {

/// One check a solver and quantity: all admitted runs are inside the band. A run without a number fails by name, and so
/// does an expectation that no run meets.
void check_values(const Result& result, const Expectation& expectation, std::vector<Check>& checks);

}  // namespace ordo::studies

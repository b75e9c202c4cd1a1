#pragma once
// What errors, or values, do under refinement, by name.
#include <string>

namespace ordo::studies {

enum class Convergence { converges, at_floor, pre_asymptotic, stalled, diverges, inconclusive, invalid };

/// "pre_asymptotic".
std::string text_of(Convergence convergence);

}  // namespace ordo::studies

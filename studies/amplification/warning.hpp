#pragma once
// Steps that are known to be too long, before a study is run.
#include <string>
#include <vector>

#include "studies/engine/study.hpp"

namespace ordo::studies {

/// One line a solver whose step lies beyond the largest stable one in closed form at some resolution of the sweep, by
/// the resolution that is farthest beyond. Nothing is said where no closed form is known, nor of studies of stability.
std::vector<std::string> beyond_limits(const Study& study);

}  // namespace ordo::studies

#pragma once
// Ticks of a logarithmic axis.
#include <string>

#include "reports/plot/triangle.hpp"

namespace ordo::reports {

/// gnuplot's list of ticks for an axis over `range`: ('0.1' 1e-1, '' 2e-1 1, ...). Two have a label at least where the
/// range spans half a decade, and ten at most.
std::string log_ticks(const Interval& range);

}  // namespace ordo::reports

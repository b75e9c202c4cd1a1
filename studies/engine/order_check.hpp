#pragma once
// An expected order held against a fit.
#include "studies/engine/result.hpp"

namespace ordo::studies {

/// Passes only if the whole interval is inside the band; an interval wholly outside fails, one across a border is
/// inconclusive. A fit that knows no order has an infinite interval. Above the band passes where the expectation says
/// why it may. A refused fit fails by the name of what is wrong with its points.
Check order_check(const Expectation& expectation, const SeriesFit& fit, const std::string& claim);

/// The name of what makes a list of points no series.
Fault fault_of(Refusal refusal);

}  // namespace ordo::studies

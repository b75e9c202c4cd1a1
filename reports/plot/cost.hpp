#pragma once
// What a run cost, as the abscissa of a diagram that compares solvers: error over time, error over counted work.
#include "reports/cost/run_cost.hpp"
#include "reports/plot/layout.hpp"
#include "reports/plot/script.hpp"
#include "reports/report.hpp"

namespace ordo::reports {

/// Throws InputError when runs ended and none of them has a cost above zero.
void refuse_without(const studies::Result& result, Cost cost);

/// All series of a quantity, along whatever they refine, with bars of repeated times, the exponent of the cost in the
/// legend, the front over all, where the lead changes, and where each of `errors` is met. A run without a cost above
/// zero is left out, by name in the legend; where runs count their work in different things, so is what each series
/// counts, and nothing is compared.
Layout layout_of(const studies::Result& result, const studies::Quantity& quantity, Cost cost,
                 const std::vector<double>& errors = {});

Words cost_words(const Report& report, const studies::Quantity& quantity, Cost cost);

}  // namespace ordo::reports

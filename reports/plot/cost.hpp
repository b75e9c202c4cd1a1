#pragma once
// What a run cost, as the abscissa of a diagram that compares solvers: error over time, error over counted work.
#include <string>

#include "reports/plot/layout.hpp"
#include "reports/plot/script.hpp"
#include "reports/report.hpp"

namespace ordo::reports {

/// time: thread time [s] of the solver (set-up and steps, not the measuring of errors), once, on the machine of the
/// report. work: what the solver counts, the same on every machine.
enum class Cost { time, work };
std::string text_of(Cost cost);

/// Name of the figure in which a run counts its work: the first that ends in "_steps" (a particle or an element in one
/// step), else "iterations", "chop_outs", "cell_updates" or "steps"; "" where it counts none of them.
std::string counted_in(const studies::Run& run);

/// Thread time [s] or counted work; NaN where the run has none.
double cost_of(const studies::Run& run, Cost cost);

/// Throws InputError when runs ended and none of them has a cost above zero.
void refuse_without(const studies::Result& result, Cost cost);

/// All series of a quantity, along whatever they refine. A run without a cost above zero is left out, by name in the
/// legend; where runs count their work in different things, so is what each series counts.
Layout layout_of(const studies::Result& result, const studies::Quantity& quantity, Cost cost);

Words cost_words(const Report& report, const studies::Quantity& quantity, Cost cost);

}  // namespace ordo::reports

#pragma once
// What a run cost: time on the machine of the report, or work that is the same on every machine.
#include <string>
#include <vector>

#include "studies/engine/result.hpp"

namespace ordo::reports {

/// time: thread time [s] of the solver (set-up and steps, not the measuring of errors) on the machine of the report;
/// the median where the run was repeated, else once. work: what the solver counts, the same on every machine.
enum class Cost { time, work };
std::string text_of(Cost cost);

/// Name of the figure in which a run counts its work: the first that ends in "_steps" (a particle or an element in one
/// step), else "iterations", "chop_outs", "cell_updates" or "steps"; "" where it counts none of them.
std::string counted_in(const studies::Run& run);

/// Thread time [s] or counted work; NaN where the run has none.
double cost_of(const studies::Run& run, Cost cost);

/// Relative spread of the cost: that of repeated times; NaN for a time taken once; 0 for work.
double spread_of(const studies::Run& run, Cost cost);

/// The series of the result, once each where a study fits them against several abscissae.
std::vector<studies::Series> lines_in(const studies::Result& result);

}  // namespace ordo::reports

#pragma once
// Who is fastest: the methods of one report or several, ranked by the cost of given errors.
#include <string>
#include <vector>

#include "reports/cost/run_cost.hpp"
#include "reports/report.hpp"
#include "reports/table/table.hpp"

namespace ordo::reports {

/// First, over all reports, the fastest method at each error, its time and its resolution; then for each report and
/// quantity all methods with their places. Times lie between two runs (a power law) or at one: "<= 1e-5" is that of the
/// coarsest run, which is better than asked for; "not in 3 s" says how long a run was that did not reach it, or the
/// time limit. The resolution is that of the cheapest run that has reached the error. CSV is tidy: one row a report,
/// quantity, method and error. Throws InputError where no run has a time.
std::string ranking(const std::vector<Report>& reports, const std::vector<double>& errors, TableFormat format);

}  // namespace ordo::reports

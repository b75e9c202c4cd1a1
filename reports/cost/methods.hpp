#pragma once
// The methods of a report side by side: what each reaches at what cost, and who leads.
#include <optional>
#include <string>
#include <vector>

#include "reports/cost/descent.hpp"
#include "reports/cost/run_cost.hpp"
#include "reports/report.hpp"

namespace ordo::reports {

/// One series as points of cost and error.
struct Method {
    std::string label;
    std::string shown;              ///< the axis that it is refined by
    std::vector<int> runs;          ///< ids, coarse to fine
    std::vector<CostPoint> points;  ///< of these runs; NaN for a run that stopped
    Descent descent;
    /// The largest cost that it was looked at for: of its runs, and no less than the time limit where one passed it.
    double limit = 0;
};

/// All series of the result for one quantity, in their order there.
std::vector<Method> methods_of(const studies::Result& result, const studies::Quantity& quantity, Cost cost);

/// The exponent a of error ~ cost^-a with its interval, by the estimator of orders of accuracy against 1/cost.
studies::FitOutcome cost_exponent(const Method& method);

/// What it takes one method to reach an error.
struct Reach {
    CostToError cost;
    int run = -1;  ///< the cheapest run that has reached it; -1: none
};
Reach reach_of(const Method& method, double error);

/// Places in `methods` of those that reach the error, the cheapest first.
std::vector<std::size_t> ranked_at(const std::vector<Method>& methods, double error);

/// Where the lead changes by a crossover: no third method is better there.
struct LeadChange {
    CostPoint at;
    std::size_t before = 0;  ///< place of the method that leads at less cost
    std::size_t after = 0;
};
/// In rising cost. A method that leads from its cheapest run on has no crossover: where it would be is not measured.
std::vector<LeadChange> lead_changes(const std::vector<Method>& methods);

/// The front over all runs of all methods, in rising cost.
struct FrontPoint {
    CostPoint at;
    std::size_t method = 0;
    int run = -1;
};
std::vector<FrontPoint> front_of(const std::vector<Method>& methods);

}  // namespace ordo::reports

#pragma once
// Joint fits and extrapolations as lines of text and as JSON: one wording for tables, reports and `ordo fit`.
#include <string>
#include <vector>

#include "studies/order/grid_convergence.hpp"
#include "studies/order/joint_fit.hpp"
#include "studies/reader/json_input.hpp"

namespace ordo::reports {

/// "1.99 [1.98, 2.00]"; "1.99 [no interval]" where it is infinite, "unknown" where there is no value.
std::string words_of(const studies::Estimate& estimate);

/// Orders, coefficients, which error dominates at how many points, the next run, the verdict: one line each.
std::vector<std::string> lines_of(const studies::JointFit& fit);

/// "no exact solution: Richardson: order 1.79, limit 0.9713, finest value +- 0.001, converges".
std::string line_of(const studies::Extrapolation& extrapolation);

/// With stable order of members; null where a number is not finite.
studies::Json json_of(const studies::JointFit& fit);
studies::Json json_of(const studies::Extrapolation& extrapolation);

}  // namespace ordo::reports

#pragma once
// A report against what was accepted. Every check passes only where what is found is inside.
#include <optional>
#include <string>
#include <vector>

#include "reports/gate/baseline.hpp"

namespace ordo::reports {

/// Where the study differs from the accepted one: a failed check for each such member, and nothing is compared. Else
/// one check that there are runs, that each accepted one is there once and no other, ending alike, and one for the
/// figures of each solver and quantity.
std::vector<studies::Check> checks_against(const Report& report, const Baseline& baseline);

/// The failed check of a report without a baseline; `path` is where it was looked for.
studies::Check no_baseline(const std::string& path);

/// Whether the report's time over that of the reference kernel, with its whole spread, is inside [1/factor, factor]
/// times the accepted one.
studies::Check time_check(const Report& report, const Baseline& baseline, double factor);

/// What is wrong with a figure of now, `value`; none only where it is inside the accepted interval, or both have none.
studies::Fault fault_of(const AcceptedFigure& accepted, double value);

/// A figure as both baselines have it; one of both may lack it.
struct Change {
    std::optional<AcceptedFigure> before;
    std::optional<AcceptedFigure> now;
};

/// What a reviewer of a new baseline must see: figures that left the interval accepted before, came or went, and those
/// whose tolerance more than doubled.
std::vector<Change> changes(const Baseline& before, const Baseline& now);

}  // namespace ordo::reports

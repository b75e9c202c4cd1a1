#pragma once
// Runs of a study without running it: planned, with errors by hand.
#include <vector>

#include "studies/engine/run.hpp"

namespace ordo::tests {

/// The runs that the study plans, with errors from a function of h.
template <class F>
std::vector<studies::Run> planned_runs(const studies::Study& study, F error) {
    std::vector<studies::Run> runs;
    for (const auto& spec : studies::specs_of(study)) {
        studies::Run run;
        run.id = spec.id;
        run.solver = spec.solver.label;
        run.axes = spec.axes;
        run.h = spec.plan.h;
        run.dt = studies::step_taken(spec);
        run.t = spec.t_end;
        run.errors = {{"displacement.rms", error(spec.plan.h)}};
        runs.push_back(run);
    }
    return runs;
}

inline const auto second_order = [](double h) { return 3e-4 * h * h; };

}  // namespace ordo::tests

#pragma once
// One run: a plain description in, plain figures out.
#include <functional>
#include <optional>

#include "solvers/solver.hpp"
#include "studies/engine/result.hpp"
#include "studies/engine/scene_entry.hpp"

namespace ordo::studies {

/// All that a run needs to know: self-contained, so that it can be repeated anywhere.
struct RunSpec {
    int id = 0;
    SceneChoice scene;
    SolverChoice solver;
    std::vector<RunFigure> axes;  ///< as swept
    Values resolution;            ///< the same with defaults filled in
    Measure measure;
    std::optional<double> timeout_s;
    solvers::Plan plan;
    double courant = 0;  ///< of a study of stability, where the sweep gives one
    double t_end = 0;    ///< [s], from `measure` and the planned dt
    double cost = 0;     ///< planned particle-steps
};

/// What a run leaves: its figures, and its last snapshot where another run will be compared with it.
struct RunOutcome {
    Run run;
    std::optional<solvers::Snapshot> snapshot;
};

/// What a run is made of, by name. The house's own, unless a test puts a broken one in its place to see a gate ring.
struct Parts {
    std::function<const SceneEntry&(const std::string&)> scene;
    std::function<const solvers::Solver&(const std::string&)> solver;
    std::function<std::vector<RunFigure>(const std::vector<Quantity>&, const solvers::Snapshot&, const oracles::Exact&)>
        errors;
};
const Parts& house_parts();

/// The specs of a study, in the order of its sweep: solvers first, then the axes, the last one fastest.
/// Throws InputError where scene, solver and resolution do not go together.
std::vector<RunSpec> specs_of(const Study& study);

/// What is known of a run before it starts.
Run planned_run(const RunSpec& spec);

/// Runs it. Blowing up, throwing and passing the time limit are results; only `stop` ends it by Interrupted.
RunOutcome executed(const RunSpec& spec, const std::function<bool()>& stop, const Parts& parts = house_parts());

/// The step that the run takes: the planned one, or the longest below it that ends exactly at t_end [s].
double step_taken(const RunSpec& spec);

/// Time at which a run is compared: `at`; the first sum of steps that reaches it; or that many steps.
double end_time(const Measure& measure, double dt);

}  // namespace ordo::studies

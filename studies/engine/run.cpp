#include "studies/engine/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "studies/engine/measure.hpp"
#include "studies/engine/thread_time.hpp"
#include "studies/amplification/figures.hpp"

namespace ordo::studies {
namespace {

/// Processor time of this thread and of the helpers of the simulation, once there is one.
struct RunClock {
    const solvers::Simulation* simulation = nullptr;

    double seconds() const { return thread_seconds() + (simulation ? simulation->helper_seconds() : 0); }
};

/// Adds the processor time of its own life to `seconds`.
struct Timed {
    double& seconds;
    const RunClock& clock;
    double begin = clock.seconds();

    ~Timed() { seconds += clock.seconds() - begin; }
};

/// True once the study is interrupted or the run has used up its processor time; `late` tells the second. The wall's
/// clock costs less to read between two steps: it says when to look at the other, every millisecond.
solvers::Interrupt interrupt_of(const RunSpec& spec, const std::function<bool()>& stop, const RunClock& used,
                                bool& late) {
    if (!spec.timeout_s) return stop;
    using clock = std::chrono::steady_clock;
    return [&stop, &used, &late, limit = used.seconds() + *spec.timeout_s, look = clock::now()]() mutable {
        if (const auto now = clock::now(); now >= look) {
            late = used.seconds() > limit;
            look = now + std::chrono::milliseconds(1);
        }
        return late || stop();
    };
}

std::vector<RunFigure> figures(const std::vector<solvers::Figure>& from) {
    std::vector<RunFigure> to;
    for (const auto& [name, value] : from) to.push_back({name, value});
    return to;
}

/// Larger of both, quantity by quantity; NaN stays NaN.
void raise(std::vector<RunFigure>& largest, const std::vector<RunFigure>& now) {
    for (std::size_t k = 0; k < now.size(); ++k) {
        if (!(now[k].value <= largest[k].value))
            largest[k].value = std::isnan(largest[k].value) ? largest[k].value : now[k].value;
    }
}

/// The errors at the end, or the largest over the ends of all steps; and the snapshot at the end.
struct Measured {
    std::vector<RunFigure> errors;
    solvers::Snapshot last;
};

Measured run_and_measure(solvers::Simulation& simulation, const RunSpec& spec, const oracles::Exact& exact,
                         const Parts& parts, const solvers::Interrupt& interrupt, const RunClock& clock,
                         double& seconds) {
    const auto& quantities = spec.measure.quantities;
    const auto advance_to = [&](double t) {
        const Timed timed{seconds, clock};
        simulation.advance_to(t, interrupt);
    };
    if (!quantities.front().maximum) {
        advance_to(spec.t_end);
        auto last = simulation.snapshot();
        return {parts.errors(quantities, last, exact), std::move(last)};
    }
    Measured largest{{}, simulation.snapshot()};
    largest.errors = parts.errors(quantities, largest.last, exact);
    const long steps = solvers::steps_to(spec.t_end, spec.plan.dt);
    for (long k = 1; k <= steps; ++k) {
        const double t = k == steps ? spec.t_end : spec.t_end * static_cast<double>(k) / static_cast<double>(steps);
        advance_to(t);
        largest.last = simulation.snapshot();
        raise(largest.errors, parts.errors(quantities, largest.last, exact));
    }
    return largest;
}

bool needs_truth(const Quantity& quantity) { return quantity.against == Against::exact; }

bool finite(const solvers::Snapshot& shot, std::string& which) {
    for (const auto& field : shot.fields) {
        for (const double value : field.values) {
            if (std::isfinite(value)) continue;
            which = field.name;
            return false;
        }
    }
    return true;
}

void run_to_end(const RunSpec& spec, const Parts& parts, const solvers::Interrupt& interrupt, RunClock& clock,
                RunOutcome& outcome) {
    if (spec.measure.stability) {
        const Timed timed{outcome.run.seconds, clock};
        return find_stability(spec, parts, interrupt, outcome.run);
    }
    const SceneEntry& scene = parts.scene(spec.scene.name);
    const auto& solver = parts.solver(spec.solver.name);
    const auto problem = scene.problem(spec.scene.values);
    Run& run = outcome.run;
    const auto simulation = [&] {
        const Timed timed{run.seconds, clock};
        return solver.start(problem, spec.solver.options, spec.resolution, spec.measure.fields);
    }();
    clock.simulation = simulation.get();
    run.seconds += simulation->helper_seconds();
    const bool asks_for_truth = std::ranges::any_of(spec.measure.quantities, needs_truth);
    const auto exact = asks_for_truth ? scene.truth(spec.scene.values) : oracles::Exact{};
    auto [errors, last] = run_and_measure(*simulation, spec, exact, parts, interrupt, clock, run.seconds);
    run.errors = std::move(errors);
    run.work = figures(simulation->work());
    run.drift = figures(simulation->drift());
    for (const auto& [what, share] : simulation->skipped()) run.skipped.push_back({what, share});
    std::string which;
    if (!finite(last, which)) throw solvers::Diverged("the " + which + " is not finite at the end");
    outcome.snapshot = std::move(last);
}

}  // namespace

const Parts& house_parts() {
    static const Parts parts{
        .scene = [](const std::string& name) -> const SceneEntry& { return scene_named(name, ""); },
        .solver = [](const std::string& name) -> const solvers::Solver& { return solvers::solver_named(name, ""); },
        .errors = errors_against_exact};
    return parts;
}

double step_taken(const RunSpec& spec) {
    return spec.t_end / static_cast<double>(solvers::steps_to(spec.t_end, spec.plan.dt));
}

Run planned_run(const RunSpec& spec) {
    Run run;
    run.id = spec.id;
    run.solver = spec.solver.label;
    run.axes = spec.axes;
    run.h = spec.plan.h;
    run.dt = step_taken(spec);
    run.t = spec.t_end;
    return run;
}

RunOutcome executed(const RunSpec& spec, const std::function<bool()>& stop, const Parts& parts) {
    RunOutcome outcome{planned_run(spec), {}};
    Run& run = outcome.run;
    bool late = false;
    RunClock clock;
    const auto ends = [&](Status status, const std::string& reason) {
        run.status = status;
        run.reason = reason;
        run.errors.clear();
        outcome.snapshot.reset();
    };
    try {
        run_to_end(spec, parts, interrupt_of(spec, stop, clock, late), clock, outcome);
    } catch (const solvers::Interrupted&) {
        if (!late) throw;
        ends(Status::timed_out, "passed its time limit");
    } catch (const solvers::Diverged& blown_up) {
        ends(Status::diverged, blown_up.what());
    } catch (const std::exception& error) {
        ends(Status::failed, error.what());
    }
    return outcome;
}

}  // namespace ordo::studies

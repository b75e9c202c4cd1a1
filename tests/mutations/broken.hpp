#pragma once
// One part of every run in place of the house's.
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "tests/mutations/mutation.hpp"

namespace ordo::tests {

/// This solver in place of the house's of the same name.
Broken with_solver(solvers::Solver changed);

/// The solver `name` started on a changed problem; `change(problem, plan)` knows h and dt.
template <class Problem, class Change>
Broken on_problem(const std::string& name, Change change) {
    solvers::Solver solver = solvers::solver_named(name, "");
    solver.start = [house = solver, change](const solvers::Scene& scene, const Values& options,
                                            const Values& resolution, std::span<const std::string> fields) {
        auto problem = std::get<Problem>(scene);
        change(problem, house.plan(scene, options, resolution));
        return house.start(problem, options, resolution, fields);
    };
    return with_solver(std::move(solver));
}

/// The solver `name` started with other options or at another resolution than the study says.
using Rewrite = std::function<void(Given& options, Given& resolution)>;
Broken with_choices(const std::string& name, const Rewrite& rewrite);

/// What stands between a simulation and the engine. `clock(t, plan)`: the time it really goes to; `shown`: what becomes
/// of a snapshot, which says that it is at the time asked for. Either may be empty.
struct Veil {
    std::function<double(double t, const solvers::Plan& plan)> clock{};
    std::function<void(solvers::Snapshot& shot, const solvers::Plan& plan)> shown{};
};
Broken behind(const std::string& name, const Veil& veil);

/// The truth of the study's scene becomes `change(values, truth)`.
using ChangeTruth = std::function<oracles::Exact(const Values& values, oracles::Exact truth)>;
Broken with_truth(const ChangeTruth& change);

/// What is measured of each run.
using Errors = std::function<std::vector<studies::RunFigure>(const std::vector<studies::Quantity>&,
                                                             const solvers::Snapshot&, const oracles::Exact&)>;
Broken with_errors(const Errors& errors);

/// Found and exact values of one field, n x components, and weights, n.
struct Compared {
    std::vector<double> found, exact, weights;
    std::size_t components = 1;

    double error(std::size_t point) const;  ///< Euclidean length of the difference at a point
};

/// Another norm for every quantity.
Broken with_norm(const std::function<double(const Compared&)>& norm);

/// Another plan, or another list of runs.
Broken with_plan(const std::function<void(std::vector<studies::RunSpec>&)>& change);
Broken with_runs(const std::function<void(std::vector<studies::Run>&)>& change);

}  // namespace ordo::tests

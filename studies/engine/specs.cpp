#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/text.hpp"
#include "studies/engine/run.hpp"
#include "studies/engine/scene_entry.hpp"

namespace ordo::studies {
namespace {

constexpr std::size_t most_runs = 100'000;
constexpr double most_steps = 1e9;

using Point = std::vector<RunFigure>;

/// Axes that are stepped through together count as one.
std::vector<Point> points_of(const Study& study) {
    const Sweep& sweep = study.sweep;
    std::vector<Point> points{{}};
    bool dt_zipped = false;
    for (const auto& axis : sweep.axes) dt_zipped = dt_zipped || (sweep.path == Path::joint && axis.name == "dt");
    for (const auto& axis : sweep.axes) {
        if (dt_zipped && axis.name == "dt") continue;
        if (points.size() * axis.values.size() > most_runs)
            throw InputError("/sweep", "asks for more than " + std::to_string(most_runs) + " runs");
        std::vector<Point> longer;
        for (const auto& point : points) {
            for (std::size_t k = 0; k < axis.values.size(); ++k) {
                longer.push_back(point);
                longer.back().push_back({axis.name, axis.values[k]});
                if (!dt_zipped || axis.name != width_axis(study.solvers)) continue;
                for (const auto& other : sweep.axes) {
                    if (other.name == "dt") longer.back().push_back({"dt", other.values[k]});
                }
            }
        }
        points = std::move(longer);
    }
    return points;
}

/// The points along the axes that the solver knows, each once.
std::vector<Point> points_for(const solvers::Solver& solver, const std::vector<Point>& points) {
    std::vector<Point> own;
    std::set<std::vector<double>> seen;
    for (Point point : points) {
        std::erase_if(point,
                      [&](const RunFigure& axis) { return find_parameter(solver.resolution, axis.name) == nullptr; });
        std::vector<double> values;
        for (const auto& axis : point) values.push_back(axis.value);
        if (seen.insert(std::move(values)).second) own.push_back(std::move(point));
    }
    return own;
}

std::string text_of_point(const Point& point) {
    std::string text;
    for (const auto& [name, value] : point) text += (text.empty() ? "" : ", ") + name + " = " + shortest(value);
    return text;
}

RunSpec spec_of(const Study& study, const SolverChoice& choice, const Point& point, const solvers::Scene& problem,
                const Range& times) {
    const auto& solver = solvers::solver_named(choice.name, "");
    Given given;
    for (const auto& [name, value] : point) given.emplace(name, value);
    const std::string where = study.name + ": run " + choice.label + ", " + text_of_point(point);
    RunSpec spec;
    spec.scene = study.scene;
    spec.solver = choice;
    spec.axes = point;
    spec.resolution = resolve(solver.resolution, given, where, "solver " + solver.name);
    spec.measure = study.measure;
    spec.timeout_s = study.timeout_s;
    try {
        spec.plan = solver.plan(problem, choice.options, spec.resolution);
    } catch (const InputError& error) {
        throw InputError(where, error.what());
    }
    const double steps = study.measure.until == Until::steps ? study.measure.at : study.measure.at / spec.plan.dt;
    if (!(steps < most_steps)) throw InputError(where, "asks for more than " + shortest(most_steps) + " steps");
    spec.t_end = end_time(study.measure, spec.plan.dt);
    if (!times.contains(spec.t_end))
        throw InputError(
            where, "ends at t = " + shortest(spec.t_end) + ", but the exact solution holds for t " + times.text());
    spec.cost = spec.plan.points * steps;
    return spec;
}

}  // namespace

double end_time(const Measure& measure, double dt) {
    if (measure.until == Until::exact) return measure.at;
    if (measure.until == Until::steps) return measure.at * dt;
    double t = 0;
    while (t < measure.at) t += dt;
    return t;
}

std::vector<RunSpec> specs_of(const Study& study) {
    const auto& scene = scene_named(study.scene.name, "");
    const auto problem = scene.problem(study.scene.values);
    const Range times = scene.truth(study.scene.values).times;
    const auto points = points_of(study);
    std::vector<RunSpec> specs;
    for (const auto& choice : study.solvers) {
        for (const auto& point : points_for(solvers::solver_named(choice.name, ""), points)) {
            specs.push_back(spec_of(study, choice, point, problem, times));
            specs.back().id = static_cast<int>(specs.size()) - 1;
        }
    }
    if (specs.size() > most_runs)
        throw InputError("/sweep", "asks for more than " + std::to_string(most_runs) + " runs");
    return specs;
}

}  // namespace ordo::studies

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "studies/engine/run.hpp"
#include "studies/engine/scene_entry.hpp"

namespace ordo::studies {
namespace {

constexpr std::size_t most_runs = 100'000;
constexpr double most_steps = 1e9;

using Point = std::vector<RunFigure>;

[[noreturn]] void refuse_so_many() {
    throw InputError("/sweep", "asks for more than " + std::to_string(most_runs) + " runs");
}

/// The points along the axes that the solver knows. Axes that are stepped through together count as one.
std::vector<Point> points_of(const Sweep& sweep, const SolverChoice& choice) {
    const auto& known = solvers::solver_named(choice.name, "").resolution;
    const Axis* zipped = nullptr;
    for (const auto& axis : sweep.axes) {
        if (sweep.path == Path::joint && axis.name == "dt") zipped = &axis;
    }
    std::vector<Point> points{{}};
    for (const auto& axis : sweep.axes) {
        if (&axis == zipped || find_parameter(known, axis.name) == nullptr) continue;
        if (points.size() * axis.values.size() > most_runs) refuse_so_many();
        const bool pulls = zipped != nullptr && axis.name == width_axis(choice) && find_parameter(known, "dt");
        std::vector<Point> longer;
        for (const auto& point : points) {
            for (std::size_t k = 0; k < axis.values.size(); ++k) {
                longer.push_back(point);
                longer.back().push_back({axis.name, axis.values[k]});
                if (pulls) longer.back().push_back({"dt", zipped->values[k]});
            }
        }
        points = std::move(longer);
    }
    return points;
}

std::string text_of_point(const Point& point) {
    std::string text;
    for (const auto& [name, value] : point) text += (text.empty() ? "" : ", ") + name + " = " + shortest(value);
    return text;
}

/// Whether it has a time step to choose; iterations and events have none.
bool takes_steps(const solvers::Solver& solver) {
    return find_parameter(solver.resolution, "dt") || find_parameter(solver.resolution, "courant");
}

RunSpec spec_of(const Study& study, const SolverChoice& choice, const Point& point, const solvers::Scene& problem,
                const Range& times) {
    const auto& solver = solvers::solver_named(choice.name, "");
    Given given;
    for (const auto& [name, value] : point) given.emplace(name, value);
    const auto& stability = study.measure.stability;
    if (stability) given.emplace("courant", 1.0);
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
    if (study.measure.until != Until::exact && !takes_steps(solver))
        throw InputError(where, "solver " + solver.name + " takes no steps, so measure.until must be exact");
    if (stability) {
        const auto swept = std::ranges::find(point, "courant", &RunFigure::name);
        spec.courant = swept == point.end() ? 0 : swept->value;
        spec.t_end = stability->crossings * spec.plan.dt / spec.resolution.number("courant");
        constexpr double runs = 30;  // of a search
        spec.cost = spec.plan.points * stability->crossings * (swept == point.end() ? runs : 1);
        return spec;
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
    std::vector<RunSpec> specs;
    for (const auto& choice : study.solvers) {
        for (const auto& point : points_of(study.sweep, choice)) {
            specs.push_back(spec_of(study, choice, point, problem, times));
            specs.back().id = static_cast<int>(specs.size()) - 1;
        }
        if (specs.size() > most_runs) refuse_so_many();
    }
    return specs;
}

}  // namespace ordo::studies

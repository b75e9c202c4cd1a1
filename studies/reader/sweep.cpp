#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "solvers/solver.hpp"
#include "studies/reader/parts.hpp"

namespace ordo::studies {
namespace {

constexpr std::size_t most_values = 10'000;

Axis axis_from(const Node& node) {
    Axis axis{node.key(), {}};
    for (const auto& item : node.items()) {
        const double value = item.number();
        if (std::find(axis.values.begin(), axis.values.end(), value) != axis.values.end()) {
            item.refuse("the value " + shortest(value) + " is repeated");
        }
        axis.values.push_back(value);
    }
    if (axis.values.empty()) node.refuse("is an empty list");
    if (axis.values.size() > most_values) node.refuse("has more than " + std::to_string(most_values) + " values");
    return axis;
}

const Axis* find_axis(const Sweep& sweep, const std::string& name) {
    for (const auto& axis : sweep.axes) {
        if (axis.name == name) return &axis;
    }
    return nullptr;
}

/// A path says which error it shows, so the axes must leave the other one alone. Of one solver: its own width axis.
void check_path(const Node& node, const Sweep& sweep, const std::string& width_name) {
    const Axis* width = find_axis(sweep, width_name);
    const Axis* dt = find_axis(sweep, "dt");
    const bool courant = find_axis(sweep, "courant") != nullptr;
    if (sweep.path == Path::space && courant) {
        node.refuse("path 'space' keeps dt fixed, but with 'courant' dt follows h (nearest: path 'joint')");
    }
    if (sweep.path == Path::time && dt == nullptr && !courant)
        node.refuse("path 'time' needs the axis 'dt' or 'courant'");
    if (courant && dt != nullptr) node.refuse("has both 'dt' and 'courant', but a step is given by one of them");
    const auto several = [](const Axis* axis) { return axis != nullptr && axis->values.size() > 1; };
    if (sweep.path == Path::grid && (!several(width) || !several(dt))) {
        node.refuse("path 'grid' needs several values of '" + width_name + "' and of 'dt'");
    }
    if (sweep.path != Path::joint || courant) return;
    if (width == nullptr || dt == nullptr || width->values.size() != dt->values.size()) {
        node.refuse("path 'joint' needs 'courant', a 'coupling', or as many values of 'dt' as of '" + width_name + "'");
    }
}

/// A solver that is given no step follows its width alone; others must not leave it without one.
bool takes_steps(const SolverChoice& choice) {
    const auto& known = solvers::solver_named(choice.name, "").resolution;
    return find_parameter(known, "dt") != nullptr || find_parameter(known, "courant") != nullptr;
}

double above_zero(const Node& node) {
    const double value = node.number();
    if (!(value > 0) || !std::isfinite(value)) node.refuse("is " + shortest(value) + ", but must be > 0");
    return value;
}

/// h that the solver plans with the first value of every axis but the width's.
double width_at(double value, const SolverChoice& choice, const Sweep& sweep, const solvers::Scene& problem,
                const Node& node) {
    const auto& solver = solvers::solver_named(choice.name, "");
    Given given{{"dt", node.at("dt").number()}};
    for (const auto& axis : sweep.axes) {
        if (find_parameter(solver.resolution, axis.name) != nullptr)
            given[axis.name] = axis.name == solver.width_axis ? value : axis.values.front();
    }
    return solver.plan(problem, choice.options, resolve(solver.resolution, given, node.where(), solver.name)).h;
}

/// dt = C h^k beside each value of the width axis, from {"dt": C, "power": k}: the axis that path 'joint' zips.
Axis coupled_steps(const Node& node, const Sweep& sweep, const std::vector<SolverChoice>& choices,
                   const solvers::Scene& problem) {
    node.only({"dt", "power"});
    const double factor = above_zero(node.at("dt")), power = above_zero(node.at("power"));
    if (sweep.path != Path::joint) node.refuse("belongs to path 'joint' only");
    if (find_axis(sweep, "dt") != nullptr || find_axis(sweep, "courant") != nullptr)
        node.refuse("gives the step, so that 'dt' and 'courant' must not be swept");
    Axis steps{"dt", {}};
    for (const auto& choice : choices) {
        if (find_parameter(solvers::solver_named(choice.name, "").resolution, "dt") == nullptr) continue;
        const Axis* width = find_axis(sweep, width_axis(choice));
        if (width == nullptr) node.refuse("needs the axis '" + width_axis(choice) + "'");
        std::vector<double> own;
        for (const double value : width->values)
            own.push_back(factor * std::pow(width_at(value, choice, sweep, problem, node), power));
        if (!steps.values.empty() && own != steps.values)
            node.refuse("solvers differ in h, so that they would differ in dt; give them a study each");
        steps.values = std::move(own);
    }
    if (steps.values.empty()) node.refuse("no solver takes a 'dt'");
    return steps;
}

}  // namespace

Sweep sweep_from(const Node& node, const std::vector<SolverChoice>& choices, const solvers::Scene& problem) {
    if (!node.is_object() || node.json().empty()) node.refuse("must be an object with at least one axis");
    Sweep sweep;
    const auto path = node.at("path").one_of({"space", "time", "joint", "grid"});
    sweep.path = static_cast<Path>(path);
    for (const auto& member : node.members()) {
        if (member.key() == "path" || member.key() == "coupling") continue;
        sweep.axes.push_back(axis_from(member));
        bool known = choices.empty();
        for (const auto& choice : choices) {
            const auto& declared = solvers::solver_named(choice.name, "").resolution;
            const Parameter* parameter = find_parameter(declared, member.key());
            if (parameter == nullptr) continue;
            known = true;
            for (const auto& item : member.items()) check_value(*parameter, item.number(), item.where());
        }
        if (known) continue;
        const auto& declared = solvers::solver_named(choices.front().name, "").resolution;
        member.refuse("is not a resolution of solver " + choices.front().name +
                      did_you_mean(member.key(), names_of(declared)));
    }
    if (node.has("coupling")) sweep.axes.push_back(coupled_steps(node.at("coupling"), sweep, choices, problem));
    const bool mixed = std::any_of(choices.begin(), choices.end(), takes_steps);
    for (const auto& choice : choices) {
        if (takes_steps(choice) || !mixed) check_path(node, sweep, width_axis(choice));
    }
    return sweep;
}

}  // namespace ordo::studies

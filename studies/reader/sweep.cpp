#include <algorithm>

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
        node.refuse("path 'joint' needs 'courant', or as many values of 'dt' as of '" + width_name + "'");
    }
}

/// A solver that is given no step follows its width alone; others must not leave it without one.
bool takes_steps(const SolverChoice& choice) {
    const auto& known = solvers::solver_named(choice.name, "").resolution;
    return find_parameter(known, "dt") != nullptr || find_parameter(known, "courant") != nullptr;
}

}  // namespace

Sweep sweep_from(const Node& node, const std::vector<SolverChoice>& choices) {
    if (!node.is_object() || node.json().empty()) node.refuse("must be an object with at least one axis");
    Sweep sweep;
    const auto path = node.at("path").one_of({"space", "time", "joint", "grid"});
    sweep.path = static_cast<Path>(path);
    for (const auto& member : node.members()) {
        if (member.key() == "path") continue;
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
    const bool mixed = std::any_of(choices.begin(), choices.end(), takes_steps);
    for (const auto& choice : choices) {
        if (takes_steps(choice) || !mixed) check_path(node, sweep, width_axis(choice));
    }
    return sweep;
}

}  // namespace ordo::studies

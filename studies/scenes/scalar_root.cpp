// One root of (x - root)(x - other_root) = 0 by iteration: the smallest problem whose order of convergence is known.
// The observed order is the slope of the error against the last correction; what the errors of each iteration are, the
// oracle scalar_root_convergence knows to all digits.   [Brannon2011]
#include <array>

#include "oracles/scalar_root_convergence.hpp"
#include "studies/engine/scene_entry.hpp"

namespace ordo::studies {
namespace {

solvers::Scene problem(const Values& values) {
    const double a = values.number("root");
    const double b = values.number("other_root");
    return solvers::ScalarEquation{.f = [=](double x) { return (x - a) * (x - b); },
                                   .slope = [=](double x) { return (x - a) + (x - b); },
                                   .start = values.number("start"),
                                   .second_start = values.number("second_start")};
}

/// Whatever the iteration, after any number of them: the root.
oracles::Exact truth(const Values& values) {
    const auto root = [a = values.number("root")](double, double) { return std::array{a}; };
    return {.dim = 1,
            .coordinates = oracles::Coordinates::material,
            .lower = {0},
            .upper = {1e9},
            .fields = {{"root", "-", 0}},
            .sample = oracles::along_a_line(root),
            .jumps = oracles::no_jumps};
}

std::vector<Parameter> parameters() {
    std::vector<Parameter> kept;
    for (const auto& parameter : oracles::scalar_root_convergence().parameters) {
        if (parameter.name != "method" && parameter.name != "iterations") kept.push_back(parameter);
    }
    return kept;
}

const bool enrolled = enrol({.name = "scalar_root",
                             .about = "One root of a quadratic by iteration",
                             .source = {"Brannon2011"},
                             .units = "dimensionless",
                             .parameters = parameters(),
                             .oracle = "scalar_root_convergence",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

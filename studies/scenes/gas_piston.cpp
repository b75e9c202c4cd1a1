// A uniform gas on [x0, x0 + length] with a rigid wall on its left that moves into it (a shock), away from it (a fan),
// or stands while the gas streams against it (a reflected shock); on its right the gas goes on without end. What is
// observed begins at the wall, wherever that is.   [Toro2009]
#include "oracles/lines/gas_piston.hpp"

#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/lines.hpp"

namespace ordo::studies {
namespace {

using solvers::LineEnd;

std::vector<Parameter> parameters() {
    return appended(oracles::gas_piston().parameters,
                    {number("length", "m", 5, positive, "of the gas that is observed at t = 0")});
}

oracles::Exact truth(const Values& values) { return exact_of(oracles::gas_piston(), values); }

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const solvers::IdealGas gas{values.number("gamma")};
    const double x0 = values.number("x0");
    const LineEnd wall{.kind = LineEnd::Kind::wall, .velocity = values.number("V")};
    return solvers::LineScene{.medium = gas,
                              .edges = {x0, x0 + values.number("length")},
                              .pieces = {gas_contents(gas, values, "")},
                              .ends = {wall, LineEnd{}}};
}

const bool enrolled = enrol({.name = "gas_piston",
                             .about = "A gas beside a wall that moves into it or away from it, or that stops it",
                             .source = {"Toro2009"},
                             .units = "dimensionless",
                             .parameters = parameters(),
                             .oracle = "gas_piston",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

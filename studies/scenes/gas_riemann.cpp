// Two uniform ideal gases that touch: the shock tube of Sod and the tests of Toro. Both gases go on without end, so
// that the observed piece of the line need only hold the waves. Vacuum, stiffened gases and two gammas, which the
// truth knows too, are left out: the medium is one ideal gas.   [Walker2012], [Toro2009]
#include "oracles/riemann/gas_record.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/lines.hpp"

namespace ordo::studies {
namespace {

std::vector<Parameter> parameters() {
    const auto left = oracles::gas_parameters("_L", {.rho = 1, .v = 0, .p = 1}, "on the left");
    const auto right = oracles::gas_parameters("_R", {.rho = 0.125, .v = 0, .p = 0.1}, "on the right");
    const auto both = appended(left, right);
    return appended(appended(both, {oracles::gamma_parameter(), number("x0", "m", 0, finite, "where they touch")}),
                    observed_parameters(-5, 5));
}

oracles::Exact truth(const Values& values) { return exact_of(oracles::riemann_gas(), values); }

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const solvers::IdealGas gas{values.number("gamma")};
    return solvers::LineScene{.medium = gas,
                              .edges = rising("gas_riemann", values, {"x_left", "x0", "x_right"}),
                              .pieces = {gas_contents(gas, values, "_L"), gas_contents(gas, values, "_R")}};
}

const bool enrolled = enrol({.name = "gas_riemann",
                             .about = "Two uniform ideal gases that touch at t = 0: Sod's tube, Toro's tests",
                             .source = {"Walker2012", "Toro2009"},
                             .units = "dimensionless",
                             .parameters = parameters(),
                             .oracle = "riemann_gas",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

// Two uniform states of a linear elastic line that meet. Heat exerts no stress here and travels with the material:
// the contact is a jump of temperature alone.   [Walker2017]
#include "oracles/riemann/riemann_linear_elastic.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/lines.hpp"

namespace ordo::studies {
namespace {

std::vector<Parameter> parameters() {
    return appended(oracles::riemann_linear_elastic().parameters, observed_parameters(-2.5, 2.5));
}

oracles::Exact truth(const Values& values) { return exact_of(oracles::riemann_linear_elastic(), values); }

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const auto medium = elastic_medium("linear", values);
    return solvers::LineScene{
        .medium = medium,
        .edges = rising("linear_elastic_riemann", values, {"x_left", "x0", "x_right"}),
        .pieces = {elastic_contents(medium, values, "_L"), elastic_contents(medium, values, "_R")}};
}

const bool enrolled = enrol({.name = "linear_elastic_riemann",
                             .about = "Two uniform states of a linear elastic line with heat that meet at t = 0",
                             .source = {"Walker2017"},
                             .units = "dimensionless",
                             .parameters = parameters(),
                             .oracle = "riemann_linear_elastic",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

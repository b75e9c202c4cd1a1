// The blast of linear elasticity: a crushed slug at rest in a relaxed line is let go and splits into two pulses. Heat
// exerts no stress in this law, so that a point release of heat, as in a gas, would move nothing.   [Walker2017]
#include "oracles/blasts/sedov_linear_elastic.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/lines.hpp"

namespace ordo::studies {
namespace {

std::vector<Parameter> parameters() {
    return appended(oracles::sedov_linear_elastic().parameters, observed_parameters(-2.5, 2.5));
}

oracles::Exact truth(const Values& values) { return exact_of(oracles::sedov_linear_elastic(), values); }

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const auto medium = elastic_medium("linear", values);
    const double stretch = values.number("lambda_c");
    const double T = values.number("T");
    const auto relaxed = elastic_contents(medium, 1, 0, T);
    return solvers::LineScene{.medium = medium,
                              .edges = around("slug_release", values, stretch * values.number("L0")),
                              .pieces = {relaxed, elastic_contents(medium, stretch, 0, T), relaxed}};
}

const bool enrolled = enrol({.name = "slug_release",
                             .about = "A crushed slug in a linear elastic line is let go and splits into two pulses",
                             .source = {"Walker2017"},
                             .units = "dimensionless",
                             .parameters = parameters(),
                             .oracle = "sedov_linear_elastic",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

// Two uniform states of a nonlinear elastic line that meet: material A, B or C, whose heat pushes outwards. Shocks
// compress and heat, rarefactions stretch, and across the contact temperature and density jump.   [Walker2017]
#include "oracles/riemann/riemann_nonlinear_elastic.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/lines.hpp"

namespace ordo::studies {
namespace {

std::vector<Parameter> parameters() {
    return appended(oracles::riemann_nonlinear_elastic().parameters, observed_parameters(-4, 4));
}

oracles::Exact truth(const Values& values) { return exact_of(oracles::riemann_nonlinear_elastic(), values); }

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const auto medium = elastic_medium(values.word("material"), values);
    return solvers::LineScene{
        .medium = medium,
        .edges = rising("nonlinear_elastic_riemann", values, {"x_left", "x0", "x_right"}),
        .pieces = {elastic_contents(medium, values, "_L"), elastic_contents(medium, values, "_R")}};
}

const bool enrolled = enrol({.name = "nonlinear_elastic_riemann",
                             .about = "Two uniform states of a nonlinear elastic line with heat that meet at t = 0",
                             .source = {"Walker2017"},
                             .units = "dimensionless",
                             .parameters = parameters(),
                             .oracle = "riemann_nonlinear_elastic",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

// Heat released in a thin strip of cold, relaxed nonlinear elastic material: to leading order in 1/M^2 a planar blast
// of gas with gamma = k + 1. The strip of `width` stands for the truth's plane: what it changes is of the order of
// width / R. It holds twice the truth's energy, which counts one side.   [Walker2017], [KammTimmes2007]
#include "oracles/blasts/sedov_nonlinear_elastic.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/lines.hpp"

namespace ordo::studies {
namespace {

std::vector<Parameter> parameters() {
    const auto width =
        number("width", "m", 0.002, positive, "of the strip, around x = 0, in which the heat is released");
    return appended(appended(oracles::sedov_nonlinear_elastic().parameters, {width}), observed_parameters(-0.75, 0.75));
}

oracles::Exact truth(const Values& values) { return exact_of(oracles::sedov_nonlinear_elastic(), values); }

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const auto medium = elastic_medium(values.word("material"), values);
    const double width = values.number("width");
    const double T = 2 * values.number("energy") / (width * values.number("c_v"));
    const auto cold = elastic_contents(medium, 1, 0, 0);
    return solvers::LineScene{.medium = medium,
                              .edges = around("elastic_blast", values, width),
                              .pieces = {cold, elastic_contents(medium, 1, 0, T), cold}};
}

const bool enrolled = enrol({.name = "elastic_blast",
                             .about = "Heat released in a thin strip of a nonlinear elastic line: a strong blast",
                             .source = {"Walker2017", "KammTimmes2007"},
                             .units = "dimensionless",
                             .parameters = parameters(),
                             .oracle = "sedov_nonlinear_elastic",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

// Bar under end traction: an elastic bar along x, at rest and unstressed, fixed at X = 0, is pulled at X = L by a sine
// or a step of nominal traction. Its truth is exact at any strain for the law E(F-1); for the others the difference is
// O(strain^2) and independent of the mesh. The step acts at t = 0 already, so that the first time step feels it.
// [Steffen2008], [MPMtry]
#include "oracles/bars/bar_traction.hpp"

#include <cmath>

#include "core/elastic_constants.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/fields.hpp"

namespace ordo::studies {
namespace {

using solvers::Face;
using solvers::Vec;

std::vector<Parameter> parameters() {
    return appended(oracles::bar_traction().parameters, {solvers::law_parameter("E(F-1)")});
}

oracles::Exact truth(const Values& values) { return oracles::bar_traction().bind(values); }

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const double L = values.number("L");
    const double tau = values.number("tau");
    const double omega = values.number("omega");
    const bool sine = values.word("profile") == "sine";
    const double E = youngs_modulus(values, 100, "scene bar_traction");
    return solvers::SolidScene<1>{
        .lower = Vec<1>(0.0),
        .upper = Vec<1>(L),
        .rho = values.number("rho"),
        .law = solvers::make_law(values.word("law"), {.lambda = 0, .mu = E / 2}),
        .faces = {{{Face::fixed, Face::free}}},
        .velocity = at_rest(),
        .traction = traction_at_end(L, [=](double t) { return sine ? tau * std::sin(omega * t) : tau; })};
}

const bool enrolled = enrol({.name = "bar_traction",
                             .about = "Elastic bar, fixed at one end, under a sine or a step of traction at the other",
                             .source = {"Steffen2008", "MPMtry", "SR22"},
                             .units = "SI",
                             .parameters = parameters(),
                             .oracle = "bar_traction",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

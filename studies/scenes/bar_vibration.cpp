// Vibrating bar: an elastic bar along x, fixed at one end or at both, starts unstressed with a sine of velocity.
// The oldest error tables of MPM are about it. Its truth is exact at any strain for the law E(F-1); for the other two
// the difference is O(strain^2) and independent of the mesh.   [WobbesTielen2015], [MPMtry]
#include "oracles/bars/bar_vibration.hpp"

#include <cmath>
#include <numbers>

#include "core/elastic_constants.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/fields.hpp"

namespace ordo::studies {
namespace {

using solvers::Face;
using solvers::Vec;

solvers::Scene problem(const Values& values) {
    const bool free_end = values.word("ends") == "fixed_free";
    const double L = values.number("L");
    const double quarter_waves = free_end ? 2 * values.whole("mode") - 1 : 2 * values.whole("mode");
    const double v0 = values.number("v0");
    const auto sine = [=](double X, double) { return v0 * std::sin(quarter_waves * std::numbers::pi / 2 * X / L); };
    return solvers::SolidScene<1>{
        .lower = Vec<1>(0.0),
        .upper = Vec<1>(L),
        .rho = values.number("rho"),
        .law = solvers::make_law(values.word("law"),
                                 {.lambda = 0, .mu = youngs_modulus(values, 100, "scene bar_vibration") / 2}),
        .faces = {{{Face::fixed, free_end ? Face::free : Face::fixed}}},
        .velocity = along_x(sine)};
}

std::vector<Parameter> parameters() {
    return appended(oracles::bar_vibration().parameters, {solvers::law_parameter("E(F-1)")});
}

oracles::Exact truth(const Values& values) {
    Given given = values.all();
    given.erase("law");
    return oracles::bar_vibration().bind(Values(given));
}

const bool enrolled = enrol({.name = "bar_vibration",
                             .about = "Elastic bar, fixed at one end or at both, started with a sine of velocity",
                             .source = {"WobbesTielen2015", "MPMtry"},
                             .units = "SI",
                             .parameters = parameters(),
                             .oracle = "bar_vibration",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

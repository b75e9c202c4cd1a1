// Vibrating bar: an elastic bar along x, fixed at one end or at both, or periodic, starts unstressed with a sine of
// velocity.
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
    const std::string ends = values.word("ends");
    const double L = values.number("L");
    const int mode = values.whole("mode");
    const double quarter_waves = ends == "fixed_free" ? 2 * mode - 1 : ends == "fixed_fixed" ? 2 * mode : 4 * mode;
    const Face lower = ends == "periodic" ? Face::periodic : Face::fixed;
    const Face upper = ends == "fixed_free" ? Face::free : lower;
    const double v0 = values.number("v0");
    const auto sine = [=](double X, double) { return v0 * std::sin(quarter_waves * std::numbers::pi / 2 * X / L); };
    return solvers::SolidScene<1>{
        .lower = Vec<1>(0.0),
        .upper = Vec<1>(L),
        .rho = values.number("rho"),
        .law = solvers::make_law(values.word("law"),
                                 {.lambda = 0, .mu = youngs_modulus(values, 100, "scene bar_vibration") / 2}),
        .faces = {{{lower, upper}}},
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

const bool enrolled =
    enrol({.name = "bar_vibration",
           .about = "Elastic bar, fixed at one end or at both or periodic, started with a sine of velocity",
           .source = {"WobbesTielen2015", "MPMtry"},
           .units = "SI",
           .parameters = parameters(),
           .oracle = "bar_vibration",
           .problem = problem,
           .truth = truth});

}  // namespace
}  // namespace ordo::studies

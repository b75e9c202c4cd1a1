// Oedometer: an elastic column along x (the papers' y), at rest and unstressed, stands on X = 0; gravity, sudden or
// ramped, pulls it down and a nominal traction p0 acts on its top X = H from t = 0 on. Its truth is exact at any strain
// for the law E(F-1); for the others the difference is O(strain^2) and independent of the mesh. `terms` belongs to the
// truth alone: papers compare with a truncated series.   [WobbesTielen2015], [MPMtry]
#include "oracles/bars/oedometer.hpp"

#include "core/elastic_constants.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/fields.hpp"

namespace ordo::studies {
namespace {

using solvers::Face;
using solvers::Vec;

std::vector<Parameter> parameters() {
    return appended(oracles::oedometer().parameters, {solvers::law_parameter("E(F-1)")});
}

oracles::Exact truth(const Values& values) { return oracles::oedometer().bind(values); }

/// The share of gravity that acts at t >= 0: all after the time T, and the quintic with two derivatives at rest before.
double share_of_gravity(double t, double T) {
    if (t >= T) return 1;
    const double s = t / T;
    return s * s * s * (10 - 15 * s + 6 * s * s);
}

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const double H = values.number("H");
    const double g = values.number("g");
    const double p0 = values.number("p0");
    const double ramp = values.number("ramp");
    const double E = youngs_modulus(values, 5e4, "scene oedometer");
    solvers::SolidScene<1> column{.lower = Vec<1>(0.0),
                                  .upper = Vec<1>(H),
                                  .rho = values.number("rho"),
                                  .law = solvers::make_law(values.word("law"), {.lambda = 0, .mu = E / 2}),
                                  .faces = {{{Face::fixed, Face::free}}},
                                  .velocity = at_rest()};
    if (g != 0) column.body_force = along_x([=](double, double t) { return -g * share_of_gravity(t, ramp); });
    if (p0 != 0) column.traction = traction_at_end(H, [=](double) { return p0; });
    return column;
}

const bool enrolled = enrol({.name = "oedometer",
                             .about = "Elastic column under sudden or ramped gravity and a sudden load on its top",
                             .source = {"WobbesTielen2015", "MPMtry"},
                             .units = "SI",
                             .parameters = parameters(),
                             .oracle = "oedometer",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

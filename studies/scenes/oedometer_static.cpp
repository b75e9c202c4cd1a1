// Column coming to rest: the oedometer at any strain. Gravity and the load p0 on its top X = H act at once, damping in
// proportion to the mass takes the motion away, and what remains is compared with the state at rest, which is exact for
// each of the five laws. Near critical damping some 4e-8 of the motion is left at t = 40 / damping and only round-off
// at twice that; the truth does not depend on t.   [CoombsAugarde2020], [MPMtry]
#include "oracles/bars/oedometer_static.hpp"

#include <cmath>
#include <numbers>

#include "core/elastic_constants.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/fields.hpp"

namespace ordo::studies {
namespace {

using solvers::Face;
using solvers::Vec;

std::vector<Parameter> parameters() {
    const auto damping = number("damping", "1/s", 0, positive,
                                "alpha of the force -alpha v per mass; absent: pi c / H, critical for the first mode");
    return appended(oracles::oedometer_static().parameters, {without_default(damping)});
}

oracles::Exact truth(const Values& values) { return oracles::oedometer_static().bind(values); }

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const double H = values.number("H");
    const double rho = values.number("rho");
    const double g = values.number("g");
    const double p0 = values.number("p0");
    const double E = youngs_modulus(values, 1e6, "scene oedometer_static");
    const double twice_first_mode = std::numbers::pi * std::sqrt(E / rho) / H;
    solvers::SolidScene<1> column{.lower = Vec<1>(0.0),
                                  .upper = Vec<1>(H),
                                  .rho = rho,
                                  .law = solvers::make_law(values.word("law"), {.lambda = 0, .mu = E / 2}),
                                  .faces = {{{Face::fixed, Face::free}}},
                                  .velocity = at_rest(),
                                  .damping = values.has("damping") ? values.number("damping") : twice_first_mode};
    if (g != 0) column.body_force = along_x([=](double, double) { return -g; });
    if (p0 != 0) column.traction = traction_at_end(H, [=](double) { return p0; });
    return column;
}

const bool enrolled = enrol({.name = "oedometer_static",
                             .about = "Column that comes to rest under gravity and a load on its top, at any strain",
                             .source = {"CoombsAugarde2020", "MPMtry"},
                             .units = "SI",
                             .parameters = parameters(),
                             .oracle = "oedometer_static",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

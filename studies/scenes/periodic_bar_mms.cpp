// Manufactured standing wave: one period of a periodic neo-Hookean bar, which starts deformed and at rest and is kept
// in its wave by a body force made from that motion. The displacement vanishes at both ends of the period, so that they
// are held here instead of joined. It turns on the start from a deformed body.   [Steffen2008b]
#include "oracles/manufactured/periodic_bar_mms.hpp"

#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/fields.hpp"

namespace ordo::studies {
namespace {

using oracles::PeriodicBarMms;
using solvers::Face;
using solvers::Vec;

oracles::Exact truth(const Values& values) { return oracles::periodic_bar_mms().bind(values); }

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const PeriodicBarMms bar{.L = values.number("L"),
                             .A = values.number("A"),
                             .rho = values.number("rho"),
                             .E = youngs_modulus(values, PeriodicBarMms{}.E, "scene periodic_bar_mms")};
    return solvers::SolidScene<1>{
        .lower = Vec<1>(0.0),
        .upper = Vec<1>(bar.L),
        .rho = bar.rho,
        .law = solvers::NeoHookeanLaw{{.lambda = 0, .mu = bar.E / 2}},
        .faces = {{{Face::fixed, Face::fixed}}},
        .velocity = at_rest(),
        .deformed =
            solvers::Deformed<1>{.displacement = along_x([bar](double X, double) { return bar.at({X}, 0).u[0]; }),
                                 .F = along_x([bar](double X, double) { return bar.at({X}, 0).F[0]; })},
        .body_force = along_x([bar](double X, double t) { return bar.at({X}, t).b[0]; })};
}

const bool enrolled = enrol({.name = "periodic_bar_mms",
                             .about = "Neo-Hookean bar in a manufactured standing wave; starts deformed and at rest",
                             .source = {"Steffen2008b"},
                             .units = "SI",
                             .parameters = oracles::periodic_bar_mms().parameters,
                             .oracle = "periodic_bar_mms",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

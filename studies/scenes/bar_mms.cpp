// Manufactured motion of a bar: a neo-Hookean bar along x with both ends held, undeformed at t = 0, swings in its first
// mode at any amplitude, because a body force made from that motion keeps it there. A manufactured force is part of the
// exact solution: here solver and truth meet.   [Nguyen2023], [Tran2020]
#include "oracles/manufactured/bar_mms.hpp"

#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/fields.hpp"

namespace ordo::studies {
namespace {

using solvers::Face;
using solvers::Vec;

oracles::Exact truth(const Values& values) { return oracles::bar_mms().bind(values); }

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const oracles::BarMms bar{.L = values.number("L"),
                              .A = values.number("A"),
                              .rho = values.number("rho"),
                              .elastic = elastic_constants(values, oracles::BarMms{}.elastic, "scene bar_mms")};
    return solvers::SolidScene<1>{.lower = Vec<1>(0.0),
                                  .upper = Vec<1>(bar.L),
                                  .rho = bar.rho,
                                  .law = solvers::NeoHookeanLaw{{.lambda = bar.elastic.lambda, .mu = bar.elastic.G}},
                                  .faces = {{{Face::fixed, Face::fixed}}},
                                  .velocity = along_x([bar](double X, double) { return bar.at({X}, 0).v[0]; }),
                                  .body_force = [bar](std::span<const Vec<1>> X, double t, std::span<Vec<1>> b) {
                                      const auto now = bar.at(t);
                                      for (std::size_t i = 0; i < X.size(); ++i) b[i][0] = now.at(X[i][0]).b[0];
                                  }};
}

const bool enrolled = enrol({.name = "bar_mms",
                             .about = "Neo-Hookean bar with both ends held, in a manufactured motion of any amplitude",
                             .source = {"Nguyen2023", "Tran2020"},
                             .units = "SI",
                             .parameters = oracles::bar_mms().parameters,
                             .oracle = "bar_mms",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

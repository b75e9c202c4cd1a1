// A square pulse of density in a uniform stream of gas, round and round in a periodic domain: what a method does to a
// contact, and nothing else.   [Toro2009]
#include "oracles/lines/density_pulse.hpp"

#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/lines.hpp"

namespace ordo::studies {
namespace {

using solvers::LineEnd;

oracles::Exact truth(const Values& values) { return exact_of(oracles::density_pulse(), values); }

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const solvers::IdealGas gas{values.number("gamma")};
    const double begin = values.number("begin");
    const double L = values.number("L");
    const double end = begin + values.number("width");
    const auto stream = gas_contents(gas, values, "");
    const auto pulse = gas.contents(values.number("rho_pulse"), values.number("v"), values.number("p"));
    solvers::LineScene line{.medium = gas, .edges = {0}, .pieces = {}};
    const auto add = [&](double to, const solvers::Contents& piece) {
        if (!(to > line.edges.back())) return;
        line.edges.push_back(to);
        line.pieces.push_back(piece);
    };
    add(end - L, pulse);  // where it goes over the period's end
    add(begin, stream);
    add(std::min(end, L), pulse);
    add(L, stream);
    line.ends.fill({.kind = LineEnd::Kind::periodic});
    return line;
}

const bool enrolled = enrol({.name = "density_pulse",
                             .about = "A square pulse of density in a uniform stream of gas, periodic",
                             .source = {"Toro2009"},
                             .units = "dimensionless",
                             .parameters = oracles::density_pulse().parameters,
                             .oracle = "density_pulse",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

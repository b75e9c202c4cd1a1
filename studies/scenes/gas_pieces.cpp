// Uniform gas in three pieces of widths 2, 1 and 3 that differ in nothing: the 213 problem. A method of cells must not
// see the borders between them; one that books the impulse of a neighbour without end finds a velocity where there is
// none.   [Walker2012, fig. 19]
#include "oracles/riemann/gas_record.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/lines.hpp"

namespace ordo::studies {
namespace {

std::vector<Parameter> parameters() {
    return appended(oracles::gas_parameters("", {.rho = 1, .v = 0, .p = 1}, "everywhere"),
                    {oracles::gamma_parameter(), number("left", "m", 2, positive, "width of the left piece"),
                     number("middle", "m", 1, positive, "width of the middle piece"),
                     number("right", "m", 3, positive, "width of the right piece")});
}

/// Both gases of a Riemann problem, which then has no waves.
oracles::Exact truth(const Values& values) {
    Given both;
    for (const std::string name : {"rho", "v", "p"}) {
        for (const std::string side : {"_L", "_R"}) both.emplace(name + side, values.number(name));
    }
    auto exact = exact_of(oracles::riemann_gas(), values, both);
    exact.waves = [](double) { return std::vector<oracles::Wave>{}; };
    return exact;
}

solvers::Scene problem(const Values& values) {
    const solvers::IdealGas gas{values.number("gamma")};
    const auto piece = gas_contents(gas, values, "");
    const double first = values.number("left");
    const double second = first + values.number("middle");
    return solvers::LineScene{
        .medium = gas, .edges = {0, first, second, second + values.number("right")}, .pieces = {piece, piece, piece}};
}

const bool enrolled = enrol({.name = "gas_pieces",
                             .about = "One uniform gas cut into three pieces, at rest or in motion: nothing may happen",
                             .source = {"Walker2012"},
                             .units = "dimensionless",
                             .parameters = parameters(),
                             .oracle = "riemann_gas",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

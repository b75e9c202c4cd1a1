// Gas that rushes from both sides into a thinner one: two shocks run inwards, meet and pass through each other. Its two
// outer states are held at the ends x_L and x_R, which stand still (`prescribed`), or go on without end beyond them
// (`reservoir`, observed from x_left to x_right). Both have the same truth as long as both contacts run inwards, for it
// ends when the first shock reaches one of them: with the defaults at t = 3.67.   [Walker2012, fig. 41]
#include "oracles/lines/shock_collision.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/lines.hpp"

namespace ordo::studies {
namespace {

using solvers::LineEnd;

std::vector<Parameter> parameters() {
    const auto ends = word("ends", "prescribed",
                           {{"prescribed", "the outer states are held at x_L and x_R, the ends of the observed line"},
                            {"reservoir", "the outer gases fill the line beyond x_L and x_R without end"}},
                           "what is at the ends of the middle gas");
    return appended(appended(oracles::shock_collision().parameters, {ends}), observed_parameters(-8, 8));
}

double constant(const oracles::Exact& exact, const std::string& name) {
    const auto list = exact.constants({});
    const auto found = std::ranges::find(list, name, &oracles::Constant::name);
    return std::get<double>(found->value);
}

oracles::Exact truth(const Values& values) {
    auto exact = exact_of(oracles::shock_collision(), values);
    const double left = constant(exact, "v_star_left");
    const double right = constant(exact, "v_star_right");
    if (values.word("ends") == "prescribed" && !(left >= 0 && right <= 0))
        throw InputError("scene inrush", "the contacts move with " + shortest(left) + " and " + shortest(right) +
                                             " m/s, but must move inwards where ends are prescribed; nearest: "
                                             "ends = reservoir");
    return exact;
}

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const solvers::IdealGas gas{values.number("gamma")};
    const auto contents = [&](const std::string& ending) { return gas_contents(gas, values, ending); };
    if (values.word("ends") == "reservoir")
        return solvers::LineScene{.medium = gas,
                                  .edges = rising("inrush", values, {"x_left", "x_L", "x_R", "x_right"}),
                                  .pieces = {contents("_L"), contents("_M"), contents("_R")}};
    const auto held = [&](const std::string& ending) {
        return LineEnd{.kind = LineEnd::Kind::prescribed, .outside = contents(ending)};
    };
    return solvers::LineScene{.medium = gas,
                              .edges = {values.number("x_L"), values.number("x_R")},
                              .pieces = {contents("_M")},
                              .ends = {held("_L"), held("_R")}};
}

const bool enrolled = enrol({.name = "inrush",
                             .about = "Gas rushes from both ends into a thinner one; its two shocks collide",
                             .source = {"Walker2012"},
                             .units = "dimensionless",
                             .parameters = parameters(),
                             .oracle = "shock_collision",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies

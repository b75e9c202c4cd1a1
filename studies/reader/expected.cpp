// From a scene and a solver's claim to the orders that theory expects of a study's quantities.
#include <algorithm>

#include "core/text.hpp"
#include "solvers/solver.hpp"
#include "studies/engine/expected_order.hpp"
#include "studies/engine/judge.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/reader/parts.hpp"

namespace ordo::studies {
namespace {

/// What is not smooth in that field at the time of measuring, on the line that is observed.
std::vector<oracles::Feature> features_of(const Node& node, const Study& study, const std::string& field) {
    const auto& scene = scene_named(study.scene.name, "");
    const auto exact = scene.truth(study.scene.values);
    if (!exact.features) node.refuse("the exact solution does not tell how smooth it is; say the order as a number");
    auto features = exact.features(field, study.measure.at);
    const auto problem = scene.problem(study.scene.values);
    if (const auto* line = std::get_if<solvers::LineScene>(&problem)) {
        std::erase_if(features, [&](const oracles::Feature& feature) {
            return !(feature.x >= line->edges.front() && feature.x <= line->edges.back());
        });
    }
    return features;
}

/// Along h alone the order in space; along h and dt together the smaller one, of a solver that takes steps.
Method method_of(const Study& study, const solvers::Claim& claim) {
    Method method{.order = claim.order_in_space,
                  .waves = claim.order_of_waves,
                  .rings = claim.rings,
                  .sharp = claim.sharp,
                  .steep = claim.steep};
    if (study.sweep.path == Path::joint && claim.order_in_time > 0) {
        method.order = std::min(method.order, claim.order_in_time);
        method.waves = std::min(method.waves, claim.order_in_time);
    }
    return method;
}

/// Orders are expected along h, against the exact solution, at a time that is known before the runs.
void check_speaks_of_h(const Node& node, const Expectation& claim, const Study& study) {
    const auto fitted =
        study.measure.orders_against.empty() ? own_abscissae(study.sweep.path) : study.measure.orders_against;
    const bool all_h = std::ranges::all_of(
        fitted, [](const std::string& abscissa) { return abscissa == "h" || !counter_of(abscissa).empty(); });
    if (claim.against != "h" && !(claim.against.empty() && all_h))
        node.refuse("theory expects orders against h only; say the order as a number");
    if (study.measure.until == Until::steps)
        node.refuse("needs 'until' to be 'exact' or 'accumulated', so that the time is known");
}

ExpectedOrder order_of(const Node& node, const Study& study, const SolverChoice& choice, const Quantity& quantity) {
    const auto claim = solvers::solver_named(choice.name, "").claim(choice.options);
    if (quantity.against == Against::finest)
        return {.refused =
                    "theory expects no order of a difference between two runs: at jumps it may show another one"};
    if (!claim.fields.empty() && std::ranges::find(claim.fields, quantity.field) == claim.fields.end())
        return {.refused = "theory expects no order: the solver claims one of " + joined(claim.fields) + " only"};
    return expected_order(quantity.norm, method_of(study, claim), features_of(node, study, quantity.field));
}

}  // namespace

std::vector<Expectation> expected_orders(const Node& node, const Expectation& claim, const Study& study) {
    check_speaks_of_h(node, claim, study);
    std::vector<Expectation> expectations;
    for (const auto& choice : study.solvers) {
        for (const auto& quantity : study.measure.quantities) {
            if (!speaks_of(claim, quantity.key(), choice.label)) continue;
            const auto [order, theory, refused] = order_of(node, study, choice, quantity);
            if (!refused.empty()) node.refuse("for " + choice.label + ": " + quantity.key() + ", " + refused);
            Expectation one = claim;
            one.value = order;
            one.theory = theory;
            one.quantities = {quantity.key()};
            one.solvers = {choice.label};
            expectations.push_back(std::move(one));
        }
    }
    return expectations;
}

}  // namespace ordo::studies

// Broken solvers: the house's own, given a problem or choices that are slightly wrong.
#include "tests/catch.hpp"
#include "tests/mutations/broken.hpp"
#include "tests/mutations/shipped.hpp"

namespace ordo::tests {
namespace {

using solvers::LineScene;
using solvers::Plan;
using solvers::ScalarEquation;
using Bar = solvers::SolidScene<1>;
using enum studies::Fault;

/// The body force as it is `share` steps later.
auto force_later(double share) {
    return [share](Bar& bar, const Plan& plan) {
        *bar.body_force = [force = *bar.body_force, late = share * plan.dt](auto X, double t, auto out) {
            force(X, t + late, out);
        };
    };
}

void set_gamma(LineScene& line, double gamma) {
    line.medium = solvers::IdealGas{gamma};  // contents stay as they are: pressures follow
}

std::vector<Mutation> solids() {
    return {
        {"mpm: density 1 % too large",
         shipped::mpm_bar,
         on_problem<Bar>("mpm", [](Bar& bar, const Plan&) { bar.rho *= 1.01; }),
         {published_differs}},
        {"mpm: another law, E ln F",
         shipped::mpm_bar,
         on_problem<Bar>("mpm",
                         [](Bar& bar, const Plan&) {
                             bar.law = solvers::LogarithmicLaw{std::get<solvers::ReciprocalLaw>(bar.law).C};
                         }),
         {published_differs}},
        {"mpm: body force half a step late, second order",
         shipped::mpm_gauss_2,
         on_problem<Bar>("mpm", force_later(0.5)),
         {order_too_low, order_uncertain, pre_asymptotic, published_differs}},
        {"mpm: body force half a step late, third order",
         shipped::mpm_gauss_3,
         on_problem<Bar>("mpm", force_later(0.5)),
         {order_too_low}},
        {"fem: modulus 1 % too large",
         shipped::fem_bar,
         on_problem<Bar>("fem",
                         [](Bar& bar, const Plan&) {
                             bar.law = solvers::NominalLaw{{0, 1.01 * std::get<solvers::NominalLaw>(bar.law).C.mu}};
                         }),
         {order_too_low, at_floor, published_differs}},
        {"fem: end nodes have the mass of a whole element",
         shipped::fem_bar,
         on_problem<Bar>("fem", [](Bar& bar, const Plan& plan) { bar.rho *= 1 + plan.h / (bar.upper - bar.lower)[0]; }),
         {published_differs}},
        {"fem: gravity 1 % too large",
         shipped::fem_column,
         on_problem<Bar>("fem",
                         [](Bar& bar, const Plan&) {
                             *bar.body_force = [force = *bar.body_force](auto X, double t, auto out) {
                                 force(X, t, out);
                                 for (auto& b : out) b *= 1.01;
                             };
                         }),
         {order_too_low, at_floor, stalled}},
    };
}

std::vector<Mutation> lines() {
    return {
        {"godunov: cells are uniform, first order",
         shipped::gas_tube,
         with_choices("godunov", [](Given& options, Given&) { options["order"] = std::string("first"); }),
         {order_too_low}},
        {"godunov: gamma 1.41 for 1.4",
         shipped::gas_tube,
         on_problem<LineScene>("godunov", [](LineScene& line, const Plan&) { set_gamma(line, 1.41); }),
         {order_too_low, at_floor, stalled}},
        {"godunov: 1 % of the energy on the left is lost",
         shipped::gas_tube,
         on_problem<LineScene>("godunov", [](LineScene& line, const Plan&) { line.pieces[0].energy *= 0.99; }),
         {order_too_low, at_floor, stalled}},
        {"godunov: the wall lets gas through",
         shipped::gas_wall,
         on_problem<LineScene>("godunov", [](LineScene& line, const Plan&) { line.ends[0] = {}; }),
         {order_too_low, stalled}},
        {"rrm: gamma 1.401 for 1.4",
         shipped::gas_tube,
         on_problem<LineScene>("rrm", [](LineScene& line, const Plan&) { set_gamma(line, 1.401); }),
         {error_too_large}},
        {"rrm: the gases touch 1e-6 m beside x = 0",
         shipped::gas_contact,
         on_problem<LineScene>("rrm", [](LineScene& line, const Plan&) { line.edges[1] += 1e-6; }),
         {error_too_large}},
        {"rrm: the wall is 0.1 % too fast",
         shipped::elastic_wall,
         on_problem<LineScene>("rrm", [](LineScene& line, const Plan&) { line.ends[0].velocity *= 1.001; }),
         {error_too_large}},
        {"rrm: edges of fronts run at both cells' speeds where their own are asked for",
         shipped::elastic_line,
         with_choices("rrm", [](Given& options, Given&) { options["speeds"] = std::string("davis"); }),
         {error_too_large}},
    };
}

std::vector<Mutation> iterations() {
    return {
        {"root finding: slope 1 % too steep",
         shipped::newton,
         on_problem<ScalarEquation>("root_finding",
                                    [](ScalarEquation& equation, const Plan&) {
                                        equation.slope = [slope = equation.slope](double x) { return 1.01 * slope(x); };
                                    }),
         {order_too_low, pre_asymptotic}},
        {"root finding: the slope of the first iterate is kept",
         shipped::newton,
         with_choices("root_finding",
                      [](Given& options, Given&) { options["method"] = std::string("modified_newton"); }),
         {order_too_low, pre_asymptotic}},
        {"root finding: Newton for the secant",
         shipped::secant,
         with_choices("root_finding", [](Given& options, Given&) { options["method"] = std::string("newton"); }),
         {error_is_zero}},
    };
}

}  // namespace

MutationClass broken_solvers() {
    MutationClass all{"solver", solids()};
    for (const auto& more : {lines(), iterations()}) all.rows.insert(all.rows.end(), more.begin(), more.end());
    return all;
}

TEST_CASE("mutations: broken solvers ring", "[alarm]") { try_all(broken_solvers()); }

}  // namespace ordo::tests

// The orders that theory expects: the rule by its table, and what a method really shows.
#include "studies/engine/expected_order.hpp"

#include <cmath>
#include <numbers>

#include "solvers/solver.hpp"
#include "studies/engine/run.hpp"
#include "studies/order/order_fit.hpp"
#include "studies/reader/study_reader.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using namespace ordo::studies;
using oracles::Feature;
using Kind = Feature::Kind;

namespace {

double order_of(Norm norm, double p, const std::vector<Feature>& features) {
    const auto expected = expected_order(norm, {.order = p}, features);
    return expected.refused.empty() ? expected.order : NAN;
}

std::string refusal_of(Norm norm, const std::vector<Feature>& features) {
    return expected_order(norm, {.order = 2}, features).refused;
}

const Feature shock{Kind::shock, 1}, contact{Kind::contact, 2}, wave{Kind::linear, 3}, corner{Kind::fan_corner, 4, 1},
    kink{Kind::linear, 5, 1}, bend{Kind::linear, 6, 2}, vacuum{Kind::singular, 7};

/// A tube with this right state and norm that expects the order of Godunov's method at t = 1.
std::string tube(const std::string& scene, const std::string& solver, const std::string& field,
                 const std::string& norm) {
    return R"({"study": "tube", "scene": )" + scene + R"(, "solvers": [{"name": "godunov", )" + solver +
           R"(}], "sweep": {"cells": [100, 200, 400, 800], "path": "space"}, "measure": {"at": 1, "fields": [")" +
           field + R"("], "norms": [")" + norm +
           R"("]}, "expect": [{"order": "expected", "within": 0.1, "source": "test"}]})";
}

/// What is expected, and the order of the runs.
struct Found {
    Expectation expectation;
    double order;
};

Found found(const std::string& text) {
    const Study study = study_from_text(text, "tube.json", "");
    std::vector<FitPoint> points;
    for (const auto& spec : specs_of(study)) {
        const Run run = executed(spec, [] { return false; }).run;
        points.push_back({run.h, run.errors.at(0).value});
    }
    return {study.expect.at(0), fit_order(points).fit.value().order};
}

const std::string lone_contact =
    R"({"name": "gas_riemann", "rho_L": 1, "v_L": 0.3, "p_L": 1, "rho_R": 0.2, "v_R": 0.3, "p_R": 1, "x_left": -2.5, "x_right": 2.5})";
const std::string two_shocks =
    R"({"name": "gas_riemann", "rho_L": 1, "v_L": 1, "p_L": 1, "rho_R": 1, "v_R": -1, "p_R": 1, "x_left": -2.5, "x_right": 2.5})";
const std::string bars =
    R"({"name": "linear_elastic_riemann", "v_L": 0.1, "v_R": -0.1, "x_left": -2.5, "x_right": 2.5})";

/// L1 error of density after one period of a sine wave in a stream, by second order without a limiter.
double error_of_sine(double cells) {
    using namespace ordo::solvers;
    const IdealGas gas{1.4};
    const auto mean = [](double a, double b) {
        constexpr double k = 2 * std::numbers::pi;
        return 1 + 0.2 * (std::cos(k * a) - std::cos(k * b)) / (k * (b - a));
    };
    LineScene line{.medium = gas, .edges = {0}, .pieces = {}};
    for (double i = 0; i < cells; ++i) {
        line.pieces.push_back(gas.contents(mean(i / cells, (i + 1) / cells), 1, 1));
        line.edges.push_back((i + 1) / cells);
    }
    line.ends.fill({.kind = LineEnd::Kind::periodic});
    const Solver& godunov = solver_named("godunov", "");
    const auto options = resolve(godunov.options, {{"limiter", "central"}}, "", "godunov");
    const auto fine = resolve(godunov.resolution, {{"cells", cells}}, "", "godunov");
    const std::vector<std::string> fields{"density"};
    const auto run = godunov.start(line, options, fine, fields);
    run->advance_to(1, [] { return false; });
    const Snapshot shot = run->snapshot();
    double sum = 0;
    for (std::size_t i = 0; i < shot.points(); ++i)
        sum += shot.weights[i] * std::abs(shot.fields[0].values[i] - mean(shot.edges[i], shot.edges[i + 1]));
    return sum;
}

}  // namespace

TEST_CASE("expected order: each feature in each norm", "[unit]") {
    // p/(p+1) of contacts in l1 is 1/2, 2/3, 3/4, 4/5; others as (k + 1/q) s, no more than p.
    CHECK(order_of(Norm::l1, 1, {contact}) == Approx(1.0 / 2));
    CHECK(order_of(Norm::l1, 2, {contact}) == Approx(2.0 / 3));
    CHECK(order_of(Norm::l1, 3, {contact}) == Approx(3.0 / 4));
    CHECK(order_of(Norm::l1, 4, {wave}) == Approx(4.0 / 5));
    CHECK(order_of(Norm::l2, 2, {contact}) == Approx(1.0 / 3));
    CHECK(order_of(Norm::rms, 2, {contact}) == Approx(1.0 / 3));
    CHECK(order_of(Norm::l1, 2, {shock}) == 1);
    CHECK(order_of(Norm::l1, 1, {shock}) == 1);
    CHECK(order_of(Norm::l2, 2, {shock}) == 0.5);
    CHECK(order_of(Norm::l1, 2, {corner}) == Approx(4.0 / 3));
    CHECK(order_of(Norm::l1, 1, {corner}) == Approx(1));
    CHECK(order_of(Norm::l1, 0.5, {corner}) == 0.5);
    CHECK(order_of(Norm::l2, 2, {kink}) == Approx(1));
    CHECK(order_of(Norm::linf, 2, {kink}) == Approx(2.0 / 3));
    CHECK(order_of(Norm::rms, 2, {bend}) == Approx(5.0 / 3));
    CHECK(order_of(Norm::linf, 2, {bend}) == Approx(4.0 / 3));
    CHECK(order_of(Norm::l1, 2, {bend}) == 2);
    // Quadratic splines, whose waves are of order 4: 1.5 * 4/5 at a kink, 2.5 * 4/5 at a jump of the second derivative.
    CHECK(expected_order(Norm::rms, {.order = 3, .waves = 4}, {kink}).order == Approx(1.2));
    CHECK(expected_order(Norm::rms, {.order = 3, .waves = 4}, {bend}).order == Approx(2));
    CHECK(expected_order(Norm::rms, {.order = 3, .waves = 4}, {}).order == 3);
    // Oscillations: l2 as ever, l1 and linf have no rule where the feature matters.
    const Method ringing{.order = 2, .rings = true};
    CHECK(expected_order(Norm::l2, ringing, {kink}).order == Approx(1));
    CHECK_THAT(expected_order(Norm::l1, ringing, {kink}).refused, ContainsSubstring("by a method that rings"));
    CHECK_THAT(expected_order(Norm::linf, ringing, {bend}).refused, ContainsSubstring("by a method that rings"));
    CHECK(expected_order(Norm::l1, ringing, {}).order == 2);
    CHECK(order_of(Norm::l1_near, 2, {contact}) == Approx(2.0 / 3));
    for (const double p : {1.0, 1.5, 4.0}) CHECK(order_of(Norm::linf, p, {}) == p);
}

TEST_CASE("expected order: the worst feature decides, but for what is kept sharp", "[unit]") {
    CHECK(order_of(Norm::l1, 2, {corner, contact, shock}) == Approx(2.0 / 3));
    CHECK(order_of(Norm::l1, 2, {corner, shock}) == 1);
    const Method keeps{.order = 2, .sharp = {"contact"}};
    CHECK(expected_order(Norm::l1, keeps, {corner, contact}).order == Approx(4.0 / 3));
    CHECK(expected_order(Norm::l1, keeps, {contact}).order == 2);
    CHECK(expected_order(Norm::l1, {.order = 2, .steep = {"contact"}}, {contact}).order == 1);
    CHECK(expected_order(Norm::l1, {.order = 2}, {contact}).theory == "contact, l1, formal order 2");
    CHECK(expected_order(Norm::l1, {.order = 2}, {}).theory == "smooth, l1, formal order 2");
    CHECK(expected_order(Norm::l1, keeps, {contact}).theory == "waves kept sharp, l1, formal order 2");
    CHECK(expected_order(Norm::l2, {.order = 3}, {kink}).theory == "kink, l2, formal order 3");
}

TEST_CASE("expected order: places, and what theory says nothing about", "[unit]") {
    CHECK(order_of(Norm::shock, 2, {corner, contact, shock}) == 1);
    CHECK_THAT(refusal_of(Norm::shock, {contact}), ContainsSubstring("the field has no shock"));
    CHECK_THAT(refusal_of(Norm::contact, {contact}), ContainsSubstring("no rule for the place of a contact"));
    CHECK_THAT(refusal_of(Norm::fan_edge, {corner}), ContainsSubstring("no rule for the place of a fan_edge"));
    CHECK_THAT(refusal_of(Norm::l1_fans, {corner}), ContainsSubstring("no rule for 'l1_fans'"));
    CHECK_THAT(refusal_of(Norm::l1_away, {shock}), ContainsSubstring("no rule for 'l1_away'"));
    CHECK_THAT(refusal_of(Norm::linf, {shock}), ContainsSubstring("in linf the shock at x = 1 does not converge"));
    CHECK_THAT(refusal_of(Norm::l1, {corner, vacuum}), ContainsSubstring("no rule for the singular place at x = 7"));
    CHECK_THAT(expected_order(Norm::l1, {.order = 0}, {}).refused, ContainsSubstring("the method claims none"));
}

TEST_CASE("expected order: a contact alone shows 2/3 by second order and 1/2 by first", "[convergence]") {
    const auto [solver, order] =
        GENERATE(table<std::string, double>({{R"("order": "second")", 2.0 / 3},
                                             {R"("order": "second", "limiter": "minmod")", 2.0 / 3},
                                             {R"("order": "first")", 1.0 / 2}}));
    CAPTURE(solver);
    const auto [expectation, measured] = found(tube(lone_contact, solver, "density", "l1"));
    CHECK(expectation.value == Approx(order));
    CHECK(measured == Approx(order).margin(0.08));  // the mc limiter steepens: 0.72 on these grids, minmod less
}

TEST_CASE("expected order: waves of Hooke's law are smeared like contacts, shocks are not", "[convergence]") {
    const auto [linear, smeared] = found(tube(bars, R"("order": "second")", "velocity", "l1"));
    CHECK(linear.theory == "jump of a linear wave, l1, formal order 2");
    CHECK(linear.value == Approx(2.0 / 3));
    CHECK(smeared == Approx(2.0 / 3).margin(0.05));
    const auto [steep, kept] = found(tube(two_shocks, R"("order": "second")", "velocity", "l1"));
    CHECK(steep.value == 1);
    CHECK(kept == Approx(1).margin(0.15));  // the place of a shock in its cell varies from grid to grid
}

TEST_CASE("expected order: superbee keeps a contact some cells wide", "[convergence]") {
    const auto [expectation, measured] =
        found(tube(lone_contact, R"("order": "second", "limiter": "superbee")", "density", "l1"));
    CHECK(expectation.value == 1);
    CHECK(measured == Approx(1).margin(0.15));
}

TEST_CASE("expected order: smooth density in a stream shows the formal order", "[convergence]") {
    CHECK(std::log2(error_of_sine(32) / error_of_sine(64)) == Approx(2).margin(0.1));
    CHECK(std::log2(error_of_sine(64) / error_of_sine(128)) == Approx(2).margin(0.05));
}

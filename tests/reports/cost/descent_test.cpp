// Work-precision curves against power laws, where everything has a closed form.
#include "reports/cost/descent.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/catch.hpp"

using namespace ordo::reports;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Points on e = coefficient * cost^-exponent at costs from, 4 from, 16 from, ...
std::vector<CostPoint> power_law(double coefficient, double exponent, double from, int count) {
    std::vector<CostPoint> points;
    for (int k = 0; k < count; ++k) {
        const double cost = from * std::pow(4.0, k);
        points.push_back({cost, coefficient * std::pow(cost, -exponent)});
    }
    return points;
}

std::vector<CostPoint> cloud(unsigned seed, int count) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> few(1, 12);  // few values, so that costs and errors meet often
    std::vector<CostPoint> points;
    for (int k = 0; k < count; ++k) points.push_back({0.1 * few(random), 0.3 * few(random)});
    points[static_cast<std::size_t>(count / 2)].error = none;
    return points;
}

bool beats(const CostPoint& a, const CostPoint& b) {
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

}  // namespace

TEST_CASE("descent: the cost to an error is that of the power law, at runs and between them", "[unit]") {
    const double coefficient = GENERATE(0.7, 30.0), exponent = GENERATE(0.5, 1.0, 2.5);
    const Descent descent = descent_of(power_law(coefficient, exponent, 1e-3, 6));
    for (const double cost : {1.0001e-3, 1e-3 * 4, 2.5e-2, 0.1, 1.02}) {
        const auto found = cost_to(descent, coefficient * std::pow(cost, -exponent));
        CHECK(found.reached == Reached::between);
        CHECK(found.cost == Approx(cost).epsilon(1e-12));
        CHECK(error_for(descent, cost) == Approx(coefficient * std::pow(cost, -exponent)).epsilon(1e-12));
    }
}

TEST_CASE("descent: nothing is extrapolated, to neither side", "[unit]") {
    const auto points = power_law(1, 1, 1, 4);  // costs 1 to 64, errors 1 to 1/64
    const Descent descent = descent_of(points);
    CHECK(cost_to(descent, 1 / 64.0).reached == Reached::between);
    CHECK(cost_to(descent, 1 / 64.0).cost == 64);
    CHECK(cost_to(descent, 0.999 / 64).reached == Reached::never);
    CHECK(std::isnan(cost_to(descent, 0.999 / 64).cost));
    CHECK(cost_to(descent, 1).reached == Reached::at_most);
    CHECK(cost_to(descent, 5).reached == Reached::at_most);
    CHECK(cost_to(descent, 5).cost == 1);
    CHECK(error_for(descent, 0.99) == std::numeric_limits<double>::infinity());
    CHECK(error_for(descent, 1e6) == 1 / 64.0);
    CHECK(cost_to({}, 1).reached == Reached::never);
    CHECK(descent_of(std::vector<CostPoint>{{1, none}, {none, 1}, {0, 1}, {1, -1}, {-1, 1}}).empty());
}

TEST_CASE("descent: where an error grows again, what was reached before stays reached", "[unit]") {
    // 1, 1/4, then up to 1/2, then down to 1/16: 1/4 is passed again at cost 40 on the way from 1/2 (20) to 1/8 (80).
    const Descent descent = descent_of(std::vector<CostPoint>{{1, 1}, {4, 0.25}, {20, 0.5}, {80, 0.125}});
    CHECK(cost_to(descent, 0.5).cost == Approx(2).epsilon(1e-14));
    CHECK(cost_to(descent, 0.25).cost == 4);
    CHECK(cost_to(descent, 0.249999999).cost == Approx(40).epsilon(1e-7));
    CHECK(error_for(descent, 20) == 0.25);
    CHECK(error_for(descent, 39) == 0.25);
    CHECK(error_for(descent, 80) == 0.125);
}

TEST_CASE("descent: across a run without an error nothing is interpolated", "[unit]") {
    const Descent descent = descent_of(std::vector<CostPoint>{{1, 1}, {4, none}, {16, 1.0 / 16}});
    CHECK(cost_to(descent, 0.25).cost == 16);
    CHECK(cost_to(descent, 1).cost == 1);
    CHECK(error_for(descent, 15.9) == 1);
    CHECK(error_for(descent, 16) == 1.0 / 16);
}

TEST_CASE("descent: an error of zero is reached, at its own cost", "[unit]") {
    const Descent descent = descent_of(std::vector<CostPoint>{{1, 1}, {4, 0}, {9, 0}});
    CHECK(cost_to(descent, 1e-300).cost == 4);
    CHECK(cost_to(descent, 0).cost == 4);
    CHECK(error_for(descent, 3.9) == 1);
    CHECK(error_for(descent, 6) == 0);
    const auto found = crossovers(descent, descent_of(std::vector<CostPoint>{{1, 0.5}, {16, 0.5}}));
    REQUIRE(found.size() == 1);
    CHECK(found[0].at.cost == 4);
    CHECK(found[0].at.error == 0.5);
    CHECK(found[0].first_leads);
    CHECK(crossovers(descent, descent).empty());
}

TEST_CASE("descent: runs may come dearer first, and cost the same", "[unit]") {
    auto points = power_law(2, 1.5, 1e-2, 5);
    const double cost = cost_to(descent_of(points), 50).cost;
    std::ranges::reverse(points);
    CHECK(cost_to(descent_of(points), 50).cost == cost);
    const Descent same = descent_of(std::vector<CostPoint>{{1, 1}, {1, 0.5}, {2, 0.25}});
    CHECK(cost_to(same, 0.5).reached == Reached::at_most);
    CHECK(cost_to(same, 0.35355339059327373).cost == Approx(std::sqrt(2)).epsilon(1e-12));
}

TEST_CASE("crossovers: of two power laws at the closed form, with the one that leads after it", "[unit]") {
    // 1/c and 8/c^2 meet at c = 8; 1/c leads before.
    const Descent first = descent_of(power_law(1, 1, 0.7, 6));
    const Descent second = descent_of(power_law(8, 2, 0.9, 6));
    const auto found = crossovers(first, second);
    REQUIRE(found.size() == 1);
    CHECK(found[0].at.cost == Approx(8).epsilon(1e-12));
    CHECK(found[0].at.error == Approx(1.0 / 8).epsilon(1e-12));
    CHECK_FALSE(found[0].first_leads);
    REQUIRE(crossovers(second, first).size() == 1);
    CHECK(crossovers(second, first)[0].first_leads);
}

TEST_CASE("crossovers: at a run of both, at a fall, and none by a touch", "[unit]") {
    const Descent line = descent_of(std::vector<CostPoint>{{1, 1}, {4, 0.25}, {16, 1.0 / 16}});
    const auto at_run = crossovers(line, descent_of(std::vector<CostPoint>{{1, 8}, {4, 0.25}, {16, 1.0 / 64}}));
    REQUIRE(at_run.size() == 1);
    CHECK(at_run[0].at.cost == 4);
    CHECK(at_run[0].at.error == 0.25);
    const auto touch = crossovers(line, descent_of(std::vector<CostPoint>{{1, 4}, {4, 0.25}, {16, 1.0 / 4}}));
    CHECK(touch.empty());
    const auto fall = crossovers(line, descent_of(std::vector<CostPoint>{{1, 2}, {2, none}, {8, 1.0 / 32}}));
    REQUIRE(fall.size() == 1);
    CHECK(fall[0].at.cost == Approx(8));
    CHECK(fall[0].at.error == Approx(1.0 / 8));
}

TEST_CASE("crossovers: only at costs that both were measured for", "[unit]") {
    const auto whole = power_law(8, 2, 0.9, 6);
    const Descent first = descent_of(power_law(1, 1, 0.7, 6));
    CHECK(crossovers(first, descent_of(std::vector<CostPoint>(whole.begin() + 3, whole.end()))).empty());  // from 57.6
    CHECK(crossovers(first, descent_of(std::vector<CostPoint>(whole.begin(), whole.begin() + 2))).empty());  // to 3.6
    const Descent from_4 = descent_of(std::vector<CostPoint>{{4, 0.3}, {16, 0.1}});
    CHECK(crossovers(from_4, descent_of(std::vector<CostPoint>{{1, 1}, {2, none}, {4, 0.2}, {16, 0.05}})).empty());
    CHECK(crossovers(first, first).empty());
    CHECK(crossovers(first, {}).empty());
    CHECK(crossovers({}, first).empty());
}

TEST_CASE("front: who stands on it is beaten by none, and who does not is", "[property]") {
    const auto points = cloud(GENERATE(range(1u, 40u)), 25);
    const auto front = pareto_front(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool on = std::ranges::find(front, i) != front.end();
        const auto better = [&](const CostPoint& other) { return beats(other, points[i]); };
        const auto twin = [&](std::size_t k) {
            return k != i && points[k].cost == points[i].cost && points[k].error == points[i].error;
        };
        if (on) CHECK(std::ranges::none_of(points, better));
        else CHECK((!placed(points[i]) || std::ranges::any_of(points, better) || std::ranges::any_of(front, twin)));
    }
    CHECK(std::ranges::is_sorted(front, {}, [&](std::size_t i) { return points[i].cost; }));
    CHECK(std::ranges::is_sorted(front, std::ranges::greater{}, [&](std::size_t i) { return points[i].error; }));
}

TEST_CASE("front: it is what the descent of the same points falls to", "[property]") {
    const auto points = cloud(GENERATE(range(100u, 120u)), 20);
    const Descent descent = descent_of(points);
    for (const std::size_t i : pareto_front(points)) CHECK(error_for(descent, points[i].cost) == points[i].error);
}

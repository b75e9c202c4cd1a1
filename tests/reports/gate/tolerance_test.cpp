// Tolerances come from measured scatter.
#include "reports/gate/tolerance.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "tests/catch.hpp"

using namespace ordo;
using reports::Figure;
using reports::FigureKind;
using Figures = std::vector<Figure>;

namespace {

const double none = std::nan("");

Figures figures(const std::vector<double>& values, FigureKind kind = FigureKind::error) {
    Figures found;
    for (std::size_t i = 0; i < values.size(); ++i)
        found.push_back({kind, "mpm, cells = " + std::to_string(i), "mpm", "displacement.rms", values[i]});
    return found;
}

/// Values of one report: true ones with noise of unit size.
Figures noisy(std::size_t count, std::mt19937& seed) {
    std::normal_distribution<double> noise;
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(1000 + noise(seed));
    return figures(values);
}

/// Share of reports by a third build that leave the interval made from two.
double false_alarms(std::size_t count) {
    std::mt19937 seed(6);
    constexpr int trials = 1000;
    int alarms = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const std::vector<Figures> made{noisy(count, seed), noisy(count, seed)};
        const auto tolerance = reports::tolerances(made);
        const auto now = noisy(count, seed);
        bool alarm = false;
        for (std::size_t i = 0; i < count; ++i)
            alarm = alarm || !(std::abs(now[i].value - made[0][i].value) <= tolerance[i]);
        alarms += alarm;
    }
    return static_cast<double>(alarms) / trials;
}

}  // namespace

TEST_CASE("tolerance: ten times the spread of a figure", "[unit]") {
    const auto found = reports::tolerances({figures({1.0}), figures({1.25}), figures({0.75})});
    CHECK(found == std::vector<double>{5.0});
}

TEST_CASE("tolerance: at least the median spread of the figures of one solver and quantity", "[unit]") {
    const auto found = reports::tolerances({figures({1, 2, 3}), figures({1, 2.25, 3.5})});
    CHECK(found == std::vector<double>{2.5, 2.5, 5.0});
    auto apart = figures({1, 2, 3});
    auto twin = figures({1, 2.25, 3.5});
    apart[0].what = twin[0].what = "velocity.rms";
    CHECK(reports::tolerances({apart, twin})[0] == 16 * std::numeric_limits<double>::epsilon());
}

TEST_CASE("tolerance: where the spreads of a group grow with its values, the usual one is a share of the value",
          "[unit]") {
    const auto found =
        reports::tolerances({figures({1, 10, 100, 1000, 10000}), figures({1, 10.25, 102.5, 1025, 10250})});
    CHECK(found[0] == Approx(0.25));  // agrees by luck; the others are off by 2.5 %
    CHECK(found[1] == Approx(2.5));
    CHECK(found[4] == Approx(2500));
}

TEST_CASE("tolerance: round-off that is as large as the errors is an amount for all of them", "[unit]") {
    const auto found =
        reports::tolerances({figures({1e-17, 2e-16, 3e-16, 1e-15}), figures({1.1e-17, 1e-17, 4e-16, 1e-16})});
    CHECK(found[0] >= 1e-15);
}

TEST_CASE("tolerance: where all agree to the bit, sixteen units in the last place", "[unit]") {
    const double value = 0.75;  // its last place is half an epsilon
    const double ulps = 8 * std::numeric_limits<double>::epsilon();
    CHECK(reports::tolerances({figures({value})}) == std::vector<double>{ulps});
    CHECK(reports::tolerances({figures({value}), figures({value})}) == std::vector<double>{ulps});
    CHECK(reports::tolerances({figures({-value}, FigureKind::order)}) == std::vector<double>{ulps});
}

TEST_CASE("tolerance: a zero stays a zero, and a count a count, unless twins differ", "[unit]") {
    CHECK(reports::tolerances({figures({0}), figures({0})})[0] < 1e-300);
    CHECK(reports::tolerances({figures({100}, FigureKind::work)}) == std::vector<double>{0.0});
    CHECK(reports::tolerances({figures({100}, FigureKind::work), figures({101}, FigureKind::work)}) ==
          std::vector<double>{10.0});
}

TEST_CASE("tolerance: round-off scatters by an absolute amount", "[unit]") {
    const auto found = reports::tolerances({figures({1e-16}), figures({3e-16})});
    CHECK(found[0] == Approx(2e-15));
}

TEST_CASE("tolerance: what no report has gets none, and does not spoil its group", "[unit]") {
    const auto found = reports::tolerances({figures({1, none}), figures({1.5, none})});
    CHECK(found == std::vector<double>{5.0, 0.0});
}

// Of one figure alone two reports tell little: their spread is small by luck in one case of twenty, and no factor
// mends that. The median of the group does: seven figures as a small study has them, thirty as table A1 has.
TEST_CASE("tolerance: a third build raises no false alarm where a group measured its scatter", "[property]") {
    CHECK(false_alarms(7) <= 0.01);
    CHECK(false_alarms(30) == 0);
}

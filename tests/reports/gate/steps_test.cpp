// Steps in series of numbers with and without noise, on seeded histories.
#include "reports/gate/steps.hpp"

#include <cmath>
#include <random>

#include "tests/catch.hpp"

using namespace ordo;
using reports::steps_in;
using Places = std::vector<std::vector<double>>;

namespace {

const double none = std::nan("");

Places single(const std::vector<double>& values) {
    Places places;
    for (const double value : values) places.push_back({value});
    return places;
}

/// Unit noise around 100, `size` more from the place `at` on, and `slope` more at every place.
Places noisy(std::size_t count, double size, std::size_t at, double slope, std::mt19937& seed) {
    std::normal_distribution<double> noise;
    Places places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back({100 + noise(seed) + (i >= at ? size : 0) + slope * static_cast<double>(i)});
    return places;
}

/// In how many of 200 seeded histories a step of that size in the middle is found, alone and within 2 places.
int found_of_200(std::size_t count, double size) {
    std::mt19937 seed(3);
    int found = 0;
    for (int history = 0; history < 200; ++history) {
        const auto steps = steps_in(noisy(count, size, count / 2, 0, seed), 1e-12).steps;
        const double off =
            steps.empty() ? 9 : std::abs(static_cast<double>(steps[0].at) - static_cast<double>(count / 2));
        found += steps.size() == 1 && off <= 2;
    }
    return found;
}

}  // namespace

TEST_CASE("steps: equal bits have none, and one change is one step, up or down", "[unit]") {
    CHECK(steps_in(single({1.5, 1.5, 1.5, 1.5}), 1e-15).steps.empty());
    for (const double now : {1.5 + 1e-9, 1.5 - 1e-9}) {
        const auto found = steps_in(single({1.5, 1.5, 1.5, now, now}), 1e-15);
        REQUIRE(found.steps.size() == 1);
        CHECK(found.steps[0].at == 3);
        CHECK(found.steps[0].before == 1.5);
        CHECK(found.steps[0].now == now);
    }
}

TEST_CASE("steps: the last of equal values may step, however long the series", "[unit]") {
    for (const std::size_t count : {2U, 3U, 5U, 6U, 20U, 200U}) {
        std::vector<double> values(count, 1e-3);
        values.back() = 1.001e-3;
        INFO(count);
        REQUIRE(steps_in(single(values), 1e-18).steps.size() == 1);
        CHECK(steps_in(single(values), 1e-18).steps[0].at == count - 1);
    }
}

TEST_CASE("steps: a deterministic figure there and back makes two", "[unit]") {
    CHECK(steps_in(single({7, 7, 7, 9, 7, 7, 7, 7}), 0.5).steps.size() == 2);
}

TEST_CASE("steps: a change below the least does not count", "[unit]") {
    CHECK(steps_in(single({1, 1, 1, 1 + 4e-10, 1 + 4e-10}), 1e-9).steps.empty());
}

TEST_CASE("steps: zeros and tiny numbers", "[unit]") {
    CHECK(steps_in(single({0, 0, 0}), 0).steps.empty());
    CHECK(steps_in(single({0, 0, 1e-200}), 0).steps.size() == 1);
    CHECK(steps_in(single({0, 0, 1e3, 1e3}), 0).steps.size() == 1);
    CHECK(steps_in(single({1e-16, 1e-16, 2e-16}), 4e-31).steps.size() == 1);
}

TEST_CASE("steps: a number that is lost or found is a step", "[unit]") {
    const auto found = steps_in(single({1, 1, none, none, 1}), 1e-9).steps;
    REQUIRE(found.size() == 2);
    CHECK(found[0].at == 2);
    CHECK(std::isnan(found[0].now));
    CHECK(found[1].at == 4);
    CHECK(steps_in(single({none, none}), 1e-9).steps.empty());
    CHECK(steps_in({{1}, {1, none}, {1}}, 1e-9).steps.size() == 2);
}

TEST_CASE("steps: one place has none, whatever its values", "[unit]") {
    CHECK(steps_in({{1, 2, 3, 1e9, none}}, 0).steps.empty());
    CHECK(steps_in({}, 0).steps.empty());
}

TEST_CASE("steps: a series says when it is too short to tell noise", "[unit]") {
    CHECK(steps_in(single({1, 2, 1, 2, 1}), 0).few_places);
    CHECK_FALSE(steps_in(single({1, 2, 1, 2, 1, 2}), 0).few_places);
}

TEST_CASE("steps: what scatters from place to place is noise, not steps", "[unit]") {
    CHECK(steps_in(single({1, 2, 1.2, 1.9, 1.1, 2.1, 1.3, 1.8}), 1e-12).steps.empty());
}

TEST_CASE("alarm: values of one place raise none in 1000 histories, however they scatter", "[alarm]") {
    std::mt19937 seed(1);
    std::cauchy_distribution<double> wild;
    for (int history = 0; history < 1000; ++history) {
        Places places(1);
        for (int i = 0; i < 30; ++i) places[0].push_back(wild(seed));
        REQUIRE(steps_in(places, 0).steps.empty());
    }
}

TEST_CASE("alarm: noise from place to place raises none in 1000 histories of any length from 6 on", "[alarm]") {
    std::mt19937 seed(2);
    int alarms = 0;
    for (int history = 0; history < 1000; ++history) {
        const auto count = 6 + static_cast<std::size_t>(history % 60);
        alarms += !steps_in(noisy(count, 0, 0, 0, seed), 1e-12).steps.empty();
    }
    CHECK(alarms == 0);
}

TEST_CASE("alarm: repetitions at each place tell noise even in a short series", "[alarm]") {
    std::mt19937 seed(4);
    std::normal_distribution<double> noise;
    int alarms = 0;
    int found = 0;
    for (int history = 0; history < 1000; ++history) {
        Places quiet(4), stepped(4);
        for (std::size_t i = 0; i < 4; ++i) {
            for (int repetition = 0; repetition < 4; ++repetition) {
                quiet[i].push_back(noise(seed));
                stepped[i].push_back(noise(seed) + (i >= 2 ? 10 : 0));
            }
        }
        alarms += !steps_in(quiet, 1e-12).steps.empty();
        found += steps_in(stepped, 1e-12).steps.size() == 1;
    }
    CHECK(alarms == 0);
    CHECK(found >= 990);
}

// The gain of a step of s sigma in the middle of n places is n s^2 / 4. The penalty falls from 140 at 20 places to 40
// at 100, as the noise becomes known: what n must be follows.
TEST_CASE("alarm: steps are found, the small ones in long series", "[alarm]") {
    CHECK(found_of_200(100, 2) >= 120);
    CHECK(found_of_200(40, 4) >= 190);
    CHECK(found_of_200(40, -4) >= 190);
    CHECK(found_of_200(20, 10) >= 190);
}

TEST_CASE("alarm: a drift is seen as steps in its direction", "[alarm]") {
    std::mt19937 seed(5);
    for (int history = 0; history < 20; ++history) {
        const auto steps = steps_in(noisy(60, 0, 0, 0.5, seed), 1e-12).steps;
        REQUIRE(steps.size() >= 2);
        for (const auto& step : steps) REQUIRE(step.now > step.before);
    }
}

TEST_CASE("steps: the unit does not matter", "[property]") {
    std::mt19937 seed(7);
    const auto places = noisy(40, 6, 20, 0, seed);
    const auto in_units = [&](double unit) {
        auto scaled = places;
        for (auto& values : scaled) values[0] *= unit;
        std::vector<std::size_t> at;
        for (const auto& step : steps_in(scaled, 1e-12 * unit).steps) at.push_back(step.at);
        return at;
    };
    CHECK(in_units(1).size() == 1);
    CHECK(in_units(1) == in_units(1e-100));
    CHECK(in_units(1) == in_units(1e100));
}

#include "solvers/rrm/schedule.hpp"

#include "tests/catch.hpp"
#include "tests/oracles/fuzz.hpp"

using namespace ordo::solvers::rrm;

TEST_CASE("rrm schedule: nothing is due in an empty one", "[unit]") {
    Schedule schedule;
    CHECK(schedule.first_time() == Schedule::never);
    schedule.reserve(5);
    CHECK(schedule.first_time() == Schedule::never);
}

TEST_CASE("rrm schedule: the earliest is first, the lowest slot among equals", "[unit]") {
    Schedule schedule;
    schedule.reserve(6);
    schedule.set(4, 2);
    schedule.set(1, 2);
    schedule.set(3, 5);
    CHECK(schedule.first() == 1);
    CHECK(schedule.first_time() == 2);
    schedule.set(1, Schedule::never);
    CHECK(schedule.first() == 4);
    schedule.set(3, 1);
    CHECK(schedule.first() == 3);
    schedule.set(3, 7);
    CHECK(schedule.first() == 4);
}

TEST_CASE("rrm schedule: times stay when room is made", "[unit]") {
    Schedule schedule;
    schedule.reserve(2);
    schedule.set(0, 3);
    schedule.set(1, 1);
    schedule.reserve(100);
    schedule.set(99, 2);
    CHECK(schedule.first() == 1);
    schedule.set(1, 4);
    CHECK(schedule.first() == 99);
}

TEST_CASE("rrm schedule: agrees with a search through all times", "[unit]") {
    ordo::oracles::gate::Random random(5);
    Schedule schedule;
    std::vector<double> times(37, Schedule::never);
    schedule.reserve(times.size());
    for (int i = 0; i < 2000; ++i) {
        const int slot = random.whole(0, 36);
        const double time = random.whole(0, 9) == 0 ? Schedule::never : random.whole(0, 50);
        schedule.set(slot, time);
        times[static_cast<std::size_t>(slot)] = time;
        const auto least = std::ranges::min_element(times);
        REQUIRE(schedule.first_time() == *least);
        if (*least != Schedule::never) REQUIRE(schedule.first() == least - times.begin());
    }
}

#include "solvers/solver.hpp"

#include <stdexcept>
#include <string>

#include "core/error.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using namespace ordo::solvers;

TEST_CASE("solver: a time is reached in whole steps not longer than asked", "[unit]") {
    CHECK(steps_to(0.499, 1e-3) == 499);
    CHECK(steps_to(0.5, 1e-3) == 500);
    CHECK(steps_to(1, 0.1) == 10);
    CHECK(steps_to(1, 0.3) == 4);  // 3.33 is no whole number
    CHECK(steps_to(1, 2.0) == 1);
    CHECK(steps_to(0, 0.1) == 0);
    CHECK(steps_to(3 * 0.1, 0.1) == 3);  // 0.30000000000000004 / 0.1
    CHECK(steps_to(1, 1 / 3.0) == 3);
    CHECK(steps_to(1, 1 / 3.00001) == 4);  // really more than three
    CHECK(steps_to(1e4, 1e-3) == 10000000);
}

TEST_CASE("solver: a snapshot gives the field that was asked for, and no other", "[unit]") {
    const Snapshot shot{.t = 0, .dim = 1, .X = {}, .x = {}, .weights = {1, 2}, .fields = {{"velocity", 1, {3, 4}}}};
    CHECK(shot.points() == 2);
    CHECK(shot.field("velocity").values[1] == 4);
    CHECK_THROWS_AS(shot.field("stress"), std::logic_error);
}

TEST_CASE("solver registry: a misspelt name is refused with the nearest one", "[unit]") {
    CHECK(solver_named("mpm", "").name == "mpm");
    CHECK_THROWS_WITH(solver_named("mpn", "bar.json: /solvers/0"),
                      "bar.json: /solvers/0: there is no solver 'mpn' (nearest: 'mpm')");
    CHECK_THROWS_AS(solver_named("abaqus", ""), InputError);
}

TEST_CASE("solver registry: every solver declares what it is", "[unit]") {
    for (const auto& solver : all_solvers()) {
        INFO(solver.name);
        CHECK_FALSE(solver.about.empty());
        CHECK_FALSE(solver.source.empty());
        CHECK_FALSE(solver.fields.empty());
        const Claim claim = solver.claim(resolve(solver.options, {}, "", solver.name));
        CHECK(claim.order_in_space > 0);
        const bool steps = find_parameter(solver.resolution, "dt") || find_parameter(solver.resolution, "courant");
        CHECK((claim.order_in_time > 0 || !steps));  // iterations and events take no steps
        CHECK_FALSE(claim.source.empty());
    }
}

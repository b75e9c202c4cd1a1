// Where waves are, by hand and in Sod's tube.
#include "studies/engine/wave_places.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/studies/engine/line_solutions.hpp"

using namespace ordo;
using namespace ordo::studies;
using namespace ordo::tests;
using oracles::Wave;

namespace {

double step_at_03(double x) { return x < 0.3 ? 1 : 0; }

oracles::Exact one_jump(Wave::Kind kind = Wave::Kind::shock) {
    return on_a_line(step_at_03, {0.3}, {{kind, 0.3, 0.3}});
}

double error_of(Norm kind, const oracles::Exact& exact, const std::vector<double>& edges,
                const std::vector<double>& means, const std::vector<double>& rises = {}) {
    return place_error({edges, means, rises}, marks_of(kind, exact, 0, 1));
}

oracles::Exact sod() {
    const auto& oracle = oracles::oracle_named("riemann_gas", "test");
    return oracle.bind(resolve(oracle.parameters, {}, "test", oracle.name));
}

}  // namespace

TEST_CASE("wave places: a jump is where the profile passes the middle of the states", "[unit]") {
    CHECK(error_of(Norm::shock, one_jump(), {0, 0.25, 1}, {1, 0}) == Approx(0.05).epsilon(1e-14));
    CHECK(error_of(Norm::shock, one_jump(), {0, 0.3, 1}, {1, 0}) == 0);
    // Smeared over [0.2, 0.6]: the middle is at 0.4.
    CHECK(error_of(Norm::shock, one_jump(), {0, 0.2, 0.6, 1}, {1, 0.5, 0}, {0, -1, 0}) == Approx(0.1).epsilon(1e-14));
    CHECK(error_of(Norm::contact, one_jump(Wave::Kind::contact), {0, 0.25, 1}, {1, 0}) == Approx(0.05).epsilon(1e-14));
}

TEST_CASE("wave places: a wave is looked for half-way to its neighbours only, and the worst one counts", "[unit]") {
    // Jumps at 0, 1 and 1.5: 3 | 2 | 1 | 0.
    const auto stairs = on_a_line(
        [](double x) {
            return x < 0 ? 3 : x < 1 ? 2 : x < 1.5 ? 1 : 0;
        },
        {0, 1, 1.5}, {{Wave::Kind::shock, 0, 0}, {Wave::Kind::contact, 1, 1}, {Wave::Kind::shock, 1.5, 1.5}});
    const auto marks = marks_of(Norm::shock, stairs, 0, 1);
    REQUIRE(marks.size() == 2);
    CHECK(marks[0].level == Approx(2.5));
    CHECK(marks[0].to == 0.5);
    CHECK(std::isinf(marks[0].from));
    CHECK(marks[1].from == 1.25);
    const auto shocks_at = [&](double first, double second) {
        return error_of(Norm::shock, stairs, {-1, first, 1, second, 2}, {3, 2, 1, 0});
    };
    CHECK(shocks_at(0.1, 1.48) == Approx(0.1).epsilon(1e-13));
    CHECK(shocks_at(-0.01, 1.6) == Approx(0.1).epsilon(1e-13));
    CHECK(std::isnan(shocks_at(0.6, 1.5)));  // beyond the middle between 0 and 1
}

TEST_CASE("wave places: the edges of a fan, 5 % inside it", "[unit]") {
    const auto fan = on_a_line(ramp, {}, {{Wave::Kind::fan, 0, 1}});
    const auto marks = marks_of(Norm::fan_edge, fan, 0, 1);
    REQUIRE(marks.size() == 2);
    CHECK(marks[0].x == Approx(0.05));
    CHECK(marks[0].level == Approx(0.05));
    CHECK(marks[1].x == Approx(0.95));
    CHECK(marks[1].level == Approx(0.95));
    // The fan from 0.02 to 0.97: the 5 % level is passed at 0.0675, the other one at 0.9225.
    CHECK(error_of(Norm::fan_edge, fan, {-1, 0.02, 0.97, 2}, {0, 0.5, 1}, {0, 1, 0}) == Approx(0.0275).epsilon(1e-12));
    CHECK(error_of(Norm::fan_edge, fan, {-1, 0, 1, 2}, {0, 0.5, 1}, {0, 1, 0}) < 1e-15);
}

TEST_CASE("wave places: a profile that passes nowhere near has no place", "[alarm]") {
    CHECK(std::isnan(error_of(Norm::shock, one_jump(), {0, 0.5, 1}, {1, 0.6})));
    CHECK(std::isnan(error_of(Norm::shock, one_jump(), {0, 0.5, 1}, {1, NAN})));
    CHECK(std::isnan(error_of(Norm::shock, one_jump(), {0.5, 0.7, 1}, {1, 0})));  // the wave is outside the cells
    CHECK(std::isnan(error_of(Norm::contact, one_jump(), {0, 0.3, 1}, {1, 0})));
}

TEST_CASE("wave places: Sod's waves, and which fields feel them", "[published]") {
    // [Toro2009, table 4.2, test 1]: p* = 0.30313, v* = 0.92745; the shock runs at 1.7522, the fan from -1.1832 to
    // -0.0703.
    const auto exact = sod();
    const auto marks = [&](Norm kind, const std::string& field) {
        return marks_of(kind, exact, *exact.offset(field), 2);
    };
    REQUIRE(marks(Norm::shock, "pressure").size() == 1);
    CHECK(marks(Norm::shock, "pressure")[0].x == Approx(2 * 1.7522).epsilon(1e-4));
    CHECK(marks(Norm::shock, "pressure")[0].level == Approx(0.5 * (0.30313 + 0.1)).epsilon(1e-5));
    REQUIRE(marks(Norm::contact, "density").size() == 1);
    CHECK(marks(Norm::contact, "density")[0].x == Approx(2 * 0.92745).epsilon(1e-5));
    CHECK(marks(Norm::contact, "density")[0].level == Approx(0.5 * (0.42632 + 0.26557)).epsilon(1e-5));
    CHECK(marks(Norm::contact, "pressure").empty());
    CHECK(marks(Norm::contact, "velocity").empty());
    REQUIRE(marks(Norm::fan_edge, "velocity").size() == 2);
    const double width = 2 * (1.1832 - 0.0703);
    CHECK(marks(Norm::fan_edge, "velocity")[0].x == Approx(-2 * 1.1832 + 0.05 * width).epsilon(1e-4));
    CHECK(marks(Norm::fan_edge, "velocity")[1].x == Approx(-2 * 0.0703 - 0.05 * width).epsilon(2e-3));
}

TEST_CASE("wave places: what has nothing to measure says why", "[alarm]") {
    CHECK(why_nothing_of(Norm::contact, sod(), "density", 1).empty());
    CHECK(why_nothing_of(Norm::l1_fans, sod(), "density", 1).empty());
    CHECK_THAT(why_nothing_of(Norm::contact, sod(), "pressure", 1),
               ContainsSubstring("'pressure' is the same on both sides of every contact"));
    CHECK_THAT(why_nothing_of(Norm::fan_edge, one_jump(), "density", 1), ContainsSubstring("no fan at t = 1"));
    CHECK_THAT(why_nothing_of(Norm::l1_fans, one_jump(), "density", 1), ContainsSubstring("no fan at t = 1"));
    CHECK_THAT(why_nothing_of(Norm::shock, on_a_line(ramp), "density", 1), ContainsSubstring("does not tell"));
}

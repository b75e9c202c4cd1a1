// Iterations for a root: against the recursions of their errors, and at their limits.
#include "solvers/root_finding/root_finding.hpp"

#include <cmath>

#include "core/error.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using namespace ordo::solvers;
using root_finding::iterates;
using root_finding::Method;

namespace {

constexpr double root = 1.5;
constexpr double other = 2.3;

ScalarEquation parabola(double start, double second_start) {
    return {.f = [](double x) { return (x - root) * (x - other); },
            .slope = [](double x) { return 2 * x - root - other; },
            .start = start,
            .second_start = second_start};
}

}  // namespace

TEST_CASE("root finding: a parabola's errors obey the recursions that algebra gives", "[unit]") {
    // With e = root - x and d = other - root: f = e (e + d), f' = -(2 e + d). The error of each iterate below follows
    // from that alone; the iterates are rounded at 2.2e-16 of 2.3, a few times over.
    const double d = other - root;
    const double round_off = 4e-15;
    const auto newton = iterates(parabola(0, 0), Method::newton, 7);
    const auto modified = iterates(parabola(0, 0), Method::modified_newton, 40);
    const auto secant = iterates(parabola(0, 0.5), Method::secant, 10);
    REQUIRE((newton.size() == 8 && modified.size() == 41 && secant.size() == 11));
    for (std::size_t i = 0; i + 1 < newton.size(); ++i) {
        const double e = root - newton[i];
        CHECK(std::abs(root - newton[i + 1] - e * e / (2 * e + d)) < round_off);
    }
    for (std::size_t i = 0; i + 1 < modified.size(); ++i) {
        const double e = root - modified[i];
        CHECK(std::abs(root - modified[i + 1] - e * (1 - (e + d) / (2 * root + d))) < round_off);
    }
    for (std::size_t i = 1; i + 1 < secant.size(); ++i) {
        const double e = root - secant[i];
        const double before = root - secant[i - 1];
        if (e == before) continue;  // arrived
        CHECK(std::abs(root - secant[i + 1] - e * before / (e + before + d)) < round_off);
    }
}

TEST_CASE("root finding: it stays where it has arrived, and says where it cannot go on", "[unit]") {
    const auto there = iterates(parabola(root, 0), Method::newton, 3);
    CHECK(there == std::vector<double>(4, root));
    CHECK_THROWS_AS(iterates(parabola((root + other) / 2, 0), Method::newton, 2), Diverged);
    CHECK_THROWS_AS(iterates(parabola(0, 0), Method::secant, 3), Diverged);
}

TEST_CASE("root finding: a plan is the last correction, and refuses to have none", "[unit]") {
    const Solver solver = root_finding::solver();
    const auto options = resolve(solver.options, {}, "", "");
    const auto times = [&](double n) { return resolve(solver.resolution, {{"iterations", n}}, "", ""); };
    const Scene scene = parabola(0, 0.5);
    const auto x = iterates(parabola(0, 0), Method::newton, 4);
    CHECK(solver.plan(scene, options, times(4)).h == std::abs(x[4] - x[3]));
    CHECK_THROWS_AS(solver.plan(scene, options, times(12)), InputError);
    const auto secant = resolve(solver.options, {{"method", std::string("secant")}}, "", "");
    CHECK_THROWS_AS(solver.plan(scene, secant, times(1)), InputError);
    CHECK(solver.accepts(scene));
    CHECK_FALSE(solver.accepts(SolidScene<1>{}));
}

// Errors over cells against integrals in closed form.
#include "studies/engine/cell_errors.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/studies/engine/line_solutions.hpp"

using namespace ordo;
using namespace ordo::studies;
using namespace ordo::tests;
using oracles::Wave;

namespace {

constexpr double accuracy = 1e-10;  // stated: of the field's range times the length of the cells

CellErrors errors_of(const std::vector<double>& edges, const std::vector<double>& means, const oracles::Exact& exact,
                     const std::vector<double>& rises = {}) {
    const CellField field{{edges, means, rises}, 0};
    return cell_errors(std::span(&field, 1), exact, 1).at(0);
}

}  // namespace

TEST_CASE("cell errors: a constant against a linear function", "[unit]") {
    // The integral of |c - x| over [0, 1] is (c^2 + (1 - c)^2) / 2, of its square (c^3 + (1 - c)^3) / 3.
    const double c = GENERATE(-0.5, 0.0, 1e-3, 0.25, 0.5, 0.999, 1.0, 2.0);
    const double below = std::max(0.0, std::min(c, 1.0)), above = 1 - below;
    const double outside = std::abs(c - below);
    const auto errors = errors_of({0, 1}, {c}, on_a_line([](double x) { return x; }));
    CHECK(errors.l1 == Approx(0.5 * (below * below + above * above) + outside).margin(accuracy));
    CHECK(errors.l2 == Approx(std::sqrt((c * c * c + (1 - c) * (1 - c) * (1 - c)) / 3)).margin(accuracy));
    CHECK(std::isnan(errors.l1_fans));
}

TEST_CASE("cell errors: a cell with a slope against a linear function", "[unit]") {
    // 2 x on [0, 1] against x: the integral of x is 1/2. The same line has no error.
    const auto line = on_a_line([](double x) { return x; });
    CHECK(errors_of({0, 1}, {1}, line, {2}).l1 == Approx(0.5).margin(accuracy));
    CHECK(errors_of({0, 0.25, 1}, {0.125, 0.625}, line, {0.25, 0.75}).l1 < 1e-16);
    // Mirrored it is 1 - x: the integral of |1 - 2 x| is 1/2.
    CHECK(errors_of({0, 1}, {0.5}, line, {-1}).l1 == Approx(0.5).margin(accuracy));
}

TEST_CASE("cell errors: a jump inside a cell, whatever stands at its very place", "[unit]") {
    const double x0 = GENERATE(0.3, 1e-9, 0.5, 1 - 1e-12);
    const auto step = [x0](double x) { return x == x0 || x == 0 || x == 1 ? 1e9 : x < x0 ? 1.0 : 0.0; };
    const auto errors = errors_of({-1, 0, 1}, {1, x0}, on_a_line(step, {x0}));
    CHECK(errors.l1 == Approx(2 * x0 * (1 - x0)).margin(accuracy));
    CHECK(errors.l2 == Approx(std::sqrt(x0 * (1 - x0))).margin(1e-9));
}

TEST_CASE("cell errors: steps through a fan, and the inner half of it", "[unit]") {
    // Each of n steps of width w = 1/n through a slope of 1 has the error w^2 / 4.
    const std::size_t n = GENERATE(4u, 8u, 64u);
    const auto edges = equal_edges(-1, 2, 3 * n);
    std::vector<double> means;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) means.push_back(ramp(0.5 * (edges[i] + edges[i + 1])));
    const auto errors = errors_of(edges, means, on_a_line(ramp, {}, {{Wave::Kind::fan, 0, 1}}));
    const double all = 0.25 / static_cast<double>(n);
    CHECK(errors.l1 == Approx(all).margin(3 * accuracy));
    CHECK(errors.l1_fans == Approx(all / 2).margin(3 * accuracy));
    CHECK(errors.l2 == Approx(all * 2 / std::sqrt(3)).margin(3 * accuracy));
}

TEST_CASE("cell errors: a fan's corner inside a cell", "[unit]") {
    // One cell [-1, 1] at 0 against the ramp: 1/2. Its inner half [1/4, 3/4]: 1/4.
    const auto errors = errors_of({-1, 1}, {0}, on_a_line(ramp, {}, {{Wave::Kind::fan, 0, 1}}));
    CHECK(errors.l1 == Approx(0.5).margin(2 * accuracy));
    CHECK(errors.l1_fans == Approx(0.25).margin(2 * accuracy));
}

TEST_CASE("cell errors: two changes of sign in one cell, and curved solutions", "[unit]") {
    const auto square = on_a_line([](double x) { return x * x; });
    CHECK(errors_of({-1, 1}, {0.25}, square).l1 == Approx(0.5).margin(2 * accuracy));
    // |e^x - c| over [0, 1]: e - 1 - c + 2 (c ln c - c + 1) for c in [1, e].
    const auto exponential = on_a_line([](double x) { return std::exp(x); });
    for (const double c : {1.1, 1.5, 2.5}) {
        CHECK(errors_of({0, 1}, {c}, exponential).l1 ==
              Approx(std::exp(1) - 1 - c + 2 * (c * std::log(c) - c + 1)).margin(2 * accuracy));
    }
    // 30 waves in one cell: the rule is halved until it sees them. The integral of |sin| is 2 a half-wave.
    const double pi = std::acos(-1.0);
    const auto waves = on_a_line([pi](double x) { return 2 + std::sin(60 * pi * x); });
    CHECK(errors_of({0, 1}, {0}, waves).l1 == Approx(2).margin(2 * accuracy));
}

TEST_CASE("cell errors: a root at the plane of a blast, which nothing declares", "[unit]") {
    const auto root = on_a_line([](double x) { return std::sqrt(std::abs(x)); });
    CHECK(errors_of({-1, 1}, {0}, root).l1 == Approx(4.0 / 3).margin(2 * accuracy));
    // An odd one, of which every symmetric rule finds the same integral: none.
    const auto odd = on_a_line([](double x) { return x < 0 ? -std::sqrt(-x) : std::sqrt(x); });
    CHECK(errors_of({-1, 1}, {0}, odd).l1 == Approx(4.0 / 3).margin(2 * accuracy));
    CHECK(errors_of({-0.7, 1}, {0}, root).l1 == Approx(2.0 / 3 * (1 + std::pow(0.7, 1.5))).margin(2 * accuracy));
}

TEST_CASE("cell errors: Sod's tube against nothing holds the mass and the momentum that went in", "[gate]") {
    const auto& oracle = oracles::oracle_named("riemann_gas", "test");
    const auto exact = oracle.bind(resolve(oracle.parameters, {}, "test", oracle.name));
    const double t = 1.5;
    const auto edges = equal_edges(-5, 5, GENERATE(1u, 7u, 100u));
    const std::vector<double> zero(edges.size() - 1, 0.0);
    const std::vector<CellField> fields{{{edges, zero}, *exact.offset("density")},
                                        {{edges, zero}, *exact.offset("momentum")},
                                        {{edges, zero}, *exact.offset("total_energy")}};
    const auto errors = cell_errors(fields, exact, t);
    CHECK(errors[0].l1 == Approx(5 * (1 + 0.125)).margin(10 * accuracy));  // 5 m of either gas
    CHECK(errors[1].l1 == Approx((1 - 0.1) * t).margin(10 * accuracy));    // both pressures at work
    CHECK(errors[2].l1 == Approx(5 * (1 + 0.1) / 0.4).margin(30 * accuracy));
}

TEST_CASE("cell errors: none is exactly zero, also beside jumps", "[unit]") {
    const auto step = on_a_line([](double x) { return x < 0.5 ? 1000.1 : 7.3; }, {0.5});
    const auto errors = errors_of({0, 0.5, 0.6, 1}, {1000.1, 7.3, 7.3}, step);
    CHECK(errors.l1 == 0);
    CHECK(errors.l2 == 0);
}

TEST_CASE("cell errors: a field without a value has no error, and infinity does not vanish", "[alarm]") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto vacuum = on_a_line([](double x) { return x > 0.25 && x < 0.26 ? nan : 1; }, {0.25, 0.26});
    const auto errors = errors_of({0, 0.5, 1}, {1, 1}, vacuum);
    CHECK(std::isnan(errors.l1));
    CHECK(std::isnan(errors.l2));
    const auto one = on_a_line([](double) { return 1.0; });
    CHECK(std::isnan(errors_of({0, 0.5, 1}, {1, nan}, one).l1));
    CHECK_FALSE(std::isfinite(errors_of({0, 0.5, 1}, {1, INFINITY}, one).l1));
    CHECK_FALSE(std::isfinite(errors_of({0, 1}, {0.5}, on_a_line([](double x) { return x < 0.5 ? 0 : INFINITY; })).l1));
    CHECK_THROWS_AS(errors_of({0, nan, 1}, {1, 1}, one), std::logic_error);
}

TEST_CASE("cell errors: cells outside the box of the solution are refused", "[alarm]") {
    auto half = on_a_line([](double) { return 1.0; });
    half.lower = {0};
    CHECK_THROWS_AS(errors_of({-0.1, 1}, {1}, half), InputError);
    half.upper = {0.9};
    CHECK_THROWS_AS(errors_of({0, 1}, {1}, half), InputError);
    half.coordinates = oracles::Coordinates::material;
    CHECK_THROWS_AS(errors_of({0, 1}, {1}, half), std::logic_error);
}

TEST_CASE("cell errors: a solution with noise costs a bounded number of points", "[alarm]") {
    // Noise far above round-off looks rough at every scale.
    std::size_t points = 0;
    auto noisy = on_a_line([](double x) { return x + 1e-3 * std::sin(1e12 * x); });
    noisy.sample = [&points, inner = noisy.sample](std::span<const double> x, double t, std::span<double> rows) {
        points += x.size();
        inner(x, t, rows);
    };
    const auto edges = equal_edges(0, 1, 100);
    const auto errors = errors_of(edges, std::vector<double>(100, 0.0), noisy);
    CHECK(errors.l1 == Approx(0.5).epsilon(1e-3));
    CHECK(points < 1'000'000);
}

TEST_CASE("cell errors: the parts near a wave and away from it, cut exactly there", "[unit]") {
    // A step from 1 to 0 at 0.3 against the cells [-1, 0] at 1 and [0, 1] at 0.3: |e| is 0, then 0.7 and 0.3.
    auto step = on_a_line([](double x) { return x < 0.3 ? 1.0 : 0.0; }, {0.3});
    step.features = [](const std::string&, double) {
        return std::vector<oracles::Feature>{{oracles::Feature::Kind::contact, 0.3}};
    };
    const std::vector<double> edges{-1, 0, 1}, means{1, 0.3};
    const CellField field{{edges, means}, 0};
    const auto parts = [&](double near) { return cell_errors(std::span(&field, 1), step, 1, near).at(0); };
    CHECK(parts(0.1).l1_near == Approx(0.1 * 0.7 + 0.1 * 0.3).margin(accuracy));
    CHECK(parts(0.1).l1_away == Approx(0.2 * 0.7 + 0.6 * 0.3).margin(accuracy));
    CHECK(parts(0.5).l1_near == Approx(0.3 * 0.7 + 0.5 * 0.3).margin(accuracy));
    CHECK(parts(2).l1_near == Approx(0.42).margin(accuracy));
    CHECK(parts(2).l1_away == 0);
    for (const double near : {1e-9, 0.1, 0.3, 0.7}) {
        CHECK(parts(near).l1 == parts(near).l1_near + parts(near).l1_away);
        CHECK(parts(near).l1 == Approx(parts(0).l1).epsilon(1e-12));
    }
}

TEST_CASE("cell errors: of two waves the parts near both count, where they overlap once", "[unit]") {
    auto line = on_a_line([](double) { return 0.0; });
    line.features = [](const std::string&, double) {
        return std::vector<oracles::Feature>{{oracles::Feature::Kind::shock, 0.4},
                                             {oracles::Feature::Kind::fan_corner, 0.5, 1}};
    };
    const auto edges = equal_edges(0, 1, 7);
    const std::vector<double> means(7, 2.0);
    const CellField field{{edges, means}, 0};
    const auto errors = cell_errors(std::span(&field, 1), line, 1, 0.1).at(0);
    CHECK(errors.l1_near == Approx(2 * 0.3).margin(accuracy));  // from 0.3 to 0.6
    CHECK(errors.l1_away == Approx(2 * 0.7).margin(accuracy));
}

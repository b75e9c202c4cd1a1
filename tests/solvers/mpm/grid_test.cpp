#include "solvers/mpm/grid.hpp"

#include <limits>
#include <set>
#include <utility>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo::solvers;
using namespace ordo::solvers::mpm;

namespace {

const Resolution quarter{.cells = 4, .ppc = 1, .h = 0.25, .dt = 1};

template <int dim>
SolidScene<dim> unit_box(std::array<std::array<Face, 2>, dim> faces) {
    return {.lower = Vec<dim>::Zero(),
            .upper = Vec<dim>::Ones(),
            .rho = 1,
            .law = {},
            .faces = faces,
            .velocity = {},
            .body_force = {}};
}

template <int dim>
bool locates(const Grid<dim>& grid, const Vec<dim>& x) {
    int base = 0;
    Vec<dim> xi;
    return grid.locate(x, base, xi);
}

}  // namespace

TEST_CASE("grid: a position is found in its half-open cell", "[unit]") {
    const Grid<1> grid(unit_box<1>({{{Face::fixed, Face::fixed}}}), quarter, {});
    int base = -1;
    Vec<1> xi;
    for (const auto& [x, cell, local] : {std::tuple{0.0, 0, 0.0}, {0.125, 0, 0.5}, {0.25, 1, 0.0}, {0.9375, 3, 0.75}}) {
        REQUIRE(grid.locate(Vec<1>(x), base, xi));
        CHECK((base == cell && xi[0] == local));
    }
    REQUIRE(grid.locate(Vec<1>(std::nextafter(1.0, 0.0)), base, xi));
    CHECK((base == 3 && xi[0] <= 1));
}

TEST_CASE("grid: what is outside, and what is no number, is not found", "[unit]") {
    const double inf = std::numeric_limits<double>::infinity();
    const Grid<2> grid(unit_box<2>(test::all_faces<2>(Face::fixed)), quarter, {});
    CHECK(locates<2>(grid, {0.5, 0.5}));
    for (const double bad : {-1e-12, 1.0, 1.5, 1e300, std::nan(""), inf, -inf}) {
        CHECK_FALSE(locates<2>(grid, {bad, 0.5}));
        CHECK_FALSE(locates<2>(grid, {0.5, bad}));
    }
}

TEST_CASE("grid: an extrapolating grid goes on with its outer cells, but not for ever", "[unit]") {
    Options options;
    options.extrapolate = true;
    const Grid<2> grid(unit_box<2>(test::all_faces<2>(Face::free)), quarter, options);
    CHECK((grid.cells == std::array{4, 4}));  // no margin
    int base = -1;
    Vec<2> xi;
    REQUIRE(grid.locate({-0.125, 1.25}, base, xi));
    CHECK((base == 3 * grid.stride[1] && xi[0] == -0.5 && xi[1] == 2));
    for (const double bad : {-2.6, 2.6, 1e300, std::nan(""), std::numeric_limits<double>::infinity()}) {
        CHECK_FALSE(locates<2>(grid, {bad, 0.5}));
    }
}

TEST_CASE("grid: it goes on beyond free faces by the margin, at least by one cell, and only there", "[unit]") {
    Options options;
    options.margin = 0;
    const Grid<2> grid(unit_box<2>({{{Face::fixed, Face::free}, {Face::free, Face::roller}}}), quarter, options);
    CHECK((grid.cells == std::array{5, 5}));
    CHECK((grid.lower[0] == 0 && grid.lower[1] == -0.25));
    options.margin = 2;
    const Grid<2> wide(unit_box<2>({{{Face::fixed, Face::free}, {Face::free, Face::roller}}}), quarter, options);
    CHECK(wide.cells[0] >= 4 + 8);
    CHECK(wide.lower[1] <= -2);
    CHECK(wide.lower[1] + wide.h * wide.cells[1] == 1);
}

TEST_CASE("grid: a fixed face holds every component of its nodes, a roller the normal one, a free face none",
          "[unit]") {
    Options options;
    options.margin = 0;
    const Grid<2> grid(unit_box<2>({{{Face::fixed, Face::free}, {Face::roller, Face::free}}}), quarter, options);
    std::set<std::pair<int, int>> expected;
    for (int along = 0; along <= grid.cells[1]; ++along) {
        for (int axis = 0; axis < 2; ++axis) expected.insert({along * grid.stride[1], axis});  // x = 0
    }
    for (int along = 0; along <= grid.cells[0]; ++along) expected.insert({along * grid.stride[0], 1});  // y = 0
    std::set<std::pair<int, int>> held;
    for (const auto& [node, axis] : grid.held) CHECK(held.insert({node, axis}).second);  // none twice
    CHECK(held == expected);
}

TEST_CASE("grid: a face is held where the body ends, not where the grid ends", "[unit]") {
    // Upper face fixed, lower face free with a margin: the held node is at x = 1.
    const Grid<1> grid(unit_box<1>({{{Face::free, Face::fixed}}}), quarter, {});
    REQUIRE(grid.held.size() == 1);
    CHECK(grid.lower[0] + grid.h * grid.held[0].node == 1);
}

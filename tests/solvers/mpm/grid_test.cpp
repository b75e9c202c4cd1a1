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

const auto held_box = unit_box<1>({{{Face::fixed, Face::fixed}}});

template <int dim>
bool locates(const Grid<dim>& grid, const Vec<dim>& x) {
    Cell<dim> cell = Cell<dim>::Constant(nowhere);
    Vec<dim> xi;
    return grid.locate(x, cell, xi);
}

}  // namespace

TEST_CASE("grid: a position is found in its half-open cell", "[unit]") {
    const Grid<1> grid(held_box, {}, quarter);
    Vec<1> xi;
    for (const auto& [x, expected, local] :
         {std::tuple{0.0, 0, 0.0}, {0.125, 0, 0.5}, {0.25, 1, 0.0}, {0.9375, 3, 0.75}, {1.0, 3, 1.0}}) {
        Cell<1> cell(nowhere);
        REQUIRE(grid.locate(Vec<1>(x), cell, xi));
        CHECK((cell[0] == expected && xi[0] == local));
    }
    Cell<1> cell(nowhere);
    REQUIRE(grid.locate(Vec<1>(std::nextafter(1.0, 0.0)), cell, xi));
    CHECK((cell[0] == 3 && xi[0] <= 1));
}

TEST_CASE("grid: a point on a face stays in the cell where it was, and moves on beyond it", "[unit]") {
    const Grid<1> grid(held_box, {}, quarter);
    Vec<1> xi;
    for (const auto& [from, x, expected, local] : {std::tuple{0, 0.25, 0, 1.0},
                                                   {1, 0.25, 1, 0.0},
                                                   {2, 0.25, 1, 0.0},
                                                   {1, 0.5, 1, 1.0},
                                                   {3, 0.0, 0, 0.0},
                                                   {0, 0.3125, 1, 0.25}}) {
        Cell<1> cell(from);
        REQUIRE(grid.locate(Vec<1>(x), cell, xi));
        CHECK((cell[0] == expected && xi[0] == local));
    }
}

TEST_CASE("grid: round-off beyond an end belongs to the outer cell, more does not", "[unit]") {
    const Grid<1> grid(held_box, {}, quarter);
    for (const double cells : {1e-12, 0.9e-9}) {
        CHECK(locates<1>(grid, Vec<1>(-0.25 * cells)));
        CHECK(locates<1>(grid, Vec<1>(1 + 0.25 * cells)));
    }
    for (const double cells : {1.1e-9, 1e-3}) {
        CHECK_FALSE(locates<1>(grid, Vec<1>(-0.25 * cells)));
        CHECK_FALSE(locates<1>(grid, Vec<1>(1 + 0.25 * cells)));
    }
}

TEST_CASE("grid: what is outside, and what is no number, is not found", "[unit]") {
    const double inf = std::numeric_limits<double>::infinity();
    const Grid<2> grid(unit_box<2>(test::all_faces<2>(Face::fixed)), {}, quarter);
    CHECK(locates<2>(grid, {0.5, 0.5}));
    for (const double bad : {-1e-6, 1.5, 1e300, std::nan(""), inf, -inf}) {
        CHECK_FALSE(locates<2>(grid, {bad, 0.5}));
        CHECK_FALSE(locates<2>(grid, {0.5, bad}));
    }
}

TEST_CASE("grid: an extrapolating grid goes on with its outer cells, but not for ever", "[unit]") {
    const Grid<2> grid(unit_box<2>(test::all_faces<2>(Face::free)), {.beyond_grid = BeyondGrid::extrapolate}, quarter);
    CHECK((grid.cells == std::array{4, 4}));  // no margin
    Cell<2> cell = Cell<2>::Constant(nowhere);
    Vec<2> xi;
    REQUIRE(grid.locate({-0.125, 1.25}, cell, xi));
    CHECK((cell[0] == 0 && cell[1] == 3 && xi[0] == -0.5 && xi[1] == 2));
    for (const double bad : {-2.6, 2.6, 1e300, std::nan(""), std::numeric_limits<double>::infinity()}) {
        CHECK_FALSE(locates<2>(grid, {bad, 0.5}));
    }
}

TEST_CASE("grid: an extrapolating grid finds every new point in a cell that there is", "[unit]") {
    const Grid<1> grid(unit_box<1>(test::all_faces<1>(Face::free)), {.beyond_grid = BeyondGrid::extrapolate}, quarter);
    for (double x = -1; x <= 2; x += 0.125) {  // faces of cells that are not there among them
        Cell<1> cell(nowhere);
        Vec<1> xi;
        REQUIRE(grid.locate(Vec<1>(x), cell, xi));
        CAPTURE(x, cell[0]);
        CHECK((cell[0] >= 0 && cell[0] < 4));
        CHECK(0.25 * (cell[0] + xi[0]) == x);
    }
}

TEST_CASE("grid: it goes on beyond free faces by the margin, at least by one cell, and only there", "[unit]") {
    Options options;
    options.margin = 0;
    const Grid<2> grid(unit_box<2>({{{Face::fixed, Face::free}, {Face::free, Face::roller}}}), options, quarter);
    CHECK((grid.cells == std::array{5, 5}));
    CHECK((grid.lower[0] == 0 && grid.lower[1] == -0.25));
    options.margin = 2;
    const Grid<2> wide(unit_box<2>({{{Face::fixed, Face::free}, {Face::free, Face::roller}}}), options, quarter);
    CHECK(wide.cells[0] >= 4 + 8);
    CHECK(wide.lower[1] <= -2);
    CHECK(wide.lower[1] + wide.h * wide.cells[1] == 1);
}

TEST_CASE("grid: a fixed face holds every component of its nodes, a roller the normal one, a free face none",
          "[unit]") {
    Options options;
    options.margin = 0;
    const Grid<2> grid(unit_box<2>({{{Face::fixed, Face::free}, {Face::roller, Face::free}}}), options, quarter);
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
    const Grid<1> grid(unit_box<1>({{{Face::free, Face::fixed}}}), {}, quarter);
    REQUIRE(grid.held.size() == 1);
    CHECK(grid.lower[0] + grid.h * grid.held[0].node == 1);
}

TEST_CASE("grid: a total frame, a following and an extrapolating grid have no cell beyond the body", "[unit]") {
    const auto free = unit_box<1>(test::all_faces<1>(Face::free));
    CHECK(Grid<1>(free, {.frame = Frame::total}, quarter).cells[0] == 4);
    CHECK(Grid<1>(free, {.beyond_grid = BeyondGrid::follow}, quarter).cells[0] == 4);
    CHECK(Grid<1>(free, {.beyond_grid = BeyondGrid::extrapolate}, quarter).cells[0] == 4);
    CHECK(Grid<1>(free, {}, quarter).cells[0] == 4 + 2 * 2);  // ceil(0.1 * 4) + 1 at each end
}

TEST_CASE("grid: cells that span body and margin are as many as asked for", "[unit]") {
    auto scene = unit_box<1>({{{Face::fixed, Face::free}}});
    const Options options{.placement = Placement::body_centred, .margin = 0.15, .cells_span_grid = true};
    const Grid<1> grid(scene, options, {.cells = 10, .ppc = 3.5, .h = 0.115, .dt = 1});
    CHECK(grid.cells[0] == 10);
    CHECK((grid.lower[0] == 0 && grid.h == 0.115));
    CHECK(grid.held.size() == 1);
}

TEST_CASE("grid: nodes stand at the Greville points of their splines, from end to end", "[unit]") {
    const std::vector<double> tents{0, 1, 2, 3, 4}, quadratic{0, 0.5, 1.5, 2.5, 3.5, 4},
        cubic{0, 1.0 / 3, 1, 2, 3, 11.0 / 3, 4};  // means of the inner knots by hand
    for (const auto& [basis, places] :
         {std::pair{Basis::linear, tents}, {Basis::quadratic, quadratic}, {Basis::cubic, cubic}}) {
        Grid<1> grid(held_box, {.basis = basis}, quarter);
        REQUIRE(grid.nodes() == static_cast<int>(places.size()));
        for (int i = 0; i < grid.nodes(); ++i)
            CHECK(grid.position(i)[0] == Approx(0.25 * places[static_cast<std::size_t>(i)]).margin(1e-15));
        CHECK(grid.held.size() == 2);
        CHECK((grid.held[0].node == 0 && grid.held[1].node == grid.nodes() - 1));
        grid.fit(-0.5, 1.5);  // twice as wide
        CHECK(grid.position(0)[0] == -0.5);
        CHECK(grid.position(grid.nodes() - 1)[0] == 1.5);
        CHECK(grid.position(1)[0] == Approx(-0.5 + 0.5 * places[1]));
    }
}

TEST_CASE("grid: in the plane a node stands where its number along each axis says", "[unit]") {
    auto scene = unit_box<2>(test::all_faces<2>(Face::fixed));
    scene.upper[1] = 0.5;
    const Grid<2> grid(scene, {.basis = Basis::quadratic}, quarter);
    REQUIRE(grid.nodes() == 6 * 4);
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 4; ++j) {
            const Vec<2> x = grid.position(i * grid.stride[0] + j * grid.stride[1]);
            CHECK(x[0] == Approx(0.25 * std::array{0.0, 0.5, 1.5, 2.5, 3.5, 4.0}[static_cast<std::size_t>(i)]));
            CHECK(x[1] == Approx(0.25 * std::array{0.0, 0.5, 1.5, 2.0}[static_cast<std::size_t>(j)]));
        }
    }
}

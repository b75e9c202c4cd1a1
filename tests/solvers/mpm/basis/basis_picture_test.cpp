// The picture by which CPDI is explained: what a particle sees of the grid, at states that move and stretch.
#include "solvers/mpm/basis/basis_picture.hpp"

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/mpm/basis/lineups.hpp"

using namespace ordo;
using namespace ordo::solvers::mpm;
using namespace ordo::lineups;

namespace {

/// Two particles a cell: boxes of half a cell.
Picture state(Basis basis, double translate = 0, double stretch = 1) {
    return picture_of({.basis = basis, .cells = 12, .margin = 4, .ppc = 2, .translate = translate, .stretch = stretch});
}

/// S_i for a particle at x.
double seen(const Picture& picture, double x, int node) { return grid_basis(picture, std::vector{x})(0, node); }

std::string message(const Lineup& lineup) {
    try {
        picture_of(lineup, "here");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("basis picture: the body is shifted and stretched about its middle, boxes too", "[unit]") {
    // Particles at 2 and 4 in boxes of two cells; about 3: 3 -+ 1.5 + 0.25, boxes of 3 cells.
    const auto picture = picture_of({.cells = 12, .margin = 4, .ppc = 0.5, .translate = 0.25, .stretch = 1.5});
    REQUIRE(picture.count() == 2);
    CHECK(picture.nodes() == 13);
    CHECK(picture.positions()[0] == Approx(6.25 - 1.5).margin(1e-14));
    CHECK(picture.positions()[1] == Approx(6.25 + 1.5).margin(1e-14));
    REQUIRE(picture.corners.size() == 4);
    CHECK(picture.corners[0] == Approx(3.25).margin(1e-14));
    CHECK(picture.corners[1] == Approx(6.25).margin(1e-14));
    CHECK(picture.corners[3] == Approx(9.25).margin(1e-14));
}

TEST_CASE("basis picture: tents, their means and their corner values by hand", "[unit]") {
    const auto tent = state(Basis::linear);
    CHECK(seen(tent, 6.25, 6) == Approx(0.75).margin(1e-14));
    CHECK(seen(tent, 6.25, 7) == Approx(0.25).margin(1e-14));
    // Over [5.75, 6.25] the tent of node 6 has the mean 1 - 1/8, its neighbours' the mean 1/16.
    CHECK(seen(state(Basis::ugimp), 6, 6) == Approx(0.875).margin(1e-14));
    CHECK(seen(state(Basis::ugimp), 6, 5) == Approx(0.0625).margin(1e-14));
    // The corners of a box around 6.25 are 6 and 6.5.
    CHECK(seen(state(Basis::cpdi), 6.25, 6) == Approx(0.75).margin(1e-14));
    CHECK(seen(state(Basis::cpdi), 6.25, 7) == Approx(0.25).margin(1e-14));
    CHECK(seen(state(Basis::cpdi), 6, 6) == Approx(0.75).margin(1e-14));
    // Stretched to twice the length: [5.5, 6.5], mean 3/4, corners 1/2; boxes that stay as they were see no change.
    CHECK(seen(state(Basis::cpgimp, 0, 2), 6, 6) == Approx(0.75).margin(1e-14));
    CHECK(seen(state(Basis::cpdi, 0, 2), 6, 6) == Approx(0.5).margin(1e-14));
    CHECK(seen(state(Basis::ugimp, 0, 2), 6, 6) == Approx(0.875).margin(1e-14));
    // The middle one of three quadratic splines amid its cell is 3/4.
    CHECK(seen(state(Basis::quadratic), 6.5, 7) == Approx(0.75).margin(1e-14));
}

TEST_CASE("basis picture: what differs in more dimensions or in gradients only is the same", "[property]") {
    for (const auto& [F, t] : std::vector<std::pair<double, double>>{{0.5, 0.3}, {1, 0}, {1.7, 0.9}, {2, 1}}) {
        CHECK((state(Basis::cpdi, t, F).S - state(Basis::cpdi2, t, F).S).cwiseAbs().maxCoeff() < 1e-14);
        CHECK((state(Basis::linear, t, F).S - state(Basis::ddmp, t, F).S).cwiseAbs().maxCoeff() < 1e-14);
    }
    CHECK((state(Basis::ugimp, 0.3).S - state(Basis::cpgimp, 0.3).S).cwiseAbs().maxCoeff() < 1e-14);
    CHECK((state(Basis::ugimp, 0.3, 1.5).S - state(Basis::cpgimp, 0.3, 1.5).S).cwiseAbs().maxCoeff() > 0.01);
}

TEST_CASE("basis picture: every basis is a partition of unity and has linear fields, at any state", "[property]") {
    for (const Basis basis : every_basis) {
        for_every_state({0.5, 1, 1.5, 2, 3, 4}, [&](const Lineup& lineup) {
            const auto picture = picture_of(with(basis, lineup));
            Eigen::VectorXd nodes(picture.nodes());
            for (int i = 0; i < picture.nodes(); ++i) nodes[i] = picture.grid.position(i)[0];
            INFO(text_of(picture.lineup));
            // Sums of at most a hundred products of numbers up to 20.
            CHECK((picture.S.rowwise().sum().array() - 1).abs().maxCoeff() < 1e-13);
            CHECK((picture.S * nodes - picture.positions()).cwiseAbs().maxCoeff() < 1e-12);
            CHECK(picture.S.minCoeff() > -1e-15);
            const auto x = drawing_points(picture);
            CHECK((grid_basis(picture, x).rowwise().sum().array() - 1).abs().maxCoeff() < 1e-13);
            CHECK((grid_functions(picture, x).rowwise().sum().array() - 1).abs().maxCoeff() < 1e-13);
        });
    }
}

TEST_CASE("basis picture: a particle sees at its place what the matrix of the method holds", "[property]") {
    for (const Basis basis : every_basis) {
        const auto picture = state(basis, 0.37, 1.3);
        const Eigen::VectorXd x = picture.positions();
        const Weights seen_there = grid_basis(picture, std::vector<double>(x.begin(), x.end()));
        CHECK((seen_there - picture.S).cwiseAbs().maxCoeff() < 1e-14);
    }
}

TEST_CASE("basis picture: the interpolated tents are the tents at the corners and CPDI's weights at the middle",
          "[property]") {
    for (const auto& [F, t] : std::vector<std::pair<double, double>>{{0.5, 0.3}, {1, 0}, {1.7, 0.9}, {2, 1}}) {
        const auto picture = state(Basis::cpdi, t, F);
        const Eigen::VectorXd x = picture.positions();
        const Weights middle = interpolated_tents(picture, std::vector<double>(x.begin(), x.end()));
        CHECK((middle - picture.S).cwiseAbs().maxCoeff() < 1e-14);  // the mean of a linear function over its box
        const Weights ends = interpolated_tents(picture, picture.corners);
        CHECK((ends - grid_functions(picture, picture.corners)).cwiseAbs().maxCoeff() < 1e-11);  // 1e-12 of a box
        CHECK(interpolated_tents(picture, std::vector{0.5}).array().isNaN().all());
    }
}

TEST_CASE("basis picture: points for drawing rise, span the grid and hold corners and particles", "[unit]") {
    const auto picture = state(Basis::cpdi, 0.37, 1.3);
    const auto x = drawing_points(picture);
    CHECK(x.front() == 0);
    CHECK(x.back() == 12);
    CHECK(std::ranges::adjacent_find(x, std::greater_equal<>()) == x.end());
    const auto holds = [&](double at) {
        return std::ranges::any_of(x, [&](double y) { return std::abs(y - at) < 1e-11; });
    };
    CHECK(std::ranges::all_of(picture.corners, holds));
    CHECK(std::ranges::all_of(picture.positions(), holds));
    const auto between = points_between_particles(picture);
    CHECK(between.front() == picture.positions().minCoeff());
    CHECK(between.back() == picture.positions().maxCoeff());
}

TEST_CASE("basis picture: a body that has no room is refused, and the nearest that has is named", "[unit]") {
    CHECK(message({.cells = 6, .margin = 3}) ==
          "here: 'margin' is 3, but must leave a cell of the 6 to the body (nearest: 2)");
    CHECK(
        message({.cells = 6, .margin = 1, .stretch = 2}) ==
        "here: the body reaches from -1 to 7, but must stay on the grid from 0 to 6 (nearest: cells 8 with margin 2)");
    CHECK(message({.cells = 8, .margin = 2, .stretch = 2}).empty());
    CHECK_FALSE(message({.cells = 6, .margin = 1, .translate = -1.25}).empty());
    CHECK(message({.cells = 6, .margin = 1, .translate = -1}).empty());
}

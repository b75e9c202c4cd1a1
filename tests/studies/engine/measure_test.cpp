// Which norms are taken at points and which over cells.
#include "studies/engine/measure.hpp"

#include <cmath>
#include <stdexcept>

#include "tests/catch.hpp"
#include "tests/studies/engine/line_solutions.hpp"

using namespace ordo;
using namespace ordo::studies;
using namespace ordo::tests;

namespace {

/// Cells [0, 0.5] and [0.5, 2] with these means of the density.
solvers::Snapshot cells_with(const std::vector<double>& means) {
    solvers::Snapshot shot;
    shot.t = 1;
    shot.edges = {0, 0.5, 2};
    shot.x = shot.X = {0.25, 1.25};
    shot.weights = {0.5, 1.5};
    shot.fields = {{"density", 1, means}};
    return shot;
}

double error_of(Norm norm, const solvers::Snapshot& shot, const oracles::Exact& exact) {
    return errors_against_exact({{.field = "density", .norm = norm}}, shot, exact).at(0).value;
}

const auto line = on_a_line([](double x) { return x; });

}  // namespace

TEST_CASE("measure: l1 and l2 of cells are integrals, rms and linf are taken at their middles", "[unit]") {
    // e = 0.25 - x and 1.25 - x, zero in the middles: integrals of |e| 1/16 and 9/16, of e^2 1/96 and 27/96.
    const auto shot = cells_with({0.25, 1.25});
    CHECK(error_of(Norm::rms, shot, line) == 0);
    CHECK(error_of(Norm::linf, shot, line) == 0);
    CHECK(error_of(Norm::l1, shot, line) == Approx(10.0 / 16).epsilon(1e-10));
    CHECK(error_of(Norm::l2, shot, line) == Approx(std::sqrt(28.0 / 96)).epsilon(1e-10));
    CHECK(error_of(Norm::linf, cells_with({0.5, 1}), line) == 0.25);
}

TEST_CASE("measure: slopes belong to fields by name", "[unit]") {
    auto shot = cells_with({0.25, 1.25});
    shot.slopes = {{"velocity", 1, {7, 7}}, {"density", 1, {0.5, 1.5}}};
    CHECK(error_of(Norm::l1, shot, line) < 1e-15);
}

TEST_CASE("measure: points without cells are weighted as ever", "[unit]") {
    auto shot = cells_with({0.5, 1.25});
    shot.edges.clear();
    CHECK(error_of(Norm::l1, shot, line) == 0.125);
    CHECK(error_of(Norm::l2, shot, line) == Approx(std::sqrt(0.5) / 4).epsilon(1e-15));
    CHECK_THROWS_AS(error_of(Norm::shock, shot, line), std::logic_error);
}

TEST_CASE("measure: norms stand in the order in which they were asked for", "[unit]") {
    const auto step =
        on_a_line([](double x) { return x < 0.75 ? 1 : 0; }, {0.75}, {{oracles::Wave::Kind::shock, 0.75, 0.75}});
    const auto errors = errors_against_exact({{.field = "density", .norm = Norm::linf},
                                              {.field = "density", .norm = Norm::shock},
                                              {.field = "density", .norm = Norm::rms, .against = Against::finest},
                                              {.field = "density", .norm = Norm::l1}},
                                             cells_with({1, 0.125}), step);
    REQUIRE(errors.size() == 3);
    CHECK(errors[0] == RunFigure{"density.linf", 0.125});
    CHECK(errors[1] == RunFigure{"density.shock", 0.25});
    CHECK(errors[2].name == "density.l1");
    CHECK(errors[2].value == Approx(0.25 * 0.875 + 1.25 * 0.125).epsilon(1e-10));
}

TEST_CASE("measure: cells that do not go with their field are a fault of the solver", "[alarm]") {
    auto shot = cells_with({1, 1});
    shot.slopes = {{"density", 1, {1}}};
    CHECK_THROWS_AS(error_of(Norm::l1, shot, line), std::logic_error);
    shot = cells_with({1, 1});
    shot.edges.push_back(3);
    CHECK_THROWS_AS(error_of(Norm::l1, shot, line), std::logic_error);
}

TEST_CASE("measure: points belong to the part near a wave, or away from it, by their position", "[unit]") {
    auto exact = on_a_line([](double) { return 0.0; });
    exact.features = [](const std::string&, double) {
        return std::vector<oracles::Feature>{{oracles::Feature::Kind::linear, 1, 1}};
    };
    auto shot = cells_with({3, 5});
    shot.edges.clear();
    shot.X = {7, 7};  // the exact solution is in space
    const auto errors = errors_against_exact({{.field = "density", .norm = Norm::l1},
                                              {.field = "density", .norm = Norm::l1_near, .near = 0.3},
                                              {.field = "density", .norm = Norm::l1_away, .near = 0.3}},
                                             shot, exact);
    CHECK(errors.at(0).value == 0.5 * 3 + 1.5 * 5);
    CHECK(errors.at(1).value == 1.5 * 5);  // x = 1.25 and not x = 0.25
    CHECK(errors.at(2).value == 0.5 * 3);
    exact.coordinates = oracles::Coordinates::material;
    CHECK(errors_against_exact({{.field = "density", .norm = Norm::l1_near, .near = 0.3}}, shot, exact).at(0).value ==
          0);
}

TEST_CASE("measure: parts of cells follow their own distance", "[unit]") {
    auto exact = on_a_line([](double) { return 0.0; });
    exact.features = [](const std::string&, double) {
        return std::vector<oracles::Feature>{{oracles::Feature::Kind::shock, 0.5}};
    };
    const auto errors = errors_against_exact({{.field = "density", .norm = Norm::l1},
                                              {.field = "density", .norm = Norm::l1_near, .near = 0.25},
                                              {.field = "density", .norm = Norm::l1_away, .near = 0.25}},
                                             cells_with({4, 8}), exact);
    CHECK(errors.at(0).value == Approx(0.5 * 4 + 1.5 * 8).epsilon(1e-12));
    CHECK(errors.at(1).value == Approx(0.25 * 4 + 0.25 * 8).epsilon(1e-12));
    CHECK(errors.at(2).value == Approx(0.25 * 4 + 1.25 * 8).epsilon(1e-12));
}

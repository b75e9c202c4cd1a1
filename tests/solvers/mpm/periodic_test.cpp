// Periodic faces: the body goes on behind them, at rest or moving.
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

constexpr double two_pi = 6.283185307179586;

SolidScene<1> bar(Face face, double v0) {
    return {.lower = Vec<1>(0.0),
            .upper = Vec<1>(1.0),
            .rho = 1,
            .law = make_law("E ln F", {.lambda = 0, .mu = 0.5}),
            .faces = {{{face, face}}},
            .velocity = pointwise<1>([=](const Vec<1>& X, double) { return Vec<1>(v0 * std::sin(two_pi * X[0])); })};
}

/// The wave of `v0 sin` moved by `phase` of a period, and a stream on top of it.
SolidScene<1> wave(double v0, double phase, double stream) {
    SolidScene<1> scene = bar(Face::periodic, v0);
    scene.velocity =
        pointwise<1>([=](const Vec<1>& X, double) { return Vec<1>(stream + v0 * std::sin(two_pi * (X[0] - phase))); });
    return scene;
}

std::vector<double> velocities(const Scene& scene, const Given& options, double t) {
    const auto run = started(scene, options, {{"cells", 8.0}, {"ppc", 2.0}, {"courant", 0.2}});
    run->advance_to(t, never);
    return run->snapshot().field("velocity").values;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b, std::size_t ahead = 0) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[(i + ahead) % b.size()]));
    return largest;
}

const std::vector<Given> variants{
    {{"basis", "linear"}},
    {{"basis", "quadratic"}},
    {{"basis", "cubic"}},
    {{"basis", "quartic"}},
    {{"basis", "ugimp"}},
    {{"basis", "cpdi"}},
    {{"basis", "quadratic"}, {"mass", "consistent"}},
    {{"basis", "linear"}, {"mass", "fmpm"}, {"transfer", "fmpm"}, {"stress_update", "usl"}},
    {{"basis", "cubic"}, {"frame", "total"}}};

}  // namespace

TEST_CASE("periodic faces: a wave moved by a cell makes the same motion a cell further on", "[property]") {
    for (const auto& options : variants) {
        const auto here = velocities(wave(1e-2, 0, 0), options, 0.7);
        const auto there = velocities(wave(1e-2, 0.125, 0), options, 0.7);
        INFO(std::get<std::string>(options.begin()->second));
        CHECK(largest_difference(here, there, 2) < 1e-15);  // round-off of 1e-2 over 28 steps
    }
}

TEST_CASE("periodic faces: where walls would stand still anyway the bar moves as between walls", "[property]") {
    const auto free = velocities(bar(Face::periodic, 1e-2), {{"basis", "linear"}}, 0.7);
    const auto walls = velocities(bar(Face::fixed, 1e-2), {{"basis", "linear"}, {"kernel", "readable"}}, 0.7);
    CHECK(largest_difference(free, walls) < 1e-15);
}

TEST_CASE("periodic faces: a stream carries a body round and round, whole and without stress", "[property]") {
    for (const auto& options : variants) {
        const auto run = started(wave(0, 0, 1.5), options, {{"cells", 8.0}, {"ppc", 2.0}, {"courant", 0.2}});
        run->advance_to(3.3, never);
        const auto shot = run->snapshot();
        INFO(std::get<std::string>(options.begin()->second));
        for (std::size_t p = 0; p < shot.points(); ++p) {
            CHECK(shot.field("velocity").values[p] == Approx(1.5).epsilon(1e-12));
            CHECK(shot.field("displacement").values[p] == Approx(3.3 * 1.5).epsilon(1e-12));
            CHECK(std::abs(shot.field("stress").values[p]) < 1e-12);
        }
        for (const auto& [name, value] : run->drift()) CHECK(value < 1e-12);
    }
}

TEST_CASE("periodic faces: momentum and mass stay, of a wave in a stream that crosses the faces", "[property]") {
    for (const auto& options : variants) {
        const auto run = started(wave(1e-2, 0.3, 0.7), options, {{"cells", 8.0}, {"ppc", 3.0}, {"courant", 0.2}});
        run->advance_to(2, never);
        INFO(std::get<std::string>(options.begin()->second));
        for (const auto& [name, value] : run->drift()) CHECK(value < 1e-12);
    }
}

TEST_CASE("periodic faces: what looks at distances or ends refuses them by name", "[alarm]") {
    const SolidScene<1> scene = bar(Face::periodic, 1e-2);
    const Given resolution{{"cells", 8.0}, {"courant", 0.2}};
    for (const auto& options : std::vector<Given>{{{"transfer", "tpic"}},
                                                  {{"basis", "cpdi2"}},
                                                  {{"basis", "ddmp"}},
                                                  {{"beyond_grid", "follow"}},
                                                  {{"body_force", "nodes"}}})
        CHECK_THROWS_WITH(started(scene, options, resolution), ContainsSubstring("periodic"));
    SolidScene<1> half = scene;
    half.faces[0][1] = Face::free;
    CHECK_THROWS_WITH(started(half, {}, resolution), ContainsSubstring("the one across must be periodic too"));
    const Solver& fem = solver_named("fem", "");
    CHECK_THROWS_WITH(fem.plan(scene, resolve(fem.options, {}, "", ""), resolve(fem.resolution, resolution, "", "")),
                      ContainsSubstring("periodic"));
}

TEST_CASE("places: spread and shift put particles where they say, and not out of their cell", "[unit]") {
    const auto X = [](const Given& places) {
        Given resolution{{"cells", 2.0}, {"ppc", 2.0}, {"courant", 0.2}};
        resolution.insert(places.begin(), places.end());
        return started(bar(Face::fixed, 0), {}, resolution)->snapshot().X;
    };
    CHECK(X({}) == std::vector{0.125, 0.375, 0.625, 0.875});
    const auto spread = X({{"spread", 1.6}});  // local 0.1 and 0.9
    CHECK(spread[0] == Approx(0.05).epsilon(1e-15));
    CHECK(spread[3] == Approx(0.95).epsilon(1e-15));
    const auto shifted = X({{"shift", 0.4}});  // 0.4 of a quarter
    for (std::size_t p = 0; p < 4; ++p)
        CHECK(shifted[p] == Approx(0.125 + 0.25 * static_cast<double>(p) + 0.1).epsilon(1e-15));
    CHECK_THROWS_WITH(X({{"shift", 0.6}}), ContainsSubstring("must lie in [0, 1]"));
    CHECK_THROWS_WITH(X({{"spread", 3.0}}), ContainsSubstring("must lie in [0, 1]"));
}

TEST_CASE("places: scattered particles stay in their parts, differ from each other, and are the same each time",
          "[unit]") {
    const auto X = [](double scatter) {
        return started(bar(Face::fixed, 0), {}, {{"cells", 16.0}, {"ppc", 4.0}, {"courant", 0.2}, {"scatter", scatter}})
            ->snapshot()
            .X;
    };
    const auto regular = X(0);
    const auto scattered = X(1);
    CHECK(scattered == X(1));
    double sum = 0, squares = 0;
    for (std::size_t p = 0; p < regular.size(); ++p) {
        const double part = (scattered[p] - regular[p]) * 64;
        CHECK(std::abs(part) <= 0.5);
        sum += part;
        squares += part * part;
    }
    // 64 numbers, uniform on one unit: mean 0 +- 4 of its 0.036, mean square 1/12 +- 4 of its 0.0093.
    CHECK(std::abs(sum / 64) < 4 * 0.036);
    CHECK(squares / 64 == Approx(1.0 / 12).margin(4 * 0.0093));
}

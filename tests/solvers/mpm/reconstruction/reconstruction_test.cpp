#include "solvers/mpm/reconstruction/reconstruction.hpp"

#include <cmath>
#include <numeric>
#include <string>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/rows.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

Options options(const std::string& kind, Given more = {}) {
    more.insert({{"reconstruction", kind}, {"beyond_grid", "follow"}});
    if (kind == "impm") more.insert({"stress_update", "usl"});
    return options_of(more);
}

/// A bar from 0 to 1 in five cells with three particles each, stretched with the grid that follows it.
struct Bar {
    SolidScene<1> scene = fixed_free_bar(1, 2, 0, LogarithmicLaw{});
    Grid<1> grid;
    Particles<1> p;
    Reconstruction1D rebuilt;

    explicit Bar(const Options& chosen, double stretch = 1)
        : grid(scene, chosen, {.cells = 5, .ppc = 3, .h = 0.2, .dt = 1}),
          p(seeded<1>(scene, chosen, {.cells = 5, .ppc = 3, .h = 0.2, .dt = 1}, false)),
          rebuilt(chosen) {
        for (auto& x : p.x) x *= stretch;
        for (auto& V : p.volume) V *= stretch;
        grid.fit(0, stretch);
        rebuilt.place(grid, p);
    }
    template <class F>
    void set(F f) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            p.v[i][0] = f(p.x[i][0]);
            p.sigma[i](0, 0) = f(p.x[i][0]);
        }
        rebuilt.sample_velocity(p);
        rebuilt.sample_forces(p, p.v);
    }
};

}  // namespace

TEST_CASE("reconstruction: points fill the body from end to end, each in its cell", "[unit]") {
    const auto kind = GENERATE(as<std::string>{}, "cubic_spline", "tls", "mls", "impm");
    const double stretch = GENERATE(0.93, 1.0, 1.11);
    INFO(kind << ", stretch " << stretch);
    const Bar bar(options(kind), stretch);
    const auto& points = bar.rebuilt.points;
    const std::size_t a_cell = kind == "impm" ? 1 : kind == "tls" ? 2 : 4;
    CHECK(points.size() == a_cell * 5);
    double length = 0;
    double moment = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        length += points.volume[k];
        moment += points.volume[k] * points.x[k][0];
        if (k > 0) CHECK(points.x[k][0] > points.x[k - 1][0]);
        CHECK(Row<1>(bar.grid, bar.rebuilt.stencils, k).x[0] == Approx(points.x[k][0]));
    }
    CHECK(length == Approx(stretch).epsilon(1e-14));
    CHECK(moment == Approx(0.5 * stretch * stretch).epsilon(1e-14));  // every rule is exact for linear fields
    CHECK((points.x.front()[0] > 0 && points.x.back()[0] < stretch));
}

TEST_CASE("reconstruction: stencils are kept while the grid stretches, and found anew with other cells", "[unit]") {
    const auto basis = GENERATE(as<std::string>{}, "linear", "quadratic", "cubic");
    const Options chosen = options("mls", {{"basis", basis}});
    Bar bar(chosen);
    const auto check = [&](const Grid<1>& grid) {
        const auto& points = bar.rebuilt.points;
        Stencils<1> fresh;
        std::vector<Cell<1>> cell(points.size(), Cell<1>::Constant(nowhere));
        REQUIRE(fill_at_points<1>(grid, std::span<const Vec<1>>(points.x), cell, fresh).rows == points.size());
        REQUIRE(bar.rebuilt.stencils.points() == points.size());
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Row<1> kept(grid, bar.rebuilt.stencils, k), found(grid, fresh, k);
            REQUIRE(kept.at.size() == found.at.size());
            for (const auto& [i, entry] : found.at) {  // places in the cell differ by round-off of x / h
                CHECK(kept[i].w == Approx(entry.w).margin(1e-14));
                CHECK(kept[i].grad[0] == Approx(entry.grad[0]).margin(1e-12));
            }
        }
    };
    check(bar.grid);
    bar.grid.fit(0.02, 1.3);
    for (auto& x : bar.p.x) x[0] = 0.02 + 1.28 * x[0];
    bar.rebuilt.place(bar.grid, bar.p);
    check(bar.grid);
    for (const int cells : {4, 7}) {
        Grid<1> other(bar.scene, chosen, {.cells = cells, .ppc = 3, .h = 1.0 / cells, .dt = 1});
        other.fit(0.02, 1.3);
        bar.rebuilt.place(other, bar.p);
        check(other);
    }
}

TEST_CASE("reconstruction: a uniform body keeps its density and mass", "[unit]") {
    const auto kind = GENERATE(as<std::string>{}, "cubic_spline", "tls", "mls", "impm");
    INFO(kind);
    const Bar bar(options(kind));
    const auto& points = bar.rebuilt.points;
    for (std::size_t k = 0; k < points.size(); ++k) CHECK(points.m[k] == Approx(2 * points.volume[k]).epsilon(1e-12));
    CHECK(std::accumulate(points.m.begin(), points.m.end(), 0.0) == Approx(2).epsilon(1e-12));
}

TEST_CASE("reconstruction: linear fields come out exactly, and of the degree where there is one", "[unit]") {
    struct Kind {
        std::string name;
        int degree;
    };
    const auto kind = GENERATE(values<Kind>({{"cubic_spline", 3}, {"tls", 1}, {"mls", 3}, {"impm", 1}}));
    INFO(kind.name);
    for (int power = 0; power <= kind.degree; ++power) {
        Bar bar(options(kind.name, {{"degree", 3.0}}));
        const auto f = [power](double x) { return std::pow(x, power) - 0.3; };
        bar.set(f);
        const auto& points = bar.rebuilt.points;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double expected = f(points.x[k][0]);
            CHECK(points.sigma[k](0, 0) == Approx(expected).margin(1e-11));
            if (kind.name == "impm") continue;
            CHECK(points.v[k][0] == Approx(expected).margin(1e-11));
            CHECK(bar.rebuilt.b[k][0] == Approx(expected).margin(1e-11));
        }
        REQUIRE(bar.rebuilt.knows_node_velocities() == (kind.name == "impm"));
        if (kind.name != "impm") continue;
        CHECK(bar.rebuilt.b.empty());
        for (int i = 0; i <= 5; ++i)  // nodes of the body
            CHECK(bar.rebuilt.node_v[static_cast<std::size_t>(i)][0] ==
                  Approx(f(bar.grid.position(i)[0])).margin(1e-11));
    }
}

TEST_CASE("reconstruction: without a force there is none at the points", "[unit]") {
    Bar bar(options("mls"));
    bar.set([](double) { return 1.0; });
    CHECK(bar.rebuilt.b.size() == bar.rebuilt.points.size());
    bar.rebuilt.sample_forces(bar.p, {});
    CHECK(bar.rebuilt.b.empty());
}

TEST_CASE("reconstruction: Taylor least squares keeps mass and momentum of every cell, mls the mass", "[property]") {
    const auto kind = GENERATE(as<std::string>{}, "tls", "mls");
    Bar bar(options(kind));
    for (std::size_t i = 0; i < bar.p.size(); ++i) bar.p.m[i] *= 1 + 0.3 * std::sin(7.0 * double(i));
    bar.rebuilt.place(bar.grid, bar.p);
    bar.set([](double x) { return std::cos(9 * x); });
    const auto& points = bar.rebuilt.points;
    double mass = 0;
    double momentum = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        mass += points.m[k];
        momentum += points.m[k] * points.v[k][0];
    }
    CHECK(mass == Approx(std::accumulate(bar.p.m.begin(), bar.p.m.end(), 0.0)).epsilon(1e-13));
    if (kind == "tls") CHECK(momentum == Approx(test::momentum(bar.p)[0]).epsilon(1e-12));
}

// The door of the solver: what it takes and refuses, what a run answers, and how it ends when it cannot go on.
#include <limits>
#include <numeric>

#include "core/error.hpp"
#include "tests/solvers/godunov/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::godunov;
using namespace ordo::solvers::godunov::test;

namespace {

using Kind = LineEnd::Kind;
const Given ten_cells{{"cells", 10.0}};

LineScene hooke_line() {
    const ElasticMedium<HookeEnergy> line;
    return {line, {-1, 0, 1}, {line.contents(0.8, 0.3, 0.4), line.contents(1.25, -0.1, 0.9)}};
}

void require_refused(const LineScene& scene, const Given& options, const std::string& part) {
    const Solver godunov = solver();
    const Values chosen = resolve(godunov.options, options, "", "solver godunov");
    const Values fine = resolve(godunov.resolution, ten_cells, "", "solver godunov");
    CHECK_THROWS_AS(godunov.plan(scene, chosen, fine), InputError);
    CHECK_THROWS_WITH(godunov.plan(scene, chosen, fine),
                      ContainsSubstring("solver godunov") && ContainsSubstring(part));
    CHECK_THROWS_AS(godunov.start(scene, chosen, fine, {}), InputError);
}

}  // namespace

TEST_CASE("godunov: it takes lines, and no other kind of scene", "[unit]") {
    const Solver godunov = solver();
    CHECK(godunov.accepts(LineScene{}));
    CHECK_FALSE(godunov.accepts(SolidScene<1>{}));
    CHECK_FALSE(godunov.accepts(ScalarEquation{}));
}

TEST_CASE("godunov: the plan is the width, the first step and the number of cells", "[unit]") {
    const Solver godunov = solver();
    const Values options = resolve(godunov.options, {}, "", "");
    const auto scene = sod.scene(0, 2);
    const auto plan =
        godunov.plan(scene, options, resolve(godunov.resolution, {{"cells", 40.0}, {"courant", 0.9}}, "", ""));
    CHECK(plan.h == 0.25);
    CHECK(plan.points == 40);
    CHECK(plan.dt == Approx(0.9 * 0.25 / (2 + std::sqrt(1.4))).epsilon(1e-14));
    const auto run =
        godunov.start(scene, options, resolve(godunov.resolution, {{"cells", 40.0}, {"courant", 0.9}}, "", ""), {});
    run->advance_to(1.01 * plan.dt, never);
    CHECK(figure(run->work(), "steps") == 2);
    CHECK(figure(run->work(), "cell_updates") == 80);
}

TEST_CASE("godunov: ends that move are refused with the reason", "[unit]") {
    auto scene = sod.scene();
    scene.ends[1] = {.kind = Kind::free};
    require_refused(scene, {}, "the right end is free");
    scene.ends[1] = {.kind = Kind::wall, .velocity = 0.5};
    require_refused(scene, {}, "moves with 0.5 m/s");
    scene.ends = {LineEnd{.kind = Kind::periodic}, LineEnd{}};
    require_refused(scene, {}, "the left end is periodic and the other is not");
}

TEST_CASE("godunov: a state without a speed of sound is refused", "[unit]") {
    auto scene = sod.scene();
    scene.pieces[1] = IdealGas{}.contents(1, 0, 0);
    require_refused(scene, {}, "piece 1");
    scene = sod.scene();
    scene.ends[0] = {.kind = Kind::prescribed, .outside = IdealGas{}.contents(1, 0, -1)};
    require_refused(scene, {}, "a prescribed end");
    scene = hooke_line();
    scene.pieces[0].mass = std::numeric_limits<double>::quiet_NaN();
    require_refused(scene, {}, "piece 0");
}

TEST_CASE("godunov: what is for a gas is refused on an elastic line", "[unit]") {
    require_refused(hooke_line(), {{"speeds", "pressure"}}, "'davis'");
    CHECK_NOTHROW(started(hooke_line(), {{"flux", "hllc"}}, ten_cells, {}));
    CHECK_THROWS_WITH(started(hooke_line(), {}, ten_cells, {"pressure"}),
                      ContainsSubstring("an elastic line has no field 'pressure'"));
    CHECK_THROWS_WITH(started(sod.scene(), {}, ten_cells, {"strain"}),
                      ContainsSubstring("a gas has no field 'strain'"));
}

TEST_CASE("godunov: a snapshot holds cells side by side, and the fields of the oracles", "[unit]") {
    const auto shot = at(sod.scene(1), 0, {}, ten_cells);
    REQUIRE(shot.edges.size() == 11);
    CHECK(shot.edges.front() == -4);
    CHECK(shot.edges.back() == 6);
    CHECK(shot.x[2] == Approx(-1.5));
    CHECK(shot.X == shot.x);
    CHECK(std::accumulate(shot.weights.begin(), shot.weights.end(), 0.0) == Approx(10));
    const oracles::RiemannGas exact(sod.left, sod.right, 1);
    for (std::size_t i = 0; i < 10; ++i) {
        const auto row = exact.mean(shot.edges[i], shot.edges[i + 1], 0).row();
        for (std::size_t k = 0; k < row.size(); ++k) {
            CHECK(shot.fields[k].name == gas_fields[k]);
            CHECK(shot.fields[k].values[i] == Approx(row[k]).epsilon(1e-14));
        }
    }
}

TEST_CASE("godunov: contents of pieces are shared out to the cells that they lie in", "[unit]") {
    const IdealGas gas;
    const LineScene scene{
        gas, {0, 0.25, 0.3, 1}, {gas.contents(1, 1, 1), gas.contents(3, 2, 1), gas.contents(2, 0, 5)}};
    const auto rho = at(scene, 0, {}, {{"cells", 2.0}}).field("density").values;
    CHECK(rho[0] == Approx((0.25 * 1 + 0.05 * 3 + 0.2 * 2) / 0.5));
    CHECK(rho[1] == 2);
}

TEST_CASE("godunov: slopes are the limited rises, and only of second order", "[unit]") {
    const IdealGas gas;
    LineScene scene{gas, {0, 1, 2, 3, 4, 5}, {}};
    for (const double rho : {1.0, 1.5, 2.5, 2.6, 2.0}) scene.pieces.push_back(gas.contents(rho, 0.3, 1));
    const auto rises = [&](const std::string& limiter) {
        return at(scene, 0, {{"limiter", limiter}}, {{"cells", 5.0}}, {"density", "velocity", "momentum"}).slopes;
    };
    // Cell 1 lies between differences 0.5 and 1, cell 2 between 1 and 0.1, cell 3 is a crest; cells 0 and 4 have the
    // same gas beyond the end.
    const auto expect = [&](const std::string& limiter, double first, double second, double third) {
        const auto density = rises(limiter)[0].values;
        CHECK(density[1] == Approx(first));
        CHECK(density[2] == Approx(second));
        CHECK(std::abs(density[3] - third) < 1e-15);
        CHECK(std::abs(density[0]) < (limiter == "central" ? 0.26 : 1e-15));
    };
    expect("minmod", 0.5, 0.1, 0);
    expect("van_leer", 2.0 / 3, 0.2 / 1.1, 0);
    expect("mc", 0.75, 0.2, 0);
    expect("superbee", 1, 0.2, 0);
    expect("central", 0.75, 0.55, -0.25);
    const auto slopes = rises("minmod");
    REQUIRE(slopes.size() == 3);
    CHECK(std::abs(slopes[1].values[1]) < 1e-15);
    CHECK(slopes[2].values[1] == Approx(0.15));
    CHECK(at(scene, 0, {{"order", "first"}}, {{"cells", 5.0}}).slopes.empty());
}

TEST_CASE("godunov: a run ends at the time asked for, and the way there may be cut", "[property]") {
    const auto whole = started(sod.scene(), {}, {{"cells", 100.0}});
    const auto cut = started(sod.scene(), {}, {{"cells", 100.0}});
    whole->advance_to(1, never);
    for (const double t : {0.1, 0.31, 0.5, 1.0}) {
        cut->advance_to(t, never);
        CHECK(cut->snapshot().t == t);
    }
    CHECK(whole->snapshot().t == 1);
    const auto a = whole->snapshot().field("density").values;
    const auto b = cut->snapshot().field("density").values;
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(std::abs(a[i] - b[i]) < 2e-3);
    whole->advance_to(1, never);
    CHECK(whole->snapshot().field("density").values == a);
}

TEST_CASE("godunov: it stops when asked between two steps", "[unit]") {
    const auto run = started(sod.scene(), {}, ten_cells);
    int asked = 0;
    CHECK_THROWS_AS(run->advance_to(100, [&] { return ++asked == 4; }), Interrupted);
    CHECK(figure(run->work(), "steps") == 3);
}

TEST_CASE("godunov: a run that goes beyond matter says where and when", "[unit]") {
    // Two gases that part so fast that a vacuum opens, at the limit of stability and without a limiter.
    const IdealGas gas;
    const LineScene scene{gas, {-1, 0, 1}, {gas.contents(1, -20, 0.4), gas.contents(1, 20, 0.4)}};
    const auto run =
        started(scene, {{"speeds", "einfeldt"}, {"limiter", "central"}}, {{"cells", 50.0}, {"courant", 1.0}});
    CHECK_THROWS_WITH(run->advance_to(0.02, never),
                      ContainsSubstring("the cell at x = ") && ContainsSubstring("at t = "));
    CHECK_THROWS_AS(run->advance_to(0.02, never), Diverged);
}

TEST_CASE("godunov: a state that is no matter is noticed at every face, and only there", "[unit]") {
    const std::size_t n = 29;
    const IdealGas gas;
    const auto matter = [&](std::size_t before_at, std::size_t behind_at) {
        Columns before(n), behind(n), through(n);
        for (std::size_t i = 0; i < n; ++i) {
            before.set(i, gas.contents(1, 0.3, i == before_at ? -1 : 1));
            behind.set(i, gas.contents(i == behind_at ? -1 : 1, 0.3, 1));
        }
        return pass_faces(gas, {}, before, behind, {1, n - 2}, through);
    };
    CHECK(matter(n, n));
    for (std::size_t i = 1; i <= n - 3; ++i) {
        CHECK_FALSE(matter(i, n));
        CHECK_FALSE(matter(n, i + 1));
    }
    CHECK(matter(0, n));
    CHECK(matter(n, 1));
    CHECK(matter(n - 2, n));
}

TEST_CASE("godunov: near a vacuum a face that is no matter takes the mean of its cell", "[property]") {
    // Toro's second test: p* is a two-hundredth of the pressure around it.
    const GasPair toro_2{{.rho = 1, .v = -2, .p = 0.4}, {.rho = 1, .v = 2, .p = 0.4}, 2.5};
    const oracles::RiemannGas exact(toro_2.left, toro_2.right);
    const auto limiter = GENERATE(std::string("superbee"), std::string("mc"), std::string("central"));
    const auto shot = at(toro_2.scene(), 0.6, {{"limiter", limiter}}, {{"cells", 400.0}, {"courant", 0.9}});
    CHECK(l1(shot, "density", [&](double x) { return exact.at(x, 0.6).density; }) < 0.05);
}

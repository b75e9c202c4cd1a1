// Bars whose fields are reconstructed on their way to the grid: what a run keeps, and that the grid follows.
#include <string>

#include "oracles/bars/bar_vibration.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

const Law law = NominalLaw{{.lambda = 0, .mu = 0.5}};

Given with(const std::string& kind, bool conservative) {
    Given options{{"reconstruction", kind}, {"beyond_grid", "follow"}, {"conservative", conservative}};
    if (kind == "impm") options.insert({"stress_update", "usl"});
    return options;
}

}  // namespace

TEST_CASE("reconstruction: a conservative run keeps the balance of momentum to round-off", "[property]") {
    const auto kind = GENERATE(as<std::string>{}, "cubic_spline", "tls", "mls", "impm");
    const auto transfer = GENERATE(as<std::string>{}, "flip", "blend", "pic");
    INFO(kind << ", " << transfer);
    auto scene = fixed_free_bar(1, 1, 0.1, law);
    scene.body_force = pointwise<1>([](const Vec<1>& X, double t) { return Vec<1>(0.1 * X[0] + 0.1 * t); });
    scene.damping = 0.2;
    const auto drift = [&](bool conservative) {
        auto options = with(kind, conservative);
        options.insert({"transfer", transfer});
        const auto bar = started(scene, options, {{"cells", 8.0}, {"ppc", 3.0}, {"dt", 0.02}});
        bar->advance_to(1, never);
        return figure(bar->drift(), "momentum");
    };
    CHECK(drift(true) < 1e-13);  // 50 steps of sums over 24 particles
    CHECK(drift(false) > 1e-9);  // there is something to put right
}

TEST_CASE("reconstruction: a grid that follows ends where the body ends, in equal cells", "[unit]") {
    const auto kind = GENERATE(as<std::string>{}, "none", "mls", "tls");
    const auto scene = fixed_free_bar(1, 1, 0.3, law);
    Mpm<1> bar(scene, options_of({{"reconstruction", kind}, {"beyond_grid", "follow"}}),
               {.cells = 8, .ppc = 2, .h = 0.125, .dt = 0.01}, false);
    for (int k = 0; k < 80; ++k) bar.step(0.01 * k, 0.01, 0.01);
    const double end = bar.grid().lower[0] + bar.grid().h * bar.grid().cells[0];
    CHECK(bar.grid().cells[0] == 8);
    CHECK(bar.grid().lower[0] == 0);
    // u(L, t) = 0.3 / omega sin(omega t), omega = pi / 2: within 2 per cent on eight cells.
    const oracles::BarVibration exact{.L = 1, .E = 1, .rho = 1, .v0 = 0.3, .mode = 1};
    CHECK(end == Approx(1 + exact.displacement(1, 0.79)).epsilon(0.02));  // of the last step's start
    CHECK(end > 1.15);
    const auto& p = bar.particles();
    CHECK(p.x.back()[0] < end + 0.01);
    CHECK(p.x.back()[0] > end - 0.6 * bar.grid().h);  // a quarter of a cell inside at the start
}

TEST_CASE("reconstruction: a rigid flight stays exact across cells", "[property]") {
    const auto kind = GENERATE(as<std::string>{}, "cubic_spline", "tls", "mls", "impm");
    INFO(kind);
    const auto scene = box<1>(Vec<1>(1), Face::free, uniform<1>(Vec<1>(0.7)));
    const auto bar = started(scene, with(kind, false), {{"cells", 5.0}, {"ppc", 3.0}, {"dt", 0.0197}});
    const double t = 20 * 0.0197;
    bar->advance_to(t, never);
    const Snapshot shot = bar->snapshot();
    for (std::size_t p = 0; p < shot.points(); ++p) {
        CHECK(shot.field("displacement").values[p] == Approx(0.7 * t).epsilon(1e-11));
        CHECK(shot.field("velocity").values[p] == Approx(0.7).epsilon(1e-11));
        CHECK(std::abs(shot.field("stress").values[p]) < 1e-11);
    }
    CHECK(figure(bar->work(), "cell_crossings") == 0);  // the grid flies along
}

TEST_CASE("reconstruction: too few particles end the run with Diverged", "[alarm]") {
    CHECK_THROWS_AS(started(fixed_free_bar(1, 1, 0.1, law), {{"reconstruction", "mls"}, {"beyond_grid", "follow"}},
                            {{"cells", 1.0}, {"ppc", 2.0}, {"dt", 0.01}})
                        ->advance_to(0.01, never),
                    Diverged);
}

TEST_CASE("reconstruction: a free face without a grid that follows it is refused", "[alarm]") {
    // Its cell would be cut, and the load on the cut would reach no particle.
    CHECK_THROWS_WITH(started(fixed_free_bar(1, 1, 0.1, law), {{"reconstruction", "mls"}},
                              {{"cells", 4.0}, {"ppc", 3.0}, {"dt", 0.01}}),
                      ContainsSubstring("choose beyond_grid 'follow'"));
}

// Mass and momentum, by the simulation's own drift figures and by a balance that is drawn up here.
#include <string>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

/// A bar that shortens and lengthens by a fifth: particles cross many cells.
SolidScene<1> lively_bar() { return fixed_free_bar(1, 1, 0.3, NominalLaw{{.lambda = 0, .mu = 0.5}}); }

/// Pull of the wall on the bar [N]: the stress of the first cell, whose gradient at the wall is -1/h.
double pull_of_wall(const Particles<1>& p, const std::vector<Vec<1>>& x, double h) {
    double pull = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (x[i][0] < h) pull -= p.volume[i] * p.sigma[i](0, 0) / h;
    }
    return pull;
}

}  // namespace

TEST_CASE("conservation: a fixed-free bar keeps its mass, and its momentum changes by the wall's impulse",
          "[property]") {
    // Where the stress stands still between the passes that the wall's pull is read at: not usavg.
    const auto stress_update = GENERATE(as<std::string>{}, "usf", "usl", "musl");
    INFO(stress_update);
    const double h = 1.0 / 16;
    const double dt = 0.01;
    Mpm<1> bar(lively_bar(), options_of({{"stress_update", stress_update}, {"margin", 1.0}}),
               {.cells = 16, .ppc = 2, .h = h, .dt = dt}, false);
    const double start = momentum(bar.particles())[0];
    double impulse = 0;
    for (int k = 0; k < 200; ++k) {
        const auto x = bar.particles().x;
        const bool stress_first = stress_update == "usf";
        if (!stress_first) impulse += dt * pull_of_wall(bar.particles(), x, h);
        bar.step(k * dt, dt, dt);
        if (stress_first) impulse += dt * pull_of_wall(bar.particles(), x, h);
    }
    double mass_on_grid = 0;
    for (const double m : bar.grid().m) mass_on_grid += m;
    CHECK(bar.crossings() > 50);
    CHECK(std::abs(impulse) > 0.1 * start);  // the wall has turned a good part of the momentum
    // 200 steps of sums over 32 particles, each rounded to an ulp of the largest momentum.
    CHECK(momentum(bar.particles())[0] - start == Approx(impulse).epsilon(1e-12));
    CHECK(bar.impulse()[0] == Approx(impulse).epsilon(1e-12));
    CHECK(mass_on_grid == Approx(1).epsilon(1e-14));
}

TEST_CASE("conservation: the bar's drift figures are round-off", "[property]") {
    const auto scheme = GENERATE(from_range(time_schemes));
    INFO(scheme.name());
    const auto bar =
        started(lively_bar(), {{"stress_update", scheme.stress_update}, {"time", scheme.time}, {"margin", 1.0}},
                {{"cells", 16.0}, {"ppc", 2.0}, {"dt", 0.01}});
    CHECK(figure(bar->drift(), "mass") == 0);
    CHECK(figure(bar->drift(), "momentum") == 0);
    bar->advance_to(2, never);
    CHECK(figure(bar->work(), "steps") == 200);
    CHECK(figure(bar->work(), "particle_steps") == 200 * 32);
    CHECK(figure(bar->work(), "cell_crossings") > 50);
    CHECK(figure(bar->drift(), "mass") < 1e-14);
    CHECK(figure(bar->drift(), "momentum") < 1e-13);
}

TEST_CASE("conservation: a free body under a body force gains exactly the force's impulse", "[property]") {
    const auto stress_update = GENERATE(from_range(stress_updates));
    INFO(stress_update);
    const auto spin = [](const Vec<2>& X, double) { return Vec<2>(0.2 - X[1], 0.3 * X[0] * X[1]); };
    const auto load = [](const Vec<2>& X, double t) { return Vec<2>(0.3 * X[1] + t, -1 + 0.2 * X[0]); };
    auto scene = box<2>({1.0, 0.75}, Face::free, pointwise<2>(spin));
    scene.body_force = pointwise<2>(load);
    const double dt = 0.02;
    Mpm<2> body(scene, options_of({{"stress_update", stress_update}, {"margin", 1.0}}),
                {.cells = 4, .ppc = 2, .h = 0.25, .dt = dt}, false);
    const auto& p = body.particles();
    const Vec<2> start = momentum(p);
    Vec<2> impulse = Vec<2>::Zero();
    for (int k = 0; k < 50; ++k) {
        for (std::size_t i = 0; i < p.size(); ++i) impulse += dt * p.m[i] * load(p.X[i], k * dt);
        body.step(k * dt, dt, dt);
    }
    CHECK(body.crossings() > 20);
    CHECK((momentum(p) - start - impulse).norm() < 1e-13);
    CHECK((body.impulse() - impulse).norm() < 1e-13);

    const auto run =
        started(scene, {{"stress_update", stress_update}, {"margin", 1.0}}, {{"cells", 4.0}, {"ppc", 2.0}, {"dt", dt}});
    run->advance_to(50 * dt, never);
    CHECK(figure(run->drift(), "mass") < 1e-14);
    CHECK(figure(run->drift(), "momentum") < 1e-13);
}

TEST_CASE("conservation: volume follows the strain increments, or stays", "[property]") {
    const auto volume = GENERATE(as<std::string>{}, "updated", "fixed");
    const auto bar =
        started(lively_bar(), {{"volume", volume}, {"margin", 1.0}}, {{"cells", 16.0}, {"ppc", 2.0}, {"dt", 0.01}});
    bar->advance_to(1, never);
    const Snapshot shot = bar->snapshot();
    for (std::size_t i = 0; i < shot.points(); ++i) {
        // In 1D the product of 1 + d eps is F itself.
        const double F = 1 + shot.field("strain").values[i];
        CHECK(shot.weights[i] * 32 == Approx(volume == "updated" ? F : 1.0).epsilon(1e-12));
    }
    CHECK(std::abs(shot.field("strain").values[0]) > 0.1);
}

TEST_CASE("conservation: in the plane the volume follows the determinant of the increment", "[property]") {
    Tensor<2> A;
    A << 0.31, -0.52, 0.23, 0.74;
    const double dt = 0.1;
    const auto scene =
        box<2>({1.4, 1.4}, Face::free, pointwise<2>([A](const Vec<2>& X, double) { return Vec<2>(A * X); }));
    const auto body = started(scene, {{"stress_update", "usl"}}, {{"cells", 7.0}, {"ppc", 2.0}, {"dt", dt}});
    body->advance_to(dt, never);
    const Snapshot shot = body->snapshot();
    const double expected = 0.01 * (Tensor<2>::Identity() + dt * A).determinant();
    int inside = 0;
    for (std::size_t p = 0; p < shot.points(); ++p) {
        const Vec<2> X = vector_at<2>(shot.X, p);
        // One cell inside, no node lacks particles: there the first step's gradient is A.
        if (((X - scene.lower).array() < 0.2).any() || ((scene.upper - X).array() < 0.2).any()) continue;
        CHECK(shot.weights[p] == Approx(expected).epsilon(1e-13));
        ++inside;
    }
    CHECK(inside == 100);
}

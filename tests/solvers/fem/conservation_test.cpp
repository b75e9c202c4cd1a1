// Mass and momentum, by the simulation's own drift figures and by a balance that is drawn up here.
#include "tests/catch.hpp"
#include "tests/solvers/fem/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::fem;
using namespace ordo::solvers::fem::test;

namespace {

constexpr int cells = 16;
constexpr double h = 1.0 / cells;
constexpr double dt = 0.01;

double load(double X, double t) { return 0.3 * X - 0.5 + t; }

/// A bar that is pulled by everything there is, in strains of some tenths.
SolidScene<1> busy_bar() {
    auto scene = fixed_free_bar(1, 1.2, NeoHookeanLaw{{.lambda = 0.3, .mu = 0.5}});
    scene.velocity = field([](double X, double) { return 0.2 * X; });
    scene.body_force = field(load);
    scene.traction = field([](double, double t) { return 0.1 * std::cos(t); });
    scene.damping = 0.7;
    return scene;
}

}  // namespace

TEST_CASE("fem conservation: momentum changes by the impulse of wall, traction, body force and damping", "[property]") {
    // Lumped, and the wall at rest: it takes up the stress of the first element and the first node's body force.
    const auto scene = busy_bar();
    Bar bar(scene, {.lumped = true, .leapfrog = false, .body_force_lumped = true}, {.cells = cells, .h = h, .dt = dt});
    const double start = bar.momentum();
    double impulse = 0;
    double wall = 0;
    for (int k = 0; k < 200; ++k) {
        const double t = k * dt;
        const double before = bar.momentum();
        wall -= dt * (bar.P()[0] + bar.m()[0] * load(0, t));
        for (int i = 0; i <= cells; ++i) impulse += dt * bar.m()[i] * load(i * h, t);
        impulse += dt * 0.1 * std::cos(t);
        bar.step({.t = t, .dt = dt, .kick = dt, .velocity_time = t + dt});
        impulse -= dt * 0.7 * 0.5 * (before + bar.momentum());
    }
    CHECK(std::abs(wall) > 0.1);
    // 200 steps of sums over 17 nodes, each rounded to an ulp of 1.
    CHECK(std::abs(bar.momentum() - start - impulse - wall) < 1e-13);
    CHECK(std::abs(bar.impulse() - impulse - wall) < 1e-13);
}

TEST_CASE("fem conservation: drift figures are round-off, whatever holds and pulls", "[property]") {
    const auto mass = GENERATE(from_range(masses));
    const auto time = GENERATE(from_range(times));
    const auto body_force = GENERATE(from_range(body_forces));
    const auto lower = GENERATE(Face::free, Face::fixed);
    const auto upper = GENERATE(Face::free, Face::roller);
    auto scene = busy_bar();
    scene.faces = {{{lower, upper}}};
    scene.face_velocity = field([](double X, double t) { return 0.2 * X * std::cos(t) + 0.1 * t; });
    const auto bar = started(scene, {{"mass", mass}, {"time", time}, {"body_force", body_force}},
                             {{"cells", double(cells)}, {"dt", dt}});
    CHECK(figure(bar->drift(), "mass") < 1e-14);
    CHECK(figure(bar->drift(), "momentum") == 0);
    bar->advance_to(0.5, never);
    bar->advance_to(1.003, never);
    CHECK(figure(bar->drift(), "mass") < 1e-14);
    CHECK(figure(bar->drift(), "momentum") < 1e-13);
}

TEST_CASE("fem conservation: the balance rings for a wall that is left out", "[alarm]") {
    const auto scene = busy_bar();
    Bar bar(scene, {.lumped = false, .leapfrog = false}, {.cells = cells, .h = h, .dt = dt});
    const double start = bar.momentum();
    double loads = 0;
    for (int k = 0; k < 200; ++k) {
        const double before = bar.momentum();
        bar.step({.t = k * dt, .dt = dt, .kick = dt, .velocity_time = (k + 1) * dt});
        // int rho b dX = rho (0.15 - 0.5 + t)
        loads += dt * (1.2 * (-0.35 + k * dt) + 0.1 * std::cos(k * dt) - 0.35 * (before + bar.momentum()));
    }
    CHECK(std::abs(bar.momentum() - start - loads) > 0.1);
    CHECK(std::abs(bar.momentum() - start - bar.impulse()) < 1e-13);
}

// What a step does not touch would not have changed: all bits are those of a bar that touches every node.
#include <algorithm>

#include "tests/catch.hpp"
#include "tests/solvers/fem/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::fem;
using namespace ordo::solvers::fem::test;

namespace {

struct Load {
    std::string name;
    SolidScene<1> scene;
    std::size_t most;  ///< nodes that it moves at once, of 401
};

/// Bars of length 1 that are at rest but for one place.
std::vector<Load> loads(const Law& law) {
    const auto bump = [](double X) { return std::abs(X - 0.4) < 0.05 ? std::cos(10 * M_PI * (X - 0.4)) : 0.0; };
    const auto bar = fixed_free_bar(1, 2, law);
    auto pulled = bar;
    pulled.traction = field([](double X, double t) { return X > 0.5 ? 0.02 + 0.1 * t : 0.0; });
    auto pushed = bar;
    pushed.face_velocity = field([](double X, double t) { return X < 0.5 ? 0.1 * std::sin(3 * t) : 0.0; });
    auto thrown = bar;
    thrown.velocity = field([=](double X, double) { return 0.3 * bump(X); });
    auto stretched = bar;
    stretched.deformed = deformed([=](double X, double) { return 0.002 * bump(X); });
    auto damped = thrown;
    damped.damping = 3;
    auto flying = free_bar(1, 2, law);
    flying.velocity = field([](double X, double) { return X > 0.2 ? 0.1 : 0.0; });
    return {{"pulled", pulled, 4},        {"pushed", pushed, 4},  {"thrown", thrown, 50},
            {"stretched", stretched, 50}, {"damped", damped, 50}, {"a part of it flying", flying, 220}};
}

Resolution resolution() { return {.cells = 400, .h = 1.0 / 400, .dt = 0.5 / 400}; }

Step step_of(int k, double dt) {
    return {.t = k * dt, .dt = dt, .kick = k == 0 ? dt / 2 : dt, .velocity_time = (k + 0.5) * dt};
}

bool same(const Bar& a, const Bar& b) {
    return std::ranges::equal(a.u(), b.u()) && std::ranges::equal(a.v(), b.v()) && std::ranges::equal(a.F(), b.F()) &&
           std::ranges::equal(a.P(), b.P()) && a.impulse() == b.impulse() && a.momentum() == b.momentum();
}

}  // namespace

TEST_CASE("fem: skipping quiet nodes leaves every bit as it is", "[property]") {
    const Moduli C{.lambda = 0, .mu = 1};  // waves at 1 m/s
    const auto law = GENERATE_COPY(Law(NominalLaw{C}), Law(LogarithmicLaw{C}), Law(NeoHookeanLaw{C}), Law(HenckyLaw{C}),
                                   Law(J2Law{.C = C, .yield = 0.05, .hardening = 0.3}));
    for (const Load& load : loads(law)) {
        INFO(load.name << ", law " << law.index());
        Bar skipping(load.scene, {}, resolution());
        Bar all(load.scene, {.skip_quiet = false}, resolution());
        CHECK(all.active() == 401);
        CHECK(skipping.active() <= load.most);
        int k = 0;
        for (bool equal = true; equal && k < 900; ++k) {  // waves reach the ends and return
            skipping.step(step_of(k, resolution().dt));
            all.step(step_of(k, resolution().dt));
            equal = same(skipping, all);
        }
        CHECK(k == 900);
        CHECK(same(skipping, all));
        CHECK(skipping.active() == 401);
    }
}

TEST_CASE("fem: nothing runs far ahead of a front", "[property]") {
    auto scene = fixed_free_bar(1, 2, linear_law(2));
    scene.traction = field([](double X, double) { return X > 0.5 ? 0.01 : 0.0; });
    const Resolution fine{.cells = 20'000, .h = 1.0 / 20'000, .dt = 0.5 / 20'000};
    Bar bar(scene, {}, fine);
    for (int k = 0; k < 2000; ++k) bar.step(step_of(k, fine.dt));
    CHECK(bar.active() > 1000);  // the front has run 1000 elements; at an element a step it were 2000
    CHECK(bar.active() < 1100);
}

TEST_CASE("fem: a body force and a consistent mass move all nodes", "[unit]") {
    const auto scene = fixed_free_bar(1, 2, linear_law(2));
    CHECK(Bar(scene, {}, resolution()).active() == 2);
    CHECK(Bar(scene, {.lumped = false}, resolution()).active() == 401);
    auto heavy = scene;
    heavy.body_force = field(nowhere);
    CHECK(Bar(heavy, {}, resolution()).active() == 401);
}

TEST_CASE("fem: the report says what was skipped", "[unit]") {
    const auto run = started(fixed_free_bar(1, 2, linear_law(2)), {}, {{"cells", 99.0}, {"courant", 0.5}});
    CHECK(run->skipped().empty());
    run->advance_to(1, never);
    CHECK(run->skipped().at(0).share == Approx(0.98));
}

// The door of the solver: what it takes, what a run answers, and how it ends when it cannot go on.
#include <limits>
#include <numeric>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/fem/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::fem;
using namespace ordo::solvers::fem::test;

namespace {

const Given four_cells{{"cells", 4.0}, {"dt", 0.05}};

/// Length 1, wave speed 1, started by a velocity that grows with X.
SolidScene<1> swinging_bar() {
    auto scene = fixed_free_bar(1, 1, linear_law(1));
    scene.velocity = field([](double X, double) { return 0.1 * X; });
    return scene;
}

}  // namespace

TEST_CASE("fem: it takes bars, and no other kind of scene", "[unit]") {
    const Solver fem = solver();
    CHECK(fem.accepts(SolidScene<1>{}));
    CHECK_FALSE(fem.accepts(SolidScene<2>{}));
    CHECK_FALSE(fem.accepts(SolidScene<3>{}));
    CHECK_FALSE(fem.accepts(ScalarEquation{}));
}

TEST_CASE("fem: exactly one of dt and courant", "[unit]") {
    const auto scene = fixed_free_bar(2, 4, linear_law(100));
    const auto resolution = [&](const Given& given) {
        return resolution_from(scene, resolve(resolution_parameters(), given, "", "solver fem"));
    };
    CHECK(resolution({{"cells", 8.0}, {"dt", 0.01}}).dt == 0.01);
    // sqrt(100 / 4) = 5 m/s and h = 1/4 m.
    CHECK(resolution({{"cells", 8.0}, {"courant", 0.5}}).dt == Approx(0.5 * 0.25 / 5));
    const std::string rule = "solver fem takes exactly one of 'dt' and 'courant'";
    CHECK_THROWS_WITH(resolution({{"cells", 8.0}}), rule);
    CHECK_THROWS_WITH(resolution({{"cells", 8.0}, {"dt", 0.01}, {"courant", 0.5}}), rule);
}

TEST_CASE("fem: what is no valid choice is refused by name", "[unit]") {
    const auto scene = swinging_bar();
    CHECK_THROWS_AS(started(scene, {}, {{"dt", 0.1}}), InputError);
    CHECK_THROWS_AS(started(scene, {}, {{"cells", 0.0}, {"dt", 0.1}}), InputError);
    CHECK_THROWS_AS(started(scene, {}, {{"cells", 2.5}, {"dt", 0.1}}), InputError);
    CHECK_THROWS_AS(started(scene, {}, {{"cells", 4.0}, {"dt", 0.0}}), InputError);
    CHECK_THROWS_AS(started(scene, {}, {{"cells", 4.0}, {"courant", -1.0}}), InputError);
    CHECK_THROWS_WITH(started(scene, {}, {{"cells", 4.0}, {"dt", 0.1}, {"ppc", 2.0}}), ContainsSubstring("ppc"));
    CHECK_THROWS_WITH(started(scene, {{"mass", std::string("lumpd")}}, four_cells), ContainsSubstring("lumped"));
    CHECK_THROWS_WITH(started(scene, {{"stress_update", std::string("usl")}}, four_cells),
                      ContainsSubstring("stress_update"));
}

TEST_CASE("fem: a plan and a claim say what a run will do", "[unit]") {
    const Solver fem = solver();
    const auto sampled_at = GENERATE(from_range(samplings));
    const auto options = resolve(fem.options, {{"sampled_at", sampled_at}}, "", "fem");
    const auto resolution = resolve(fem.resolution, four_cells, "", "fem");
    const Plan plan = fem.plan(swinging_bar(), options, resolution);
    CHECK((plan.h == 0.25 && plan.dt == 0.05));
    const auto bar = fem.start(swinging_bar(), options, resolution, fem.fields);
    CHECK(plan.points == static_cast<double>(bar->snapshot().points()));
    CHECK(fem.claim(options).order_in_space == 2);
    CHECK(fem.claim(options).conserves == std::vector<std::string>{"mass", "momentum"});
}

TEST_CASE("fem: a run ends exactly at the time asked for, in equal steps", "[unit]") {
    const auto bar = started(swinging_bar(), {}, {{"cells", 4.0}, {"dt", 0.15}});
    bar->advance_to(0.5, never);
    CHECK(bar->snapshot().t == 0.5);
    CHECK(figure(bar->work(), "steps") == 4);
    bar->advance_to(0.5, never);  // already there
    CHECK(figure(bar->work(), "steps") == 4);
    bar->advance_to(0.6, never);
    CHECK(bar->snapshot().t == 0.6);
    CHECK(figure(bar->work(), "steps") == 5);
    CHECK(figure(bar->work(), "element_steps") == 20);
}

TEST_CASE("fem: a run in two legs of whole steps is the run in one", "[unit]") {
    const auto mass = GENERATE(from_range(masses));
    const auto time = GENERATE(from_range(times));
    const auto at_end = [&](const std::vector<double>& stops) {
        const auto bar = started(swinging_bar(), {{"mass", mass}, {"time", time}}, {{"cells", 4.0}, {"dt", 0.0625}});
        for (const double t : stops) {
            bar->advance_to(t, never);
            bar->snapshot();  // looking changes nothing
        }
        return bar->snapshot().field("displacement").values;
    };
    CHECK(at_end({1}) == at_end({0.25, 0.5, 1}));
}

TEST_CASE("fem: a snapshot holds the fields that were asked for, and only those", "[unit]") {
    const Solver fem = solver();
    const std::vector<std::string> asked{"stress"};
    const auto bar = fem.start(swinging_bar(), resolve(fem.options, {}, "", "fem"),
                               resolve(fem.resolution, four_cells, "", "fem"), asked);
    const Snapshot shot = bar->snapshot();
    CHECK(shot.fields.size() == 1);
    CHECK((shot.field("stress").components == 1 && shot.field("stress").values.size() == 5));
    CHECK((shot.points() == 5 && shot.X.size() == 5 && shot.x.size() == 5 && shot.dim == 1));
}

TEST_CASE("fem: nodes and centres are two views of one run", "[unit]") {
    auto scene = swinging_bar();
    scene.lower = Vec<1>(-0.5);
    scene.upper = Vec<1>(0.5);
    const auto shot = [&](const std::string& sampled_at) {
        const auto bar = started(scene, {{"sampled_at", sampled_at}}, four_cells);
        bar->advance_to(0.5, never);
        return bar->snapshot();
    };
    const Snapshot nodes = shot("nodes");
    const Snapshot centres = shot("centres");
    CHECK(nodes.X == std::vector{-0.5, -0.25, 0.0, 0.25, 0.5});
    CHECK(centres.X == std::vector{-0.375, -0.125, 0.125, 0.375});
    CHECK(nodes.weights_undeformed == std::vector{0.125, 0.25, 0.25, 0.25, 0.125});
    CHECK(centres.weights_undeformed == std::vector(4, 0.25));
    const auto& u = nodes.field("displacement").values;
    const auto& stress = centres.field("stress").values;
    CHECK(centres.weights[1] == Approx(0.25 + u[2] - u[1]).epsilon(1e-14));  // now: the elements' lengths
    CHECK(nodes.weights[0] == Approx(0.5 * (0.25 + u[1] - u[0])).epsilon(1e-14));
    for (std::size_t e = 0; e < 4; ++e) {
        CHECK(centres.field("displacement").values[e] == Approx((u[e] + u[e + 1]) / 2).epsilon(1e-15));
        CHECK(centres.x[e] == centres.X[e] + centres.field("displacement").values[e]);
        CHECK(centres.field("strain").values[e] == Approx((u[e + 1] - u[e]) / 0.25).epsilon(1e-13));
        CHECK(stress[e] == Approx(centres.field("strain").values[e]).epsilon(1e-13));  // E = 1
    }
    CHECK(nodes.field("stress").values.front() == stress.front());
    CHECK(nodes.field("stress").values[2] == Approx((stress[1] + stress[2]) / 2).epsilon(1e-15));
    CHECK(nodes.field("stress").values.back() == stress.back());
    CHECK(stress[0] != stress[3]);
}

TEST_CASE("fem: a scene without initial velocity is at rest, and loads are asked for where and when they act",
          "[unit]") {
    std::vector<double> when;
    auto scene = fixed_free_bar(1, 1, linear_law(1));
    scene.velocity = {};
    scene.body_force = [&](std::span<const Vec<1>> X, double t, std::span<Vec<1>> out) {
        when.push_back(t);
        CHECK(X.size() == 3);
        CHECK((X[0][0] == 0 && X[1][0] == 0.5 && X[2][0] == 1));
        std::fill(out.begin(), out.end(), Vec<1>(0));
    };
    const auto bar = started(scene, {{"body_force", std::string("lumped")}}, {{"cells", 2.0}, {"dt", 0.25}});
    bar->advance_to(1, never);
    CHECK(when == std::vector{0.0, 0.25, 0.5, 0.75});
    CHECK(Errors(bar->snapshot(), "displacement", nowhere).most == 0);
}

TEST_CASE("fem: held ends have their faces' velocity from the start, and take no traction", "[unit]") {
    const auto mass = GENERATE(from_range(masses));
    auto scene = free_bar(1, 1, linear_law(1));
    scene.faces = {{{Face::fixed, Face::roller}}};
    scene.velocity = field([](double, double) { return 0.5; });
    scene.traction = field([](double, double) { return std::nan(""); });
    const auto bar = started(scene, {{"mass", mass}}, {{"cells", 2.0}, {"dt", 0.05}});
    CHECK(bar->snapshot().field("velocity").values == std::vector{0.0, 0.5, 0.0});
    bar->advance_to(0.05, never);
    CHECK(figure(bar->drift(), "momentum") < 1e-15);
}

TEST_CASE("fem: a run stops when it is told to", "[unit]") {
    const auto bar = started(swinging_bar(), {}, four_cells);
    int asked = 0;
    CHECK_THROWS_AS(bar->advance_to(1, [&] { return ++asked > 3; }), Interrupted);
    CHECK(figure(bar->work(), "steps") == 3);
}

TEST_CASE("fem: an element that is turned inside out ends the run, from the start or on the way", "[alarm]") {
    auto folded = swinging_bar();
    folded.deformed = deformed([](double X, double) { return X < 0.5 ? 0 : -0.25; });
    CHECK_THROWS_WITH(started(folded, {}, four_cells), ContainsSubstring("element 1"));
    CHECK_THROWS_AS(started(folded, {}, four_cells), Diverged);
    auto thrown = swinging_bar();
    thrown.velocity = field([](double X, double) { return -8 * X; });
    const auto bar = started(thrown, {}, four_cells);
    CHECK_THROWS_AS(bar->advance_to(1, never), Diverged);
    CHECK(figure(bar->work(), "steps") < 4);
}

TEST_CASE("fem: a velocity that is no number, or infinite, ends the run with Diverged", "[alarm]") {
    const double inf = std::numeric_limits<double>::infinity();
    const auto mass = GENERATE(from_range(masses));
    for (const double bad : {std::nan(""), inf, -inf}) {
        for (const double from : {-1.0, 0.5, 0.9}) {  // everywhere, in half of the bar, at its last node
            INFO(mass << ", " << bad);
            auto scene = free_bar(1, 1, linear_law(1));
            scene.velocity = field([=](double X, double) { return X + 0.3 > from ? bad : 0; });
            CHECK_THROWS_AS(started(scene, {{"mass", mass}}, four_cells)->advance_to(0.05, never),
                            Diverged);  // one step
        }
    }
}

TEST_CASE("fem: a load that is no number ends the run with Diverged", "[alarm]") {
    auto scene = swinging_bar();
    scene.traction = field([](double, double t) { return t > 0.3 ? std::nan("") : 0; });
    const auto bar = started(scene, {}, four_cells);
    CHECK_THROWS_AS(bar->advance_to(1, never), Diverged);
    CHECK(figure(bar->work(), "steps") > 5);
}

// What a step does not touch would not have changed: all bits are those of a run that touches everything.
#include "solvers/godunov/active.hpp"

#include <algorithm>

#include "tests/solvers/godunov/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::godunov;
using namespace ordo::solvers::godunov::test;

namespace {

using Kind = LineEnd::Kind;

struct Line {
    std::string name;
    LineScene scene;
    double t;  ///< by then waves have reached an end, or crossed it
};

/// Waves that start away from the ends in lines that are quiet elsewhere, with every kind of end.
std::vector<Line> lines() {
    const IdealGas gas;
    const ElasticMedium<RubberEnergy> rubber{.k = 1};
    const LineEnd wall{.kind = Kind::wall};
    const LineEnd ring{.kind = Kind::periodic};
    const LineEnd held{.kind = Kind::prescribed, .outside = gas.contents(1.2, 0, 1.5)};
    const Contents cold = gas.contents(1, 0, 1);
    const Contents moving = gas.contents(1, 0.7, 1);
    return {
        {"Sod's tube", sod.scene(), 4},
        {"Sod's tube, moving", sod.scene(0, -0.3), 4},
        {"Toro's fourth", toro_4.scene(), 0.2},
        {"a blast between walls", {gas, {0, 0.5, 0.6, 1}, {cold, gas.contents(1, 0, 100), cold}, {wall, wall}}, 0.2},
        {"a moving gas that meets a wall", {gas, {0, 1}, {moving}, {LineEnd{}, wall}}, 1},
        {"a prescribed end", {gas, {0, 1}, {cold}, {held, LineEnd{}}}, 1},
        {"contacts that run round a ring",
         {gas, {0, 0.6, 0.75, 1}, {moving, gas.contents(3, 0.7, 1), moving}, {ring, ring}},
         1},
        {"a blast on a ring", {gas, {0, 0.7, 0.8, 1}, {cold, gas.contents(1, 0, 4), cold}, {ring, ring}}, 0.3},
        {"two blasts", {gas, {0, 0.2, 0.25, 0.8, 0.85, 1}, {cold, gas.contents(2, 0, 9), cold, moving, cold}}, 0.3},
        {"rubber",
         {rubber, {-4, -1, 4}, {rubber.contents(0.5, 0, 1), rubber.contents(1, 0, 0.2)}, {wall, LineEnd{}}},
         3}};
}

/// A line that touches all cells beside one that skips the quiet ones.
struct Pair {
    Grid all, skipping;

    static Options off(Options options) {
        options.skip_quiet = false;
        return options;
    }
    Pair(const LineScene& scene, const Options& options, const Resolution& resolution)
        : all(scene, off(options), resolution), skipping(scene, options, resolution) {}

    bool same() {
        const auto a = all.balance();
        const auto b = skipping.balance();
        bool equal = a.held == b.held && a.passed == b.passed && a.passed_size == b.passed_size;
        for (std::size_t i = 0; i < all.size(); ++i) equal &= all.mean(i) == skipping.mean(i);
        return equal;
    }
};

}  // namespace

TEST_CASE("godunov: skipping quiet cells leaves every bit as it is", "[property]") {
    const auto line = GENERATE(from_range(lines()));
    const auto order = GENERATE(std::string("first"), std::string("second"));
    const auto flux = GENERATE(std::string("hll"), std::string("hllc"));
    const auto limiter = GENERATE(std::string("mc"), std::string("superbee"), std::string("central"));
    INFO(line.name << ", " << order << ", " << flux << ", " << limiter);
    const Options options = options_from(
        line.scene.medium,
        resolve(option_parameters(), {{"order", order}, {"flux", flux}, {"limiter", limiter}}, "", "solver godunov"));
    const Resolution resolution = resolution_from(line.scene, Values({{"cells", 203.0}, {"courant", 0.45}}));
    Pair pair(line.scene, options, resolution);
    CHECK(pair.all.active() == 203);
    CHECK(pair.skipping.active() < 60);
    bool same = true;
    for (double t = 0; t < line.t && same;) {
        const double speed = pair.all.fastest(t);
        same = pair.skipping.fastest(t) == speed;
        const double dt = resolution.courant * resolution.h / speed;
        pair.all.step(dt);
        pair.skipping.step(dt);
        same = same && pair.same();
        t += dt;
    }
    CHECK(same);
}

TEST_CASE("godunov: a uniform gas is touched nowhere, at any velocity", "[property]") {
    const IdealGas gas;
    const LineScene scene{gas, {0, 1}, {gas.contents(1.3, 0.7, 0.9)}};
    const auto run = started(scene, {}, {{"cells", 1000.0}});
    run->advance_to(1, never);
    REQUIRE(run->skipped().size() == 1);
    CHECK(run->skipped()[0].share == 1);
    CHECK(std::ranges::all_of(run->snapshot().field("density").values, [](double rho) { return rho == 1.3; }));
    CHECK(figure(run->drift(), "mass") < 1e-14);
}

TEST_CASE("godunov: most of a wide tube is skipped, and the report says so", "[property]") {
    auto scene = sod.scene();
    scene.edges = {-50, 0, 50};
    const auto run = started(scene, {}, {{"cells", 2000.0}});
    CHECK(run->skipped().empty());
    run->advance_to(2, never);  // waves span 2 (1.18 + 1.75) of 100 at the end, half of that on average
    CHECK(run->skipped().at(0).share > 0.95);
    CHECK(run->skipped().at(0).share < 0.975);
}

TEST_CASE("godunov: stretches follow the places where neighbours differ", "[unit]") {
    Columns q(104);
    const Contents one{1, 0, 1};
    for (std::size_t i = 0; i < q.size(); ++i) q.set(i, one);
    Active active({2, 102}, 2, 2);
    REQUIRE(active.stretches().size() == 1);
    CHECK(active.stretches()[0] == Stretch{2, 102});
    active.find(q);
    REQUIRE(active.stretches().size() == 2);  // empty ones at both ends
    CHECK(total(active.stretches()) == 0);
    for (std::size_t i = 50; i < 52; ++i) q.set(i, {2, 0, 1});  // they differ at faces 50 and 52
    active.find(q);
    REQUIRE(active.stretches().size() == 3);
    CHECK(active.stretches()[1] == Stretch{48, 54});
    q.set(53, {2, 0, 1});
    active.follow(q);
    CHECK(active.stretches()[1] == Stretch{48, 56});
    for (std::size_t i = 50; i < 54; ++i) q.set(i, one);
    active.follow(q);
    CHECK(total(active.stretches()) == 0);
    q.set(0, {2, 0, 1});  // the outer ghosts, which the outer cells read
    q.set(103, {2, 0, 1});
    active.follow(q);
    CHECK(active.stretches()[0] == Stretch{2, 4});
    CHECK(active.stretches()[1] == Stretch{100, 102});
}

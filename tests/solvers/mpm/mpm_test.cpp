// The door of the solver: what a run answers, and how it ends when it cannot go on.
#include <algorithm>
#include <limits>
#include <string>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

const Given four_cells{{"cells", 4.0}, {"ppc", 2.0}, {"dt", 0.05}};

}  // namespace

TEST_CASE("mpm: a run ends exactly at the time asked for, in equal steps", "[unit]") {
    const auto bar = started(fixed_free_bar(1, 1, 0.01, NominalLaw{}), {}, {{"cells", 4.0}, {"dt", 0.3}});
    bar->advance_to(1, never);
    CHECK(bar->snapshot().t == 1);
    CHECK(bar->work()[0].value == 4);
    bar->advance_to(1, never);  // already there
    CHECK(bar->work()[0].value == 4);
    bar->advance_to(1.1, never);
    CHECK(bar->snapshot().t == 1.1);
    CHECK(bar->work()[0].value == 5);
}

TEST_CASE("mpm: a run in two legs of whole steps is the run in one", "[unit]") {
    const auto scheme = GENERATE(from_range(time_schemes));
    INFO(scheme.name());
    const auto at_end = [&](const std::vector<double>& stops) {
        const auto bar =
            started(fixed_free_bar(1, 1, 0.01, NominalLaw{}),
                    {{"stress_update", scheme.stress_update}, {"time", scheme.time}}, {{"cells", 4.0}, {"dt", 0.0625}});
        for (const double t : stops) {
            bar->advance_to(t, never);
            bar->snapshot();  // looking changes nothing
        }
        return bar->snapshot().field("displacement").values;
    };
    CHECK(at_end({1}) == at_end({0.25, 0.5, 1}));
}

TEST_CASE("mpm: a snapshot holds the fields that were asked for, and only those", "[unit]") {
    const Solver& mpm = solver_named("mpm", "");
    const std::vector<std::string> asked{"stress"};
    const auto bar = mpm.start(fixed_free_bar(1, 1, 0.01, NominalLaw{}), resolve(mpm.options, {}, "", "mpm"),
                               resolve(mpm.resolution, four_cells, "", "mpm"), asked);
    const Snapshot shot = bar->snapshot();
    CHECK(shot.fields.size() == 1);
    CHECK(shot.field("stress").components == 1);
    CHECK((shot.points() == 8 && shot.X.size() == 8 && shot.x.size() == 8 && shot.dim == 1));
}

TEST_CASE("mpm: only MUSL has a re-mapped velocity to move by, whatever its options say", "[unit]") {
    const auto stress_update = GENERATE(StressUpdate::usf, StressUpdate::usl);
    const auto moved = [&](bool by_remapped) {
        const Options options{.stress_update = stress_update, .moved_by_remapped = by_remapped};
        Mpm<1> bar(fixed_free_bar(1, 1, 0.01, NominalLaw{}), options, {.cells = 4, .ppc = 2, .h = 0.25, .dt = 0.05},
                   false);
        for (int k = 0; k < 10; ++k) bar.step(0.05 * k, 0.05, 0.05);
        return bar.particles().x;
    };
    CHECK(moved(true) == moved(false));
}

TEST_CASE("mpm: a run stops when it is told to", "[unit]") {
    const auto bar = started(fixed_free_bar(1, 1, 0.01, NominalLaw{}), {}, four_cells);
    int asked = 0;
    CHECK_THROWS_AS(bar->advance_to(1, [&] { return ++asked > 3; }), Interrupted);
    CHECK(bar->work()[0].value == 3);
}

TEST_CASE("mpm: a roller lets a body slide along it, a fixed face does not", "[property]") {
    const auto sliding = [](Face side) {
        auto scene = box<2>({1.0, 0.5}, Face::free, uniform<2>({0.7, 0}));
        scene.faces[1] = {side, side};
        const auto body = started(scene, {{"margin", 1.0}}, {{"cells", 4.0}, {"ppc", 2.0}, {"dt", 0.0197}});
        body->advance_to(20 * 0.0197, never);
        const Snapshot shot = body->snapshot();
        double worst = 0;
        for (const double v : shot.field("velocity").values)
            worst = std::max(worst, std::min(std::abs(v), std::abs(v - 0.7)));
        return worst;
    };
    CHECK(sliding(Face::roller) < 1e-13);  // every component is 0.7 or 0, to the round-off of 20 steps
    CHECK(sliding(Face::fixed) > 0.1);
}

TEST_CASE("mpm: a particle that leaves the grid ends the run with Diverged", "[alarm]") {
    const auto scene = box<2>({1.0, 1.0}, Face::free, uniform<2>({0.0, 3.0}));
    const auto body = started(scene, {}, four_cells);
    CHECK_THROWS_AS(body->advance_to(10, never), Diverged);
    CHECK(body->work()[0].value < 20);
    CHECK_THROWS_WITH(body->advance_to(20, never), ContainsSubstring("left the grid"));
}

TEST_CASE("mpm: a velocity that is no number, or infinite, ends the run with Diverged", "[alarm]") {
    const double inf = std::numeric_limits<double>::infinity();
    const auto scheme = GENERATE(from_range(time_schemes));
    const auto beyond_grid = GENERATE(as<std::string>{}, "extend", "extrapolate");
    for (const double bad : {std::nan(""), inf, -inf}) {
        INFO(scheme.name() << ", " << beyond_grid << ", " << bad);
        const auto scene =
            box<2>({1.0, 1.0}, Face::free,
                   pointwise<2>([bad](const Vec<2>& X, double) { return X[0] > 0.5 ? Vec<2>(0, bad) : Vec<2>(0, 0); }));
        const auto body = started(
            scene, {{"stress_update", scheme.stress_update}, {"time", scheme.time}, {"beyond_grid", beyond_grid}},
            four_cells);
        CHECK_THROWS_AS(body->advance_to(1, never), Diverged);
    }
}

TEST_CASE("mpm: a step far beyond the stability limit ends the run with Diverged", "[alarm]") {
    const auto scheme = GENERATE(from_range(time_schemes));
    INFO(scheme.name());
    const auto bar = started(fixed_free_bar(1, 1, 0.01, NominalLaw{}),
                             {{"stress_update", scheme.stress_update}, {"time", scheme.time}},
                             {{"cells", 16.0}, {"ppc", 2.0}, {"courant", 3.0}});
    CHECK_THROWS_AS(bar->advance_to(100, never), Diverged);
}

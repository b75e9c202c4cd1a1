// Faults that a scene or an option can seed: each must be told by name, or be seen in the errors.
#include "tests/solvers/rrm/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::rrm;
using namespace ordo::solvers::rrm::test;

TEST_CASE("rrm: edges that are too slow for a gas end as an unphysical state", "[alarm]") {
    // Own speeds do not bound the waves of unequal gases: too much leaves an interval that is too narrow.
    for (const std::string keep : {"nothing", "contacts"}) {
        const Given slow = toro[3].watching({{"keep", keep}, {"speeds", std::string("own")}});
        CHECK_THROWS_AS(at(toro[3].t, toro[3].scene, slow, 1e-3), Diverged);
        CHECK_THROWS_WITH(at(toro[3].t, toro[3].scene, slow, 1e-3), ContainsSubstring("no physical state"));
    }
}

TEST_CASE("rrm: more events than are allowed end a run", "[alarm]") {
    const Given few = sod.watching({{"keep", std::string("nothing")}, {"most_events", 100.0}});
    CHECK_THROWS_AS(at(sod.t, sod.scene, few, 1e-3), Diverged);
    CHECK_THROWS_WITH(at(sod.t, sod.scene, few, 1e-3), ContainsSubstring("more than 100 events"));
    CHECK_NOTHROW(at(1e-3, sod.scene, few, 1e-3));
}

TEST_CASE("rrm: a field that nobody watches is flattened without limit", "[alarm]") {
    // A contact of temperature alone is invisible to density, velocity and stress of linear elasticity.
    const Problem problem = linear_problem({1, 0, 0.2}, {1, 0, 1}, 1, 0.5);
    const auto error = [&](double allowed) {
        const Given options{{"keep", std::string("nothing")}, {"temperature_change", allowed}};
        return errors(at(problem.t, problem.scene, options, 1e-4), problem)[3];
    };
    CHECK(error(1e6) > 0.1);
    CHECK(error(1) < 0.1);
}

TEST_CASE("rrm: lines that make no sense are refused at the door", "[unit]") {
    const auto refused = [](const LineScene& scene, const std::string& why) {
        CHECK_THROWS_WITH(started(scene, {}, 1e-3), ContainsSubstring(why));
    };
    LineScene scene = sod.scene;
    scene.edges[1] = scene.edges[2];
    refused(scene, "rise");
    scene = sod.scene;
    scene.pieces[0].energy = 0;
    refused(scene, "positive density and speed of sound");
    scene = sod.scene;
    scene.ends[0].kind = LineEnd::Kind::prescribed;
    refused(scene, "prescribed");
    scene = sod.scene;
    scene.ends[1].kind = LineEnd::Kind::periodic;
    refused(scene, "periodic");
    CHECK_THROWS_WITH(started(sod.scene, {{"keep", std::string("wave")}}, 1e-3), ContainsSubstring("waves"));
    CHECK_THROWS_WITH(started(sod.scene, {}, 0), ContainsSubstring("delta"));
}

TEST_CASE("rrm: a run can be interrupted, and goes on bit by bit where it stood", "[unit]") {
    const Given options = sod.watching({{"keep", std::string("nothing")}});
    const auto run = started(sod.scene, options, 1e-3);
    CHECK_THROWS_AS(run->advance_to(1, [] { return true; }), Interrupted);
    for (const double t : {0.1, 0.7, 1.5}) run->advance_to(t, never);
    const auto in_steps = run->snapshot();
    const auto at_once = at(1.5, sod.scene, options, 1e-3);
    CHECK(in_steps.edges == at_once.edges);
    CHECK(in_steps.field("total_energy").values == at_once.field("total_energy").values);
}

// Nothing happens in a quiet line: what a run costs does not depend on how far it goes on.
#include "tests/solvers/rrm/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::rrm::test;

TEST_CASE("rrm: a line ten times as long has the same events", "[property]") {
    const auto keep = GENERATE(std::string("nothing"), std::string("contacts"));
    const Given options{{"keep", keep}, {"density_change", 1.0}, {"velocity_change", 1.0}, {"pressure_change", 1.0}};
    auto wide = sod.scene;
    wide.edges = {-50, 0, 50};
    const auto near = run_to(1.5, sod.scene, options, 1e-2);
    const auto far = run_to(1.5, wide, options, 1e-2);
    for (const std::string name : {"chop_outs", "unions", "cells_alive"})
        CHECK(figure(far->work(), name) == figure(near->work(), name));
    CHECK(figure(near->work(), "chop_outs") > 300);
    const auto a = near->snapshot();
    const auto b = far->snapshot();
    for (const std::string field : {"density", "velocity", "pressure"})
        CHECK(a.field(field).values == b.field(field).values);
    CHECK(a.x[1] == b.x[1]);
}

TEST_CASE("rrm: a uniform line has no event at any velocity", "[property]") {
    const IdealGas gas;
    const auto run = run_to(5, {gas, {-1, 0.2, 1}, {gas.contents(1, 0.7, 2), gas.contents(1, 0.7, 2)}}, {}, 1e-3);
    CHECK(figure(run->work(), "chop_outs") == 0);
}

// An event allocates nothing once the line has been as full as it gets: slots of cells and fronts are used again.
#include "tests/allocations.hpp"
#include "tests/solvers/rrm/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::rrm::test;
using ordo::test::allocations;

namespace {

/// A gas tube between two walls: waves run to and fro.
LineScene box() {
    const IdealGas gas;
    return {gas,
            {0, 0.5, 1},
            {gas.contents(1, 0, 1), gas.contents(0.125, 0, 0.1)},
            {LineEnd{LineEnd::Kind::wall}, LineEnd{LineEnd::Kind::wall}}};
}

double chop_outs(const Simulation& run) { return figure(run.work(), "chop_outs"); }

}  // namespace

TEST_CASE("rrm: once the line has been full no event allocates", "[property]") {
    for (const std::string keep : {"nothing", "contacts", "waves"}) {
        CAPTURE(keep);
        const auto run = started(box(), {{"keep", keep}}, 0.01);
        run->advance_to(2, never);
        const double chops = chop_outs(*run);
        const long before = allocations();
        run->advance_to(2.5, never);
        CHECK(allocations() == before);
        CHECK(chop_outs(*run) > chops + 100);
    }
}

TEST_CASE("rrm: a line allocates seldom while it fills", "[property]") {
    // Two arrays and the schedule double in length, and three rows of waves: 4 times log2 of some hundred slots.
    for (const std::string keep : {"nothing", "contacts", "waves"}) {
        CAPTURE(keep);
        const auto run = started(box(), {{"keep", keep}}, 0.01);
        const long before = allocations();
        run->advance_to(2, never);
        CHECK(allocations() - before < 60);
        CHECK(chop_outs(*run) > 1000);
    }
}

TEST_CASE("rrm: the counter of allocations counts", "[alarm]") {
    const auto run = started(box(), {}, 0.01);
    const long before = allocations();
    const auto shot = run->snapshot();
    CHECK(allocations() > before);
}

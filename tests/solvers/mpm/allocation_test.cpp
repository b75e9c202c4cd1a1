// A step allocates nothing.
#include <string>

#include "tests/allocations.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/mpm/variants.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm::test;
using ordo::test::allocations;

TEMPLATE_TEST_CASE_SIG("allocation: after the first step none allocates", "[property]", ((int dim), dim), 1, 2, 3) {
    const auto scheme = GENERATE(from_range(time_schemes));
    const auto strain_increment = GENERATE(from_range(strain_increments));
    INFO(scheme.name() << ", " << strain_increment);
    auto scene = box<dim>(Vec<dim>::Ones(), Face::free, uniform<dim>(Vec<dim>::Constant(0.5)));
    scene.body_force = uniform<dim>(Vec<dim>::Constant(-1));
    const auto body = started(scene,
                              {{"stress_update", scheme.stress_update},
                               {"time", scheme.time},
                               {"strain_increment", strain_increment},
                               {"margin", 1.0}},
                              {{"cells", 4.0}, {"ppc", 2.0}, {"dt", 0.02}});
    body->advance_to(0.02, never);
    const long before = allocations();
    body->advance_to(1, never);
    const long during = allocations() - before;
    CHECK(during == 0);
    CHECK(body->work()[2].value > 0);  // cells were crossed
}

TEST_CASE("allocation: variants allocate for longer rows now and then, not in every step", "[property]") {
    const auto variant = GENERATE(from_range(joined({updated_variants, total_variants})));
    INFO(variant.name());
    if (variant.options.contains("basis") && variant.options.at("basis") == Value("ddmp"))
        return;  // lists the cells that hold points, in every step
    auto scene = box<2>({1, 0.5}, Face::free, uniform<2>({0.5, 0.3}));
    scene.body_force = uniform<2>({0, -1});
    scene.traction = uniform<2>({0.1, 0});
    scene.damping = 0.1;
    const auto body = started(scene, variant.with({{"margin", 1.0}}), {{"cells", 4.0}, {"ppc", 2.0}, {"dt", 0.02}});
    body->advance_to(0.02, never);
    const long before = allocations();
    body->advance_to(0.4, never);
    CHECK(allocations() - before < 5);  // of 19 steps: boxes that come to touch more nodes
}

TEST_CASE("allocation: the counter counts", "[alarm]") {
    const auto body =
        started(box<1>(Vec<1>(1), Face::free, uniform<1>(Vec<1>(0.5))), {}, {{"cells", 4.0}, {"dt", 0.02}});
    const long before = allocations();
    body->advance_to(0.02, [&] { return body->snapshot().points() == 0; });  // a snapshot in each step
    CHECK(allocations() > before + 5);
}

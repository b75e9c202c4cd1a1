#include "solvers/mpm/options.hpp"

#include <string>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;

namespace {

template <int dim>
Resolution resolution(const SolidScene<dim>& scene, const Given& given) {
    return resolution_from(scene, resolve(resolution_parameters(), given, "", "solver mpm"));
}

const SolidScene<1> bar = test::fixed_free_bar(2, 4, 0.1, LogarithmicLaw{{.lambda = 0, .mu = 50}});

}  // namespace

TEST_CASE("mpm options: exactly one of dt and courant", "[unit]") {
    CHECK(resolution(bar, {{"cells", 8.0}, {"dt", 0.01}}).dt == 0.01);
    // sqrt(stiffness / rho) = sqrt(100 / 4) = 5 m/s and h = 1/4 m.
    CHECK(resolution(bar, {{"cells", 8.0}, {"courant", 0.5}}).dt == Approx(0.5 * 0.25 / 5));
    CHECK_THROWS_WITH(resolution(bar, {{"cells", 8.0}}), "solver mpm takes exactly one of 'dt' and 'courant'");
    CHECK_THROWS_WITH(resolution(bar, {{"cells", 8.0}, {"dt", 0.01}, {"courant", 0.5}}),
                      "solver mpm takes exactly one of 'dt' and 'courant'");
}

TEST_CASE("mpm options: cells must divide every edge of the body", "[unit]") {
    const auto plate = test::box<2>({1.0, 0.6}, Face::free, test::uniform<2>({0, 0}));
    const auto fine = resolution(plate, {{"cells", 10.0}, {"dt", 1.0}});
    CHECK(fine.h == Approx(0.1));
    CHECK_THROWS_WITH(resolution(plate, {{"cells", 4.0}, {"dt", 1.0}}),
                      "'cells' is 4, which gives 2.4 cells along axis 1, but must give a whole number");
    CHECK_THROWS_AS(resolution(plate, {{"cells", 1.0}, {"dt", 1.0}}), InputError);
    const auto sliver = test::box<3>({1.0, 1.0, 1e-12}, Face::free, test::uniform<3>({0, 0, 0}));
    CHECK_THROWS_AS(resolution(sliver, {{"cells", 4.0}, {"dt", 1.0}}), InputError);
}

TEST_CASE("mpm options: each word reaches its option", "[unit]") {
    const auto of = [](const Given& given) { return test::options_of(given); };
    CHECK(of({}).stress_update == StressUpdate::musl);
    CHECK(of({{"stress_update", "usf"}}).stress_update == StressUpdate::usf);
    CHECK(of({{"stress_update", "usl"}}).stress_update == StressUpdate::usl);
    CHECK(of({}).placement == Placement::cell_centred);
    CHECK(of({{"placement", "even_interior"}}).placement == Placement::even_interior);
    CHECK(of({{"placement", "gauss"}}).placement == Placement::gauss);
    CHECK_FALSE(of({}).strain_from_moved_mesh);
    CHECK(of({{"strain_increment", "moved_mesh"}}).strain_from_moved_mesh);
    CHECK(of({}).volume_updated);
    CHECK_FALSE(of({{"volume", "fixed"}}).volume_updated);
    CHECK(of({}).moved_by_remapped);
    CHECK_FALSE(of({{"position_update", "accelerated"}}).moved_by_remapped);
    CHECK_FALSE(of({{"stress_update", "usl"}}).moved_by_remapped);
    CHECK_FALSE(of({}).half_kick);
    CHECK(of({{"half_kick", true}}).half_kick);
    CHECK_THROWS_AS(of({{"half_kick", true}, {"stress_update", "usf"}}), InputError);
    CHECK_FALSE(of({}).extrapolate);
    CHECK(of({{"beyond_grid", "extrapolate"}}).extrapolate);
    CHECK(of({{"margin", 2.0}}).margin == 2);
}

TEST_CASE("mpm options: a plan says what a start will do", "[unit]") {
    const auto plate = test::box<2>({1.0, 0.6}, Face::free, test::uniform<2>({0, 0}));
    const Solver& mpm = solver_named("mpm", "");
    const Plan plan = mpm.plan(plate, resolve(mpm.options, {}, "", "mpm"),
                               resolve(mpm.resolution, {{"cells", 10.0}, {"ppc", 3.0}, {"dt", 0.02}}, "", "mpm"));
    CHECK(plan.h == Approx(0.1));
    CHECK(plan.dt == 0.02);
    CHECK(plan.points == 10 * 6 * 9);
    const auto simulation = test::started(plate, {}, {{"cells", 10.0}, {"ppc", 3.0}, {"dt", 0.02}});
    CHECK(simulation->snapshot().points() == 10 * 6 * 9);
}

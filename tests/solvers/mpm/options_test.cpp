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
    return resolution_from(scene, Options{}, resolve(resolution_parameters(), given, "", "solver mpm"));
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

TEST_CASE("mpm options: cells may span the margin, and a fraction of particles a cell", "[unit]") {
    const auto of = [](Given chosen, const Given& given) {
        chosen.insert({{"placement", "body_centred"}, {"margin", 0.15}});
        return resolution_from(bar, test::options_of(chosen), resolve(resolution_parameters(), given, "", "mpm"));
    };
    const Given given{{"cells", 10.0}, {"ppc", 3.5}, {"dt", 1.0}};
    CHECK(of({{"cells_span", "grid"}}, given).h == Approx(2 * 1.15 / 10));  // one free end
    CHECK(of({}, given).h == Approx(0.2));
    CHECK(of({}, given).ppc == 3.5);
    CHECK_THROWS_WITH(resolution(bar, given), ContainsSubstring("'ppc' is 3.5, but must be whole"));
    auto free = bar;
    free.faces[0][0] = Face::free;
    CHECK_THROWS_WITH(resolution_from(free, test::options_of({{"placement", "body_centred"}, {"cells_span", "grid"}}),
                                      resolve(resolution_parameters(), given, "", "mpm")),
                      ContainsSubstring("held lower face"));
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

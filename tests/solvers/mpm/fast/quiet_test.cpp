// What is at rest is not swept.
#include "tests/solvers/mpm/fast/twins.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

TEMPLATE_TEST_CASE_SIG("fast: quiet regions are skipped, and nothing changes", "[property]", ((int dim), dim), 1, 2) {
    for (const std::string update : {"usf", "usl", "musl"}) {
        for (const std::string basis : {"linear", "quadratic"}) {
            INFO(update << ", " << basis);
            // One end, or corner, is struck; the wave has gone a fifth of the way.
            auto scene = box<dim>(Vec<dim>(Vec<3>(1.0, 0.5, 0.5).head<dim>()), Face::roller, {});
            const double struck = scene.lower[0] + 0.1;
            scene.velocity = pointwise<dim>([struck](const Vec<dim>& X, double) -> Vec<dim> {
                return (X[0] < struck && X[dim - 1] < struck + 0.65 * (dim - 1) ? 0.01 : 0) * Vec<dim>::Unit(0);
            });
            const Given options{{"stress_update", update}, {"basis", basis}};
            const Given fine{{"cells", dim == 1 ? 400.0 : 100.0}, {"ppc", 2.0}, {"courant", 0.5}};
            const double t = 0.1;
            const Ended skipping = run(scene, options, "fast", fine, t);
            const Ended all = run(scene, options, "fast_everywhere", fine, t);
            // What is less than 1e-30 of the wave speed counts as rest; where amplitudes grow from there, sums round
            // differently. Velocities and stresses are near 0.01.
            for (const auto& field : skipping.shot.fields) {
                double apart = 0;
                for (std::size_t k = 0; k < field.values.size(); ++k)
                    apart = std::max(apart, std::abs(field.values[k] - all.shot.field(field.name).values[k]));
                CHECK(apart < (dim == 1 ? 1e-17 : 1e-15));
            }
            Given on = options;
            on["kernel"] = "fast";
            const auto body = started(scene, on, fine);
            body->advance_to(t, never);
            REQUIRE(body->skipped().size() == 1);
            CHECK(body->skipped()[0].share > 0.5);
            CHECK(body->skipped()[0].share < 0.95);
        }
    }
}

TEST_CASE("fast: a loaded end wakes a body at rest", "[property]") {
    auto scene = fixed_free_bar(1, 1, 0, LogarithmicLaw{{.lambda = 0, .mu = 0.5}});
    scene.traction = uniform<1>(Vec<1>(0.01));
    // USL loses a free end to small masses, with either kernel.
    for (const std::string update : {"usf", "musl"}) {
        INFO(update);
        const Given options{{"stress_update", update}};
        const Given fine{{"cells", 300.0}, {"ppc", 2.0}, {"courant", 0.2}};
        check_alike<1>(scene, options, fine, 0.1);
        CHECK(run(scene, options, "fast", fine, 0.1).shot.field("velocity").values.back() > 1e-3);
    }
}

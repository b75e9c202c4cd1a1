// What is at rest is not swept.
#include "tests/solvers/mpm/fast/twins.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

/// A body of which one end, or corner, is struck.
template <int dim>
SolidScene<dim> struck(double speed, double share) {
    auto scene = box<dim>(Vec<dim>(Vec<3>(1.0, 0.5, 0.5).head<dim>()), Face::roller, {});
    const Vec<dim> corner = scene.lower + Vec<dim>(Vec<3>(share, 0.5 * share + 0.025, 0).head<dim>());
    scene.velocity = pointwise<dim>([speed, corner](const Vec<dim>& X, double) -> Vec<dim> {
        return ((X - corner).maxCoeff() < 0 ? speed : 0) * Vec<dim>::Unit(0);
    });
    return scene;
}

/// How far the fields are apart where quiet regions are skipped and where they are not.
double apart(const Ended& skipping, const Ended& all) {
    double most = 0;
    for (const auto& field : skipping.shot.fields) {
        for (std::size_t k = 0; k < field.values.size(); ++k)
            most = std::max(most, std::abs(field.values[k] - all.shot.field(field.name).values[k]));
    }
    return most;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("fast: quiet regions are skipped, and nothing changes", "[property]", ((int dim), dim), 1, 2) {
    for (const std::string frame : {"updated", "total"}) {
        for (const std::string update : {"usf", "usl", "musl"}) {
            for (const std::string basis : {"linear", "quadratic"}) {
                INFO(frame << ", " << update << ", " << basis);
                const auto scene = struck<dim>(0.01, 0.1);
                const Given options{{"stress_update", update}, {"basis", basis}, {"frame", frame}};
                const Given fine{{"cells", dim == 1 ? 400.0 : 80.0}, {"ppc", 2.0}, {"courant", 0.5}};
                const double t = 0.1;
                const Ended skipping = run(scene, options, "fast", fine, t);
                // What is less than 1e-30 of the wave speed counts as rest; where amplitudes grow from there, sums
                // round differently. Velocities and stresses are near 0.01.
                CHECK(apart(skipping, run(scene, options, "fast_everywhere", fine, t)) < (dim == 1 ? 1e-17 : 1e-15));
                CHECK(figure(skipping.work, "cell_crossings") == 0);
                Given on = options;
                on["kernel"] = "fast";
                const auto body = started(scene, on, fine);
                body->advance_to(t, never);
                REQUIRE(body->skipped().size() == (frame == "total" ? 2 : 1));
                CHECK(body->skipped()[0].share > 0.4);
                CHECK(body->skipped()[0].share < 0.95);
            }
        }
    }
}

TEMPLATE_TEST_CASE_SIG("fast: particles that fly into a quiet region", "[property]", ((int dim), dim), 1, 2) {
    for (const std::string update : {"usf", "usl", "musl"}) {
        INFO(update);
        const auto scene = struck<dim>(0.4, 0.2);
        const Given fine{{"cells", dim == 1 ? 400.0 : 80.0}, {"ppc", 2.0}, {"courant", 0.3}};
        const Ended skipping = run(scene, {{"stress_update", update}}, "fast", fine, 0.04);
        const Ended all = run(scene, {{"stress_update", update}}, "fast_everywhere", fine, 0.04);
        CHECK(skipping.why == all.why);
        CHECK(figure(skipping.work, "cell_crossings") > 20);
        CHECK(figure(skipping.work, "cell_crossings") == figure(all.work, "cell_crossings"));
        // Nodes with a small share of mass enlarge an ulp, as in `round_off`.
        CHECK(apart(skipping, all) < 1e-11);
    }
}

TEST_CASE("fast: no mass is missing while a region wakes", "[property]") {
    for (const std::string frame : {"updated", "total"}) {
        for (const std::string update : {"usf", "usl", "musl"}) {
            INFO(frame << ", " << update);
            const auto body = started(struck<2>(0.01, 0.1), {{"stress_update", update}, {"frame", frame}},
                                      {{"cells", 80.0}, {"ppc", 2.0}, {"dt", 0.005}});
            for (int step = 1; step <= 20; ++step) {
                body->advance_to(0.005 * step, never);
                // 12,800 masses are added one by one; a row of cells is 1e-2 of them.
                CHECK(figure(body->drift(), "mass") < 1e-12);
            }
        }
    }
}

TEST_CASE("fast: a loaded end wakes a body at rest", "[property]") {
    auto scene = fixed_free_bar(1, 1, 0, LogarithmicLaw{{.lambda = 0, .mu = 0.5}});
    scene.traction = uniform<1>(Vec<1>(0.01));
    // In the updated frame USL loses a free end to small masses, with either kernel.
    for (const auto& [update, frame] :
         {std::pair{"usf", "updated"}, {"musl", "updated"}, {"usf", "total"}, {"usl", "total"}, {"musl", "total"}}) {
        INFO(update << ", " << frame);
        const Given options{{"stress_update", update}, {"frame", frame}};
        const Given fine{{"cells", 300.0}, {"ppc", 2.0}, {"courant", 0.2}};
        check_alike<1>(scene, options, fine, 0.1);
        CHECK(run(scene, options, "fast", fine, 0.1).shot.field("velocity").values.back() > 1e-3);
    }
}

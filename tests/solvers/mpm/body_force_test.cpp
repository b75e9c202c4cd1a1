// A body in free flight under constant gravity: stress-free, so that the time scheme is seen alone.
#include <string>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

template <int dim>
void check_flight(const TimeScheme& scheme) {
    const Vec<dim> g = Vec<dim>(Vec<3>(0.8, -1.5, 0.4).head<dim>());
    const Vec<dim> v0 = Vec<dim>(Vec<3>(-0.3, 0.5, 0.2).head<dim>());
    // No simple number: a particle that met a cell face exactly, with nothing beyond it, would see a node without mass
    // whose velocity is set to zero.
    const double dt = 0.0497;
    const double t = 20 * dt;
    auto scene = box<dim>(Vec<dim>::Constant(0.75), Face::free, uniform<dim>(v0));
    scene.body_force = uniform<dim>(g);
    const auto body = started(scene, {{"stress_update", scheme.stress_update}, {"time", scheme.time}, {"margin", 2.0}},
                              {{"cells", 3.0}, {"ppc", 2.0}, {"dt", dt}});
    body->advance_to(t, never);
    const Snapshot shot = body->snapshot();
    // A leapfrog, and what is composed of it, is exact for a constant acceleration. Full kicks from the start run half
    // a step ahead: g t dt / 2.
    const Vec<dim> flown = v0 * t + g * (0.5 * t * t + (scheme.time == "symplectic_euler" ? 0.5 * t * dt : 0));
    const double round_off = 1e-13;  // 20 steps, speeds near 2, light nodes at the rim
    for (std::size_t p = 0; p < shot.points(); ++p) {
        CHECK((vector_at<dim>(shot.field("displacement").values, p) - flown).norm() < round_off);
        CHECK((vector_at<dim>(shot.field("velocity").values, p) - v0 - g * t).norm() < round_off);
        CHECK(tensor_at<dim>(shot.field("stress").values, p).norm() < round_off);
    }
    CHECK(body->work()[2].value > 0);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("body force: free flight is exact with a half kick, half a step ahead without", "[property]",
                       ((int dim), dim), 1, 2, 3) {
    const auto scheme = GENERATE(from_range(time_schemes));
    INFO(scheme.name());
    check_flight<dim>(scheme);
}

TEST_CASE("body force: a flight in uneven legs keeps the leapfrog's time", "[property]") {
    // Legs of 7, 1 and 5 steps of different length: each kick spans from the middle of the last step to that of this
    // one.
    auto scene = box<1>(Vec<1>(0.75), Face::free, uniform<1>(Vec<1>(0.5)));
    scene.body_force = uniform<1>(Vec<1>(-1.5));
    const auto body =
        started(scene, {{"time", "leapfrog"}, {"margin", 2.0}}, {{"cells", 3.0}, {"ppc", 2.0}, {"dt", 0.05}});
    for (const double t : {0.34, 0.35, 0.58}) {
        body->advance_to(t, never);
        const Snapshot shot = body->snapshot();
        CHECK(shot.t == t);
        for (std::size_t p = 0; p < shot.points(); ++p) {
            CHECK(shot.field("velocity").values[p] == Approx(0.5 - 1.5 * t).epsilon(1e-12));
            CHECK(shot.field("displacement").values[p] == Approx(0.5 * t - 0.75 * t * t).epsilon(1e-12));
        }
    }
    CHECK(body->work()[0].value == 13);
}

TEST_CASE("body force: it is given the undeformed positions and the time of the step's start", "[property]") {
    std::vector<double> times;
    std::vector<Vec<1>> first;
    auto scene = box<1>(Vec<1>(0.75), Face::free, uniform<1>(Vec<1>(0.5)));
    scene.body_force = [&](std::span<const Vec<1>> X, double t, std::span<Vec<1>> out) {
        times.push_back(t);
        first.push_back(X[0]);
        std::fill(out.begin(), out.end(), Vec<1>(0));
    };
    const auto body = started(scene, {}, {{"cells", 3.0}, {"ppc", 1.0}, {"dt", 0.25}});
    body->advance_to(1, never);
    CHECK(times == std::vector{0.0, 0.25, 0.5, 0.75});
    CHECK(first == std::vector(4, Vec<1>(body->snapshot().X[0])));
}

// Energy of a freely vibrating bar over 100 periods: bounded where a scheme is symplectic, falling where it damps.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

constexpr double period = 2;  // 2 L / c with L = c = 1

/// Kinetic energy and the potential V0 E (F - 1)^2 / 2 of the law P = E (F - 1), E = rho = 1.
double energy(const Particles<1>& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double strain = p.F[i](0, 0) - 1;
        sum += 0.5 * p.m[i] * (p.v[i].squaredNorm() + strain * strain);
    }
    return sum;
}

/// Relative change of energy: its largest size over the first period and over all 100, and what is left at the end.
struct Drift {
    double first = 0, largest = 0, end = 0;
};

Drift drift_of(Given given, double ppc) {
    given.emplace("stress_from", "F");
    const Options options = options_of(given);
    const auto sine = [](const Vec<1>& X, double) { return Vec<1>(1e-3 * std::sin(std::numbers::pi * X[0])); };
    const SolidScene<1> scene{.lower = Vec<1>(0),
                              .upper = Vec<1>(1),
                              .law = NominalLaw{{.lambda = 0, .mu = 0.5}},
                              .faces = {{{Face::fixed, Face::fixed}}},
                              .velocity = pointwise<1>(sine)};
    const double dt = 0.2 / 16;
    Mpm<1> bar(scene, options, {.cells = 16, .ppc = ppc, .h = 1.0 / 16, .dt = dt}, true);
    const double start = energy(bar.particles());
    Drift drift;
    for (long k = 0; k < std::lround(100 * period / dt); ++k) {
        const double t = static_cast<double>(k) * dt;
        if (options.composed()) bar.composed_step(t, dt);
        else bar.step(t, options.leaps() && k == 0 ? dt / 2 : dt, dt);
        Mpm<1> now = bar;
        if (options.leaps()) now.synchronise(t + dt, dt / 2);
        drift.end = energy(now.particles()) / start - 1;
        drift.largest = std::max(drift.largest, std::abs(drift.end));
        if (t < period) drift.first = drift.largest;
    }
    return drift;
}

}  // namespace

TEST_CASE("energy: symplectic schemes swing about their energy for 100 periods and go nowhere", "[property]") {
    const auto given = GENERATE(values<Given>({
        {{"frame", "total"}, {"time", "leapfrog"}},
        {{"frame", "total"}, {"time", "leapfrog"}, {"mass", "consistent"}},
        {{"time", "leapfrog"}},
    }));
    const Drift drift = drift_of(given, 2);
    // A leapfrog's energy swings by (omega dt)^2 / 4 = (pi 0.0125)^2 / 4 = 3.9e-4.
    CHECK(drift.first == Approx(3.9e-4).epsilon(0.05));
    CHECK(drift.largest <= 1.02 * drift.first);
}

TEST_CASE("energy: a composition of order 4 swings less, and comes back", "[property]") {
    const Drift drift = drift_of({{"frame", "total"},
                                  {"basis", "quadratic"},
                                  {"mass", "consistent"},
                                  {"placement", "gauss"},
                                  {"time", "yoshida4"}},
                                 3);
    CHECK(drift.largest < 1e-6);  // the order (omega dt)^4 = 2.4e-6
    CHECK(drift.largest <= 1.02 * drift.first);
    CHECK(std::abs(drift.end) < 1e-9);  // whole periods: the swing is at its start
}

TEST_CASE("energy: reconstruction neither gains nor loses more than its own error", "[property]") {
    const Drift drift = drift_of({{"basis", "cubic"},
                                  {"mass", "consistent"},
                                  {"placement", "gauss"},
                                  {"time", "yoshida4"},
                                  {"reconstruction", "mls"},
                                  {"degree", 4.0},
                                  {"conservative", true}},
                                 3);
    CHECK(drift.largest < 1e-5);
    CHECK(drift.largest <= 1.1 * drift.first);
}

TEST_CASE("energy: stress last, stress on average and filtered transfers damp", "[property]") {
    struct Row {
        Given given;
        double least, most;
    };
    // Bounds on either side, not values: lumped USL has det < 1 (it damps even the first mode, by percents here), USAVG
    // half of that; PIC averages 16,000 times.
    const auto row = GENERATE(values<Row>({{{{"stress_update", "usl"}, {"time", "leapfrog"}}, 0.05, 0.3},
                                           {{{"stress_update", "usavg"}}, 0.02, 0.2},
                                           {{{"transfer", "pic"}}, 0.999, 1.0}}));
    const Drift drift = drift_of(row.given, 2);
    CHECK(-drift.end > row.least);
    CHECK(-drift.end < row.most);
}

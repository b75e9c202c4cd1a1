// The loops that kernels are measured against solve the problem that they claim to solve.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/reference/floor.hpp"
#include "bench/reference/scalar.hpp"
#include "tests/catch.hpp"

using namespace ordo::bench;

namespace {

/// A quarter of a period, in whole steps.
long quarter(const Wave& wave) { return std::lround(std::numbers::pi / (2 * wave.omega() * wave.dt())); }

template <class Loop>
Particles after(Loop loop, long steps) {
    for (long i = 0; i < steps; ++i) loop.step();
    return loop.particles();
}
Particles floor_after(const Wave& wave, const std::string& set, long steps) {
    Floor loop(wave, set);
    for (long i = 0; i < steps; ++i) loop.step();
    return loop.particles();
}

/// Largest difference of the stresses over the largest stress: a field that begins at zero and feels all sums.
double difference(const Particles& one, const Particles& other) {
    double difference = 0;
    double scale = 0;
    for (std::size_t k = 0; k < one.sigma.size(); ++k) {
        REQUIRE(one.sigma[k].size() == other.sigma[k].size());
        for (std::size_t i = 0; i < one.sigma[k].size(); ++i) {
            difference = std::max(difference, std::abs(one.sigma[k][i] - other.sigma[k][i]));
            scale = std::max(scale, std::abs(one.sigma[k][i]));
        }
    }
    return difference / scale;
}

/// Cells along the last axis: a multiple of what a strip of eight lanes needs.
Wave box(int dim, int degree) {
    Wave wave{.dim = dim, .degree = degree, .lambda = dim == 1 ? 0.0 : 30, .mu = dim == 1 ? 50.0 : 35};
    for (int axis = 0; axis < dim; ++axis) wave.cells[axis] = axis == dim - 1 ? 16 : 9 + axis;
    return wave;
}

}  // namespace

TEST_CASE("reference loops: 200 cells of a bar with a free end are as exact as in public measurements",
          "[convergence]") {
    // 2.1e-5 in two programs of others' and ours; both faults of lumped tents, of order h^2, and of dt cancel in part.
    const Wave bar{.cells = {200, 1, 1}, .free_end = true};
    const long steps = quarter(bar);
    const auto floor = floor_after(bar, "", steps);
    const auto scalar = after(Scalar(bar), steps);
    CHECK(error_of(bar, floor, static_cast<double>(steps) * bar.dt()) == Approx(2.1e-5).margin(0.05e-5));
    CHECK(error_of(bar, scalar, static_cast<double>(steps) * bar.dt()) == Approx(2.1e-5).margin(0.05e-5));
}

TEST_CASE("reference loops: halving the cells quarters the error", "[convergence]") {
    const auto [dim, degree] = GENERATE(table<int, int>({{1, 1}, {1, 2}, {2, 1}, {2, 2}, {3, 1}}));
    CAPTURE(dim, degree);
    Wave wave = box(dim, degree);
    wave.v0 = 1e-5;
    wave.courant = 0.05;  // a symplectic Euler step adds an error of first order in dt, a thirtieth of that of h
    double error[2];
    for (const int level : {0, 1}) {
        const int cells = 8 << level;
        for (int axis = 0; axis < dim; ++axis) wave.cells[axis] = cells;
        wave.h = 1.0 / cells;
        const long steps = std::lround(0.8 * static_cast<double>(quarter(wave)));
        error[level] = error_of(wave, after(Scalar(wave), steps), static_cast<double>(steps) * wave.dt());
    }
    // Second order in h; the next term is a tenth of it at 8 cells a half wave.
    CHECK(std::log2(error[0] / error[1]) == Approx(2).margin(0.2));
}

TEST_CASE("reference loops: scalar and slots give the same answer on every instruction set", "[property]") {
    const auto [dim, degree] = GENERATE(table<int, int>({{1, 1}, {1, 2}, {2, 1}, {2, 2}, {3, 1}}));
    const Wave wave = box(dim, degree);
    const auto scalar = after(Scalar(wave), 100);
    for (const std::string set : {"", "avx2", "baseline"}) {
        CAPTURE(dim, degree, set);
        // Round-off of 100 steps: sums in another order, none larger than a hundred terms.
        CHECK(difference(floor_after(wave, set, 100), scalar) < 1e-12);
    }
    if (dim == 1) CHECK(difference(after(Scalar(wave, true), 100), scalar) < 1e-12);
}

TEST_CASE("reference loops: a body that drifts across cells keeps its wave-free state", "[property]") {
    Wave wave{.dim = 2, .degree = 2, .cells = {6, 6, 1}, .lambda = 30, .mu = 35, .v0 = 0, .margin = 12};
    wave.drift = 0.25 * wave.h / wave.dt();
    const auto now = after(Scalar(wave), 40);
    const auto first = seeded(wave);
    for (std::size_t i = 0; i < now.size(); ++i) {
        CHECK(now.x[0][i] - first.x[0][i] == Approx(10 * wave.h).epsilon(1e-12));
        // The stress of a unit strain is 100.
        CHECK(std::abs(now.sigma[0][i]) < 1e-10);
    }
}

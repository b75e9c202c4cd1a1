// Time of the blast's exact solution: one sampled point (items_per_second), and what it takes to know alpha.
#include "oracles/blasts/sedov.hpp"

#include <benchmark/benchmark.h>

#include <vector>

using namespace ordo::oracles;

namespace {

using enum Sedov::Geometry;

const std::vector<Sedov> blasts{{.geometry = planar, .gamma = 1.4},
                                {.geometry = cylindrical, .gamma = 2},
                                {.geometry = spherical, .gamma = 1.4},
                                {.geometry = spherical, .gamma = 1.4, .omega = 7.0 / 3},
                                {.geometry = spherical, .gamma = 1.4, .omega = 2.4}};

/// All fields at n points between core and shock; arguments: which blast, n.
void sedov_points(benchmark::State& state) {
    const SedovBlast blast(blasts[static_cast<std::size_t>(state.range(0))]);
    const auto front = blast.front(1);
    const auto n = state.range(1);
    const double step = (front.r - front.core) / static_cast<double>(n);
    for (auto _ : state) {
        double sum = 0;
        for (std::int64_t i = 0; i < n; ++i) {
            const auto [u, rho, p, e] = blast.at(front.core + (static_cast<double>(i) + 0.5) * step, front);
            sum += u + rho + p + e;
        }
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * n);
}

/// Energy integrals and all constants.
void sedov_constants(benchmark::State& state) {
    const Sedov given = blasts[static_cast<std::size_t>(state.range(0))];
    for (auto _ : state) benchmark::DoNotOptimize(SedovBlast(given).integrals().alpha);
}

// The cost of a point is flat in n.
BENCHMARK(sedov_points)->ArgsProduct({{0, 1, 2, 3, 4}, {1000}})->Args({2, 1000000});
BENCHMARK(sedov_constants)->DenseRange(0, 4);

}  // namespace

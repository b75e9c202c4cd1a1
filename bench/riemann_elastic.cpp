// Time of an elastic Riemann problem: its star state, and a point once that is known. Stated: 20 us and 1 us at most.
#include <benchmark/benchmark.h>

#include <vector>

#include "oracles/riemann/elastic_laws.hpp"
#include "oracles/riemann/riemann_linear_elastic.hpp"
#include "oracles/riemann/riemann_nonlinear_elastic.hpp"

using namespace ordo::oracles;
using namespace ordo::oracles::elastic;

namespace {

struct Pair {
    State left, right;
};

/// Fan and shock, two shocks, two fans, two shocks of unequal states.
constexpr Pair pairs[]{{{0.5, 0, 1}, {1, 0, 0.2}},
                       {{1, 0.4, 0.5}, {1, -0.4, 0.5}},
                       {{1, -0.4, 0.5}, {1, 0.4, 0.5}},
                       {{0.8, 0.3, 0.4}, {1.25, -0.1, 0.9}}};

template <class Strain>
using Law = Material<Strain, PowerHeat>;

/// Argument: which of the pairs. k is no whole number, which would flatter the powers.
template <class Strain>
void star(benchmark::State& state) {
    const Law<Strain> material{{1}, {1, 1.3}, 1};
    auto [left, right] = pairs[state.range(0)];
    for (auto _ : state) {
        left.v += 1e-12;  // a new problem each time
        benchmark::DoNotOptimize(star_state(material, left, right));
    }
}

/// Argument: the number of points in one call, all of them in fans. items_per_second are points.
template <class Strain>
void points_in_fans(benchmark::State& state) {
    const RiemannNonlinearElastic<Law<Strain>> problem({{1}, {1, 1.3}, 1}, pairs[2].left, pairs[2].right);
    const auto speeds = problem.speeds();
    const auto n = static_cast<std::size_t>(state.range(0));
    std::vector<Row> rows(n);
    for (auto _ : state) {
        for (std::size_t i = 0; i < n; ++i) {
            const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
            rows[i] = problem.fields(speeds[0] + share * (speeds[1] - speeds[0]), 1);
        }
        benchmark::DoNotOptimize(rows.data());
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void linear_points(benchmark::State& state) {
    const RiemannLinearElastic problem(1, 1, 1, pairs[0].left, pairs[0].right);
    double x = -2;
    for (auto _ : state) {
        x = x > 2 ? -2 : x + 1e-3;
        benchmark::DoNotOptimize(problem.fields(x, 1));
    }
}

BENCHMARK(star<NeoHookean>)->DenseRange(0, 3);
BENCHMARK(star<Reciprocal>)->DenseRange(0, 3);
BENCHMARK(star<Logarithmic>)->DenseRange(0, 3);
BENCHMARK(points_in_fans<NeoHookean>)->Arg(100)->Arg(1000000);
BENCHMARK(points_in_fans<Reciprocal>)->Arg(1000);
BENCHMARK(points_in_fans<Logarithmic>)->Arg(1000);
BENCHMARK(linear_points);

}  // namespace

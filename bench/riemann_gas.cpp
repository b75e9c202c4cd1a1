// Time of an exact Riemann problem of gases: its star state, a point and a cell mean once that is known.
#include "oracles/riemann/riemann_gas.hpp"

#include <benchmark/benchmark.h>

#include <vector>

using namespace ordo::oracles;

namespace {

struct Data {
    const char* name;
    Gas left, right;
};

const Data problems[] = {{"Sod", {1, 0, 1}, {0.125, 0, 0.1}},
                         {"two shocks", {5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.0950}},
                         {"123", {1, -2, 0.4}, {1, 2, 0.4}},
                         {"blast", {1, 0, 1000}, {1, 0, 0.01}},
                         {"Le Blanc", {1, 0, 0.1 / 1.5, 5.0 / 3}, {1e-3, 0, 1e-10 / 1.5, 5.0 / 3}},
                         {"two gammas", {1, 0, 2, 2}, {0.125, 0, 0.1, 1.4}},
                         {"two fans, two gammas", {1, -1, 0.4, 1.3}, {2, 1, 0.5, 1.7}},
                         {"water and air", {1000, 0, 1e9, 4.4, 6e8}, {50, 0, 1e5, 1.4, 0}},
                         {"vacuum", {1, -6, 0.4}, {1, 6, 0.4}}};

/// p*, v* and the densities beside the contact.
void gas_star(benchmark::State& state) {
    Data data = problems[state.range(0)];
    state.SetLabel(data.name);
    for (auto _ : state) {
        benchmark::DoNotOptimize(data);
        benchmark::DoNotOptimize(star_between(GasSide(data.left), GasSide(data.right)));
    }
}
BENCHMARK(gas_star)->DenseRange(0, 8);

/// The same with checks, wave speeds and all constant states.
void gas_problem(benchmark::State& state) {
    Data data = problems[state.range(0)];
    state.SetLabel(data.name);
    for (auto _ : state) {
        benchmark::DoNotOptimize(data);
        benchmark::DoNotOptimize(RiemannGas(data.left, data.right));
    }
}
BENCHMARK(gas_problem)->DenseRange(0, 8);

/// All six fields at points evenly spread over all waves, through the call by name. items_per_second are points.
void gas_points(benchmark::State& state) {
    const Oracle oracle = riemann_gas();
    const Exact exact = oracle.bind(ordo::resolve(oracle.parameters, {}, "", oracle.name));
    std::vector<double> x(static_cast<std::size_t>(state.range(0)));
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = -0.5 + (static_cast<double>(i) + 0.5) / static_cast<double>(x.size());
    std::vector<double> values(x.size() * exact.width());
    for (auto _ : state) {
        exact.sample(x, 0.2, values);
        benchmark::DoNotOptimize(values.data());
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(gas_points)->Arg(1)->Arg(1000)->Arg(1000000);

/// Means over as many cells.
void gas_means(benchmark::State& state) {
    const RiemannGas sod({1, 0, 1}, {0.125, 0, 0.1});
    const double width = 1.0 / static_cast<double>(state.range(0));
    for (auto _ : state) {
        for (double a = -0.5; a < 0.5; a += width) benchmark::DoNotOptimize(sod.mean(a, a + width, 0.2));
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(gas_means)->Arg(100)->Arg(10000);

}  // namespace

// What skipping quiet cells and nodes saves, and what it costs where there are none: each run with it on and off.
// Argument of the benchmarks: the share of the line that waves fill at the end, in percent. items_per_second are
// updates of all cells or nodes, touched or not. Stated: at least 5 times faster at 10, at most 3 % slower at 100.
#include <benchmark/benchmark.h>

#include "solvers/fem/fem.hpp"
#include "solvers/godunov/godunov.hpp"
#include "solvers/rrm/line.hpp"
#include "solvers/rrm/options.hpp"

using namespace ordo;
using namespace ordo::solvers;

namespace {

/// Sod's waves span 2.93 t. They fill that share of the line from the start on: the measured steps begin at t = 1.
void godunov_sod(benchmark::State& state, bool skip) {
    using namespace godunov;
    const double half = 0.5 * 2.93 * 100 / static_cast<double>(state.range(0));
    const IdealGas gas;
    const LineScene scene{gas, {-half, 0, half}, {gas.contents(1, 0, 1), gas.contents(0.125, 0, 0.1)}};
    const Resolution resolution{.cells = 4000, .h = 2 * half / 4000, .courant = 0.45};
    Grid grid(scene, {.speeds = PressureBased{}, .skip_quiet = skip}, resolution);
    double t = 0;
    const auto step = [&] {
        const double dt = resolution.courant * resolution.h / grid.fastest(t);
        grid.step(dt);
        t += dt;
    };
    while (t < 1) step();
    const Grid start = grid;
    for (auto _ : state) {
        grid = start;
        for (int k = 0; k < 50; ++k) step();
    }
    state.SetItemsProcessed(state.iterations() * 50 * resolution.cells);
}

/// A bar of 20,000 elements that is pulled at its free end, from when the front has run over that share of it.
void fem_traction(benchmark::State& state, bool skip) {
    using namespace fem;
    const double share = 0.01 * static_cast<double>(state.range(0));
    SolidScene<1> scene{.law = NominalLaw{{.lambda = 0, .mu = 0.5}}, .faces = {{{Face::fixed, Face::free}}}};
    scene.velocity = [](auto, double, auto out) { std::ranges::fill(out, Vec<1>::Zero()); };
    scene.traction = [](auto, double, auto out) { std::ranges::fill(out, Vec<1>(0.01)); };
    const fem::Resolution resolution{.cells = 20'000, .h = 1.0 / 20'000, .dt = 0.5 / 20'000};
    Bar bar(scene, {.skip_quiet = skip}, resolution);
    double t = 0;
    const auto step = [&] {
        bar.step({.t = t, .dt = resolution.dt, .kick = resolution.dt, .velocity_time = t + 0.5 * resolution.dt});
        t += resolution.dt;
    };
    while (t < share) step();
    const Bar start = bar;
    for (auto _ : state) {
        bar = start;
        for (int k = 0; k < 200; ++k) step();
    }
    state.SetItemsProcessed(state.iterations() * 200 * resolution.cells);
}

/// Sod's tube by chop-outs: no more of them, and no dearer, in a wider line.
void rrm_sod(benchmark::State& state) {
    using namespace rrm;
    const double half = 0.5 * 2.93 * 100 / static_cast<double>(state.range(0));
    const IdealGas gas;
    const LineScene scene{gas, {-half, 0, half}, {gas.contents(1, 0, 1), gas.contents(0.125, 0, 0.1)}};
    const Given given{
        {"keep", "contacts"}, {"density_change", 0.4}, {"velocity_change", 0.4}, {"pressure_change", 0.4}};
    const rrm::Options options = options_from(scene, resolve(declared_options(), given, "", "solver rrm"),
                                              resolve(declared_resolution(), {{"delta", 1e-3}}, "", "solver rrm"));
    double chop_outs = 0;
    for (auto _ : state) {
        rrm::Line<IdealGas> line(gas, scene, options);
        line.advance_to(1, [] { return false; });
        chop_outs += line.counts().chop_outs;
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(chop_outs));
}

BENCHMARK_CAPTURE(godunov_sod, skip, true)->Arg(10)->Arg(100);
BENCHMARK_CAPTURE(godunov_sod, compute, false)->Arg(10)->Arg(100);
BENCHMARK_CAPTURE(fem_traction, skip, true)->Arg(10)->Arg(100);
BENCHMARK_CAPTURE(fem_traction, compute, false)->Arg(10)->Arg(100);
BENCHMARK(rrm_sod)->Arg(10)->Arg(100);

}  // namespace

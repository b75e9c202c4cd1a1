// Time of one MPM step. items_per_second are particle-steps per second; run with --benchmark_filter=... for one kernel.
#include <benchmark/benchmark.h>

#include <cmath>

#include "solvers/mpm/mpm.hpp"

using namespace ordo::solvers;
using namespace ordo::solvers::mpm;

namespace {

/// An elastic cube with one fixed face, set swinging so gently that no particle leaves its cell.
template <int dim>
SolidScene<dim> cube() {
    SolidScene<dim> scene;
    scene.law = LogarithmicLaw{{.lambda = dim == 1 ? 0.0 : 0.4, .mu = 0.5}};
    scene.faces[0][0] = Face::fixed;
    scene.velocity = [](std::span<const Vec<dim>> X, double, std::span<Vec<dim>> v) {
        for (std::size_t i = 0; i < X.size(); ++i) v[i] = Vec<dim>::Constant(1e-6 * std::sin(1.5 * X[i][0]));
    };
    return scene;
}

/// Arguments of the benchmark: cells along an edge, particles a cell and direction.
template <int dim, StressUpdate stress_update>
void mpm_step(benchmark::State& state) {
    const int cells = static_cast<int>(state.range(0));
    const Resolution resolution{
        .cells = cells, .ppc = static_cast<int>(state.range(1)), .h = 1.0 / cells, .dt = 0.2 / cells};
    const Options options{.stress_update = stress_update};
    Mpm<dim> body(cube<dim>(), options, resolution, false);
    for (auto _ : state) body.step(0, resolution.dt, resolution.dt);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(body.particles().size()));
}

// 1D: the size of the finest published bar, and 64 k particles (more than a cache holds). 2D and 3D: 64 k particles.
BENCHMARK(mpm_step<1, StressUpdate::usf>)->Args({512, 4})->Args({16384, 4});
BENCHMARK(mpm_step<1, StressUpdate::usl>)->Args({512, 4})->Args({16384, 4});
BENCHMARK(mpm_step<1, StressUpdate::musl>)->Args({512, 4})->Args({16384, 4});
BENCHMARK(mpm_step<2, StressUpdate::musl>)->Args({128, 2});
BENCHMARK(mpm_step<3, StressUpdate::musl>)->Args({20, 2});

}  // namespace

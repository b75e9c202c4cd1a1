// Time of one step of the fast MPM kernel. items_per_second are particle-steps per second; ORDO_SIMD chooses the set of
// instructions. "flight": every particle crosses a cell face each ten steps; "front": a tenth of the body has moved.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "solvers/mpm/fast/fast.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;

namespace {

enum class Motion { swings, flies, front };

/// An elastic cube: set swinging so gently that no particle leaves its cell, thrown, or struck at one end.
template <int dim>
SolidScene<dim> cube(Motion motion) {
    SolidScene<dim> scene;
    if constexpr (dim == 1) scene.law = NominalLaw{{.lambda = 0, .mu = 0.5}};
    else scene.law = LogarithmicLaw{{.lambda = 0.4, .mu = 0.5}};
    if (motion != Motion::flies) scene.faces[0] = {Face::fixed, Face::fixed};
    scene.velocity = [motion](std::span<const Vec<dim>> X, double, std::span<Vec<dim>> v) {
        for (std::size_t i = 0; i < X.size(); ++i) {
            const double swing = 1e-6 * std::sin(3 * X[i][0]);
            const double struck = X[i][0] < 0.1 ? 1e-6 : 0;
            v[i] = Vec<dim>::Constant(motion == Motion::flies ? 1 : motion == Motion::swings ? swing : struck);
        }
    };
    return scene;
}

/// Arguments of the benchmark: cells along an edge, particles a cell and direction.
template <int dim>
void fast_step(benchmark::State& state, const Given& given, Motion motion) {
    const Options options = options_from(resolve(option_parameters(), given, "", "solver mpm"));
    const int cells = static_cast<int>(state.range(0));
    const Resolution resolution{
        .cells = cells, .ppc = static_cast<double>(state.range(1)), .h = 1.0 / cells, .dt = 0.1 / cells};
    fast::FastMpm<dim> body(cube<dim>(motion), options, resolution, false);
    double t = 0;
    for (auto _ : state) {
        if (motion != Motion::swings && t > 0.05) {  // before it leaves the grid, or the front has gone far
            state.PauseTiming();
            body = fast::FastMpm<dim>(cube<dim>(motion), options, resolution, false);
            t = 0;
            state.ResumeTiming();
        }
        body.step(t, resolution.dt, resolution.dt);
        t += resolution.dt;
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(body.particles().size()));
}

template <int dim>
void enrol(const std::string& name, Given given, Motion motion, std::int64_t cells, std::int64_t ppc) {
    given.insert({"stress_update", "usl"});
    const auto* prefix = dim == 1 ? "fast 1D " : dim == 2 ? "fast 2D " : "fast 3D ";
    benchmark::RegisterBenchmark((prefix + name).c_str(), [given, motion](benchmark::State& state) {
        fast_step<dim>(state, given, motion);
    })->Args({cells, ppc});
}

void enrol_all() {
    for (const std::int64_t cells : {200, 8000, 500000}) {
        enrol<1>("linear", {}, Motion::swings, cells, 2);
        enrol<1>("quadratic", {{"basis", "quadratic"}}, Motion::swings, cells, 2);
    }
    enrol<1>("linear musl", {{"stress_update", "musl"}}, Motion::swings, 8000, 2);
    enrol<1>("linear total", {{"frame", "total"}}, Motion::swings, 8000, 2);
    enrol<1>("linear flight", {}, Motion::flies, 8000, 2);
    for (const std::string kernel : {"fast", "fast_everywhere"}) {
        enrol<1>("linear front " + kernel, {{"kernel", kernel}}, Motion::front, 8000, 2);
        enrol<1>("linear active " + kernel, {{"kernel", kernel}}, Motion::swings, 8000, 2);
        enrol<2>("linear front " + kernel, {{"kernel", kernel}}, Motion::front, 300, 2);
    }
    for (const std::int64_t cells : {16, 160, 500}) {
        enrol<2>("linear", {}, Motion::swings, cells, 2);
        enrol<2>("quadratic", {{"basis", "quadratic"}}, Motion::swings, cells, 2);
    }
    enrol<2>("linear flight", {}, Motion::flies, 160, 2);
    for (const std::int64_t cells : {20, 48}) enrol<3>("linear", {}, Motion::swings, cells, 2);
}

const bool enrolled = (enrol_all(), true);

}  // namespace

// Time of one MPM step. items_per_second are particle-steps per second; run with --benchmark_filter=... for one kernel.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "solvers/mpm/mpm.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;

namespace {

/// An elastic cube between two fixed faces, set swinging so gently that no particle leaves its cell.
template <int dim>
SolidScene<dim> cube() {
    SolidScene<dim> scene;
    if constexpr (dim == 1) scene.law = NominalLaw{{.lambda = 0, .mu = 0.5}};
    else scene.law = LogarithmicLaw{{.lambda = 0.4, .mu = 0.5}};
    scene.faces[0] = {Face::fixed, Face::fixed};
    scene.velocity = [](std::span<const Vec<dim>> X, double, std::span<Vec<dim>> v) {
        for (std::size_t i = 0; i < X.size(); ++i) v[i] = Vec<dim>::Constant(1e-6 * std::sin(3 * X[i][0]));
    };
    return scene;
}

/// Arguments of the benchmark: cells along an edge, particles a cell and direction.
template <int dim>
void mpm_step(benchmark::State& state, const Given& given) {
    const Options options = options_from(resolve(option_parameters(), given, "", "solver mpm"));
    const int cells = static_cast<int>(state.range(0));
    const Resolution resolution{
        .cells = cells, .ppc = static_cast<double>(state.range(1)), .h = 1.0 / cells, .dt = 0.1 / cells};
    Mpm<dim> body(cube<dim>(), options, resolution, false);
    for (auto _ : state) {
        if (options.composed()) body.composed_step(0, resolution.dt);
        else body.step(0, resolution.dt, resolution.dt);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(body.particles().size()));
}

template <int dim>
void enrol(const std::string& name, const Given& given, std::int64_t cells, std::int64_t ppc) {
    const auto* prefix = dim == 1 ? "1D " : dim == 2 ? "2D " : "3D ";
    benchmark::RegisterBenchmark((prefix + name).c_str(), [given](benchmark::State& state) {
        mpm_step<dim>(state, given);
    })->Args({cells, ppc});
}

/// Each pair of basis and mass; the orders of the stress update; frames, transfers, reconstructions and time schemes.
void enrol_all() {
    for (const std::string basis :
         {"linear", "quadratic", "cubic", "quartic", "ugimp", "cpgimp", "cpdi", "cpdi2", "ddmp"}) {
        for (const std::string mass : {"lumped", "consistent", "fmpm"})
            enrol<1>(basis + " " + mass, {{"basis", basis}, {"mass", mass}}, 512, 4);
    }
    for (const std::string update : {"usf", "usl", "musl", "usavg"})
        enrol<1>("linear lumped " + update, {{"stress_update", update}}, 16384, 4);
    for (const std::string transfer : {"flip", "pic", "blend", "xpic", "apic", "tpic", "mls"})
        enrol<1>("quadratic usl " + transfer,
                 {{"basis", "quadratic"}, {"stress_update", "usl"}, {"transfer", transfer}}, 512, 4);
    for (const std::string mass : {"lumped", "consistent"})
        enrol<1>("quadratic total " + mass, {{"basis", "quadratic"}, {"mass", mass}, {"frame", "total"}}, 512, 4);
    enrol<1>("cubic total consistent yoshida4",
             {{"basis", "cubic"}, {"mass", "consistent"}, {"frame", "total"}, {"time", "yoshida4"}}, 512, 4);
    for (const std::string kind : {"cubic_spline", "tls", "mls"}) {
        enrol<1>("cubic consistent " + kind,
                 {{"basis", "cubic"}, {"mass", "consistent"}, {"reconstruction", kind}, {"beyond_grid", "follow"}}, 512,
                 4);
    }
    enrol<1>("impm", {{"reconstruction", "impm"}, {"stress_update", "usl"}, {"beyond_grid", "follow"}}, 512, 4);
    enrol<2>("linear lumped", {}, 128, 2);
    enrol<2>("quadratic lumped", {{"basis", "quadratic"}}, 128, 2);
    enrol<2>("cpdi lumped", {{"basis", "cpdi"}}, 128, 2);
    enrol<3>("linear lumped", {}, 20, 2);
    enrol<3>("quadratic lumped", {{"basis", "quadratic"}}, 20, 2);
}

const bool enrolled = (enrol_all(), true);

}  // namespace

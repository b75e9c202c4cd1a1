// Time of the fixed grid. items_per_second are cell updates per second: one cell, one step. Stated: 30 ns at most for a
// gas by MUSCL-Hancock with HLLC.
#include "solvers/godunov/godunov.hpp"

#include <benchmark/benchmark.h>

#include <string>

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::godunov;

namespace {

/// Two uniform pieces of equal length that touch at 0.
template <class M>
LineScene pieces(const M& medium, const Contents& left, const Contents& right) {
    return {medium, {-5, 0, 5}, {left, right}};
}

/// Argument of the benchmark: cells. The grid runs on and on; its waves leave through the ends.
void grid_step(benchmark::State& state, const LineScene& scene, const Given& given) {
    const Options options = options_from(scene.medium, resolve(option_parameters(), given, "", "solver godunov"));
    const int cells = static_cast<int>(state.range(0));
    const Resolution resolution{.cells = cells, .h = 10.0 / cells, .courant = 0.45};
    Grid grid(scene, options, resolution);
    double t = 0;
    for (auto _ : state) {
        const double dt = resolution.courant * resolution.h / grid.fastest(t);
        grid.step(dt);
        t += dt;
    }
    state.SetItemsProcessed(state.iterations() * cells);
}

void enrol(const std::string& name, const LineScene& scene, const Given& given) {
    benchmark::RegisterBenchmark(("godunov " + name).c_str(), grid_step, scene, given)
        ->Arg(400)
        ->Arg(1600)
        ->Arg(100'000);
}

void enrol_all() {
    const IdealGas gas;
    const ElasticMedium<HookeEnergy> hooke;
    const ElasticMedium<RubberEnergy> rubber{.k = 1};
    const auto sod = pieces(gas, gas.contents(1, 0, 1), gas.contents(0.125, 0, 0.1));
    const auto linear = pieces(hooke, hooke.contents(0.5, 0, 1), hooke.contents(1, 0, 0.2));
    const auto nonlinear = pieces(rubber, rubber.contents(0.5, 0, 1), rubber.contents(1, 0, 0.2));
    for (const std::string order : {"first", "second"}) {
        for (const std::string flux : {"hll", "hllc"}) {
            const Given given{{"order", order}, {"flux", flux}};
            enrol("gas " + order + " " + flux, sod, given);
            enrol("hooke " + order + " " + flux, linear, given);
            enrol("rubber " + order + " " + flux, nonlinear, given);
        }
    }
    for (const std::string speeds : {"davis", "einfeldt", "acoustic"})
        enrol("gas second hllc " + speeds, sod, {{"speeds", speeds}});
    for (const std::string limiter : {"minmod", "van_leer", "superbee"})
        enrol("gas second hllc " + limiter, sod, {{"limiter", limiter}});
}

const bool enrolled = (enrol_all(), true);

}  // namespace

// Time of the Repeated Replacement Method. items_per_second are chop-outs per second. Measured: 2.5 to 3.9 million for a
// gas at delta 1e-3 that keeps nothing or contacts. Where waves are kept, most time goes into them and few chop-outs
// are left.
#include "solvers/rrm/rrm.hpp"

#include <benchmark/benchmark.h>

#include <string>

#include "solvers/rrm/line.hpp"
#include "solvers/rrm/options.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::rrm;

namespace {

/// A Riemann problem at 0 until t.
template <class M>
struct Problem {
    M medium;
    Contents left, right;
    double t;
};

/// Argument of the benchmark: 1 / delta.
template <class M>
void rrm_run(benchmark::State& state, const Problem<M>& problem, const Given& given) {
    const LineScene scene{problem.medium, {-2.5, 0, 2.5}, {problem.left, problem.right}};
    const double delta = 1 / static_cast<double>(state.range(0));
    const Options options = options_from(scene, resolve(declared_options(), given, "", "solver rrm"),
                                         resolve(declared_resolution(), {{"delta", delta}}, "", "solver rrm"));
    double chop_outs = 0;
    for (auto _ : state) {
        Line<M> line(problem.medium, scene, options);
        line.advance_to(problem.t, [] { return false; });
        chop_outs += line.counts().chop_outs;
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(chop_outs));
}

template <class M>
void enrol(const std::string& name, const Problem<M>& problem, const Given& given) {
    benchmark::RegisterBenchmark(("rrm " + name).c_str(), rrm_run<M>, problem, given)->Arg(100)->Arg(1000)->Arg(10'000);
}

void enrol_all() {
    const IdealGas gas;
    const ElasticMedium<HookeEnergy> hooke;
    const ElasticMedium<RubberEnergy> rubber{.k = 1};
    for (const std::string keep : {"nothing", "contacts", "waves"}) {
        const Given given{{"keep", keep}};
        enrol<IdealGas>("gas sod " + keep, {gas, gas.contents(1, 0, 1), gas.contents(0.125, 0, 0.1), 0.75}, given);
        enrol<IdealGas>("gas toro4 " + keep,
                        {gas, gas.contents(5.99924, 19.5975, 460.894), gas.contents(5.99242, -6.19633, 46.095), 0.15},
                        given);
        enrol<ElasticMedium<HookeEnergy>>("hooke " + keep,
                                          {hooke, hooke.contents(0.5, 0, 1), hooke.contents(1, 0, 0.2), 1}, given);
        enrol<ElasticMedium<RubberEnergy>>("rubber " + keep,
                                           {rubber, rubber.contents(0.5, 0, 1), rubber.contents(1, 0, 0.2), 1}, given);
    }
}

const bool enrolled = (enrol_all(), true);

}  // namespace

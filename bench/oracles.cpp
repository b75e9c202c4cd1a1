// Time of one sampled point of each exact solution of the catalogue, all fields, by one call: the same for a thousand
// points as for a million.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "oracles/oracle.hpp"

using namespace ordo;
using namespace ordo::oracles;

namespace {

/// n points on the middle line of the box, or of [-2, 2] where it is unbounded; of an annulus or a sequence its first
/// one.
std::vector<double> places(const Exact& exact, std::size_t n, bool one_place) {
    std::vector<double> x;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t axis = 0; axis < exact.lower.size(); ++axis) {
            const double low = std::max(exact.lower[axis], -2.0);
            const double high = std::min(exact.upper[axis], 2.0);
            const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
            x.push_back(one_place ? (axis == 0 ? exact.upper[0] : 0.0) : low + share * (high - low));
        }
    }
    return x;
}

void sampled(benchmark::State& state, const Oracle& oracle) {
    const bool one_place =
        oracle.name == "ring_mms" || oracle.name == "vortex_mms" || oracle.name == "scalar_root_convergence";
    const Exact exact = oracle.bind(resolve(oracle.parameters, {}, "", oracle.name));
    const auto x = places(exact, static_cast<std::size_t>(state.range(0)), one_place);
    std::vector<double> values(x.size() / exact.lower.size() * exact.width());
    for (auto _ : state) {
        exact.sample(x, 0.3, values);
        benchmark::DoNotOptimize(values.data());
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

const bool enrolled = [] {
    for (const auto& oracle : all_oracles()) {
        if (oracle.fields.empty()) continue;
        benchmark::RegisterBenchmark(oracle.name.c_str(), sampled, oracle)->Arg(1000)->Arg(1'000'000);
    }
    return true;
}();

}  // namespace

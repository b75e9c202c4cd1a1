// Time of a particle-step of the bare loops and of the solver's kernels on the same problem, from 1e3 to 1e7 particles.
// items_per_second are particle-steps per second; `bytes` is memory a particle. For ratios use ordo_kernels, which
// takes them in turns.
#include <benchmark/benchmark.h>

#include <cmath>

#include "bench/kernels/cases.hpp"

using namespace ordo::bench;

namespace {

void kernel(benchmark::State& state, Case one) {
    one.cells = static_cast<int>(state.range(0));
    Started now = started(one);
    long left = most_crossing_steps;
    for (auto _ : state) {
        if (one.crossing && left-- == 0) {
            state.PauseTiming();
            now = started(one);
            left = most_crossing_steps - 1;
            state.ResumeTiming();
        }
        now.steps(1);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(now.particles));
    state.counters["bytes"] = now.bytes / now.particles;
}

void enrol_all() {
    for (const auto& [dim, degree] : {std::pair{1, 1}, {1, 2}, {2, 1}, {2, 2}, {3, 1}}) {
        for (const bool crossing : {false, true}) {
            for (const auto& loop : loops_for({"", dim, degree, crossing})) {
                const std::string name = "kernel " + std::to_string(dim) + "D degree " + std::to_string(degree) +
                                         (crossing ? " crossing " : " staying ") + loop;
                auto* enrolled = benchmark::RegisterBenchmark(name.c_str(), kernel, Case{loop, dim, degree, crossing});
                for (double particles = 1e3; particles < 2e7; particles *= 10) {
                    const double edge = std::pow(particles, 1.0 / dim) / 2;
                    enrolled->Arg(std::max(16, 8 * static_cast<int>(std::lround(edge / 8))));
                }
            }
        }
    }
}

const bool enrolled = (enrol_all(), true);

}  // namespace

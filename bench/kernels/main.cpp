// Times of the solver's kernels as ratios to the bare loops, taken in turns in one process.
//   ordo_kernels [ROUNDS [MOST_PARTICLES]]                          the table, as markdown; 9 rounds of 1e5 unless said
//   ordo_kernels run LOOP DIM DEGREE staying|crossing CELLS STEPS   one loop, to count its instructions
//   ordo_kernels loops                                              what LOOP may be of a bar, one a line
//   ordo_kernels threads                                            what two threads gain: a bare loop, the solver
#include <algorithm>
#include <barrier>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <thread>

#include "bench/kernels/cases.hpp"
#include "bench/reference/floor.hpp"

using namespace ordo::bench;

namespace {

struct Times {
    double least, median;  ///< [ns] a particle and step
    double bytes;          ///< of memory a particle
};

/// All loops of a case in turns; a round is at least 2e5 particle-steps where the body has room for them.
std::map<std::string, Times> times_of(Case one, int rounds) {
    std::map<std::string, Started> running;
    std::map<std::string, std::vector<double>> all;
    for (int round = 0; round < rounds; ++round) {
        for (const auto& loop : loops_for(one)) {
            one.loop = loop;
            if (round == 0 || one.crossing) running[loop] = started(one);
            const Started& now = running[loop];
            const long wanted = std::max(1L, std::lround(2e5 / now.particles));
            // Particles of a cell cross together: so few steps that all cross thrice, or more.
            const long steps = one.crossing ? std::clamp(wanted, 12L, most_crossing_steps) : wanted;
            const double begin = thread_seconds();
            now.steps(steps);
            all[loop].push_back(1e9 * (thread_seconds() - begin) / (static_cast<double>(steps) * now.particles));
        }
    }
    std::map<std::string, Times> times;
    for (auto& [loop, values] : all) {
        std::ranges::sort(values);
        const Started& now = running[loop];
        times[loop] = {values.front(), values[values.size() / 2], now.bytes / now.particles};
    }
    return times;
}

std::string ratio(const std::map<std::string, Times>& times, const std::string& loop, const std::string& to) {
    if (!times.contains(loop) || !times.contains(to)) return "-";
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", times.at(loop).median / times.at(to).median);
    return text;
}

/// Cells along an edge for about so many particles: a multiple of 8 an axis.
int cells_for(double particles, int dim) {
    const double edge = std::pow(particles, 1.0 / dim) / 2;
    return std::max(16, 8 * static_cast<int>(std::lround(edge / 8)));
}

void print_table(int rounds, double most) {
    std::printf(
        "| Kernel | Particles | Body | floor ns | scalar ns | readable / scalar | fast / floor | fast / scalar | fast "
        "B |\n"
        "|---|---|---|---|---|---|---|---|---|\n");
    for (const auto& [dim, degree] : {std::pair{1, 1}, {1, 2}, {2, 1}, {2, 2}, {3, 1}}) {
        int before = 0;
        for (double particles = 1e3; particles <= most * 1.01; particles *= 10) {
            const int cells = cells_for(particles, dim);
            if (cells == before) continue;
            before = cells;
            for (const bool crossing : {false, true}) {
                const Case one{"", dim, degree, crossing, cells};
                const auto times = times_of(one, rounds);
                const std::string floor = crossing ? "-" : std::to_string(times.at("floor").median).substr(0, 5);
                std::printf("| %dD degree %d | %ld | %s | %s | %.2f | %s | %s | %s | %.0f |\n", dim, degree,
                            wave_of(one).particles(), crossing ? "crossing" : "staying", floor.c_str(),
                            times.at("scalar").median, ratio(times, "solver readable", "scalar").c_str(),
                            ratio(times, "solver fast", "floor").c_str(), ratio(times, "solver fast", "scalar").c_str(),
                            times.at("solver fast").bytes);
                std::fflush(stdout);
            }
        }
    }
}

double wall_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Wall seconds of `steps` steps of the floor on as many threads, each with its part of the body, which wait for each
/// other every step.
double floor_seconds(int threads, const Case& one, long steps) {
    std::barrier together(threads);
    std::vector<Floor> parts;
    Wave wave = wave_of(one);
    wave.cells[one.dim - 1] /= threads;
    for (int i = 0; i < threads; ++i) parts.emplace_back(wave);
    const double begin = wall_now();
    {
        std::vector<std::jthread> all;
        for (auto& part : parts) {
            all.emplace_back([&] {
                for (long step = 0; step < steps; ++step) {
                    part.step();
                    together.arrive_and_wait();
                }
            });
        }
    }
    return wall_now() - begin;
}

double solver_seconds(const Started& running, long steps) {
    const double begin = wall_now();
    running.steps(steps);
    return wall_now() - begin;
}

/// Gains from the least wall times of rounds in which one and two threads, floor and solver take turns.
void print_threads() {
    std::printf("| Kernel | Particles | gain of the floor | of the solver | ratio |\n|---|---|---|---|---|\n");
    for (const auto& [dim, particles] : {std::pair{1, 3e4}, {1, 1e5}, {1, 1e6}, {1, 1e7}, {2, 1e5}, {2, 1e6}}) {
        Case one{"solver fast", dim, 1, false, cells_for(particles, dim)};
        one.cells -= one.cells % 16;  // halves of whole strips
        const Started alone = started(one);
        one.loop = "solver fast with threads";
        const Started both = started(one);
        const long steps = std::max(4L, std::lround(4e6 / alone.particles));
        double least[4] = {1e9, 1e9, 1e9, 1e9};
        for (int round = 0; round < 7; ++round) {
            const double now[4] = {floor_seconds(1, one, steps), floor_seconds(2, one, steps),
                                   solver_seconds(alone, steps), solver_seconds(both, steps)};
            for (int k = 0; k < 4; ++k) least[k] = std::min(least[k], now[k]);
        }
        const double bare = least[0] / least[1];
        const double gain = least[2] / least[3];
        std::printf("| %dD linear | %.0f | %.2f | %.2f | %.2f |\n", dim, alone.particles, bare, gain, gain / bare);
        std::fflush(stdout);
    }
}

void print_loops() {
    for (const auto& loop : loops_for({})) std::printf("%s\n", loop.c_str());
}

void run_one(char** words) {
    const Case one{words[0], std::stoi(words[1]), std::stoi(words[2]), std::string(words[3]) == "crossing",
                   std::stoi(words[4])};
    started(one).steps(std::stol(words[5]));
}

}  // namespace

int main(int count, char** words) {
    try {
        const std::string first = count > 1 ? words[1] : "";
        if (first == "run" && count == 8) run_one(words + 2);
        else if (first == "loops") print_loops();
        else if (first == "threads") print_threads();
        else print_table(first.empty() ? 9 : std::stoi(first), count > 2 ? std::stod(words[2]) : 1e5);
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "ordo_kernels: %s\n", fault.what());
        return 2;
    }
}

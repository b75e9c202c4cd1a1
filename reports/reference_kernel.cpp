#include "reports/reference_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <limits>
#include <vector>

namespace ordo::reports {
namespace {

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

constexpr std::size_t nodes = 64;
constexpr int steps = 100;

/// Particles that bounce between neighbouring nodes: hats, a scatter, a division, a gather and a root, as solvers have.
double bounced() {
    std::vector<double> place(1024), speed(1024, 1.0), mass(nodes + 1), momentum(nodes + 1);
    for (std::size_t p = 0; p < place.size(); ++p) place[p] = static_cast<double>(p * nodes) / 1024;
    for (int step = 0; step < steps; ++step) {
        std::ranges::fill(mass, 1e-9);
        std::ranges::fill(momentum, 0.0);
        for (std::size_t p = 0; p < place.size(); ++p) {
            const auto node = std::min(static_cast<std::size_t>(place[p]), nodes - 1);
            const double right = place[p] - static_cast<double>(node);
            mass[node] += 1 - right;
            mass[node + 1] += right;
            momentum[node] += (1 - right) * speed[p];
            momentum[node + 1] += right * speed[p];
        }
        for (std::size_t i = 0; i <= nodes; ++i) momentum[i] /= mass[i];
        for (std::size_t p = 0; p < place.size(); ++p) {
            const auto node = std::min(static_cast<std::size_t>(place[p]), nodes - 1);
            speed[p] = std::sqrt(1 + 0.5 * momentum[node] * momentum[node + 1]);
            place[p] = std::fmod(place[p] + 1e-2 * speed[p], static_cast<double>(nodes));
        }
    }
    return place.front() + speed.back();
}

}  // namespace

double reference_kernel_seconds() {
    double best = std::numeric_limits<double>::infinity();
    for (int repetition = 0; repetition < 5; ++repetition) {
        const double begin = thread_seconds();
        volatile double kept = bounced();
        static_cast<void>(kept);
        best = std::min(best, thread_seconds() - begin);
    }
    return best;
}

}  // namespace ordo::reports

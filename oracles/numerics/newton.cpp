#include "oracles/numerics/newton.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "oracles/numerics/gsl.hpp"

namespace ordo::oracles {
namespace {

/// What GSL calls, with the last answer kept: GSL asks for value and slope apart, and keeps them to itself.
struct Memory {
    FunctionWithSlope f;
    double x = std::numeric_limits<double>::quiet_NaN();
    ValueAndSlope last{};

    const ValueAndSlope& at(double place) {
        if (!(place == x)) {
            x = place;
            last = f.at(place, f.context);
        }
        return last;
    }
};

double value_at(double x, void* memory) { return static_cast<Memory*>(memory)->at(x).value; }
double slope_at(double x, void* memory) { return static_cast<Memory*>(memory)->at(x).slope; }
void both_at(double x, void* memory, double* value, double* slope) {
    *value = value_at(x, memory);
    *slope = slope_at(x, memory);
}

/// Half way: geometrically where both ends have one sign, since roots spread over decades.
double middle(double low, double high) {
    if (low > 0) return std::sqrt(low) * std::sqrt(high);
    if (high < 0) return -std::sqrt(-low) * std::sqrt(-high);
    return low + 0.5 * (high - low);
}

}  // namespace

double newton_root(FunctionWithSlope f, double low, double high, double start, double noise, double last_step) {
    constexpr int most_iterations = 400;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    quiet_gsl();
    Memory memory{.f = f};
    gsl_function_fdf function{value_at, slope_at, both_at, &memory};
    // The solver's own state on the stack: gsl_root_fdfsolver_alloc would be a good part of a short solution's time.
    alignas(std::max_align_t) std::array<std::byte, 64> room{};
    const auto* const newton = gsl_root_fdfsolver_newton;
    if (newton->size > room.size()) return nan;
    gsl_root_fdfsolver solver{.type = newton, .fdf = &function, .root = start, .state = room.data()};
    const auto restart = [&](double x) { return gsl_root_fdfsolver_set(&solver, &function, x) == GSL_SUCCESS; };
    if (!restart(std::isnan(start) ? middle(low, high) : std::clamp(start, low, high))) return nan;
    for (int i = 0; i < most_iterations; ++i) {
        const double x = solver.root;
        const auto [value, slope] = memory.at(x);
        if (std::isnan(value)) return nan;
        if (std::abs(value) <= noise) return x;
        (value < 0 ? low : high) = x;
        if (std::isfinite(slope) && gsl_root_fdfsolver_iterate(&solver) == GSL_SUCCESS) {
            // Round-off may carry the last step over an end.
            if (std::abs(solver.root - x) <= last_step * std::abs(x)) return std::clamp(solver.root, low, high);
            if (solver.root > low && solver.root < high) continue;
        }
        const double half = middle(low, high);
        if (!(half > low && half < high) || !restart(half)) return x;
    }
    return nan;
}

}  // namespace ordo::oracles

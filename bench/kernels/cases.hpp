#pragma once
// One elastic problem for the bare loops and for the solver's kernels, so that a time is a ratio.
#include <functional>
#include <string>
#include <vector>

#include "bench/reference/wave.hpp"

namespace ordo::bench {

/// What runs, on what. `loop` is one of `loops_for`; the solver's are "solver readable" and "solver fast", both also
/// "... with body_force", "with damping", "with traction", "with strain" or "with fixed_volume"; "solver fast with
/// threads" has two.
struct Case {
    std::string loop;
    int dim = 1;
    int degree = 1;
    bool crossing = false;  ///< the body drifts by 0.26 of a cell a step; else no particle leaves its cell
    int cells = 200;        ///< along each axis
};

/// Steps that a drifting body has room for after its start, in which its particles cross faces ten times.
constexpr long most_crossing_steps = 38;

struct Started {
    std::function<void(long)> steps;  ///< so many more
    double particles = 0;
    double bytes = 0;  ///< of memory since before the start
};

/// The bare loops of such a case, and the solver's kernels that there are.
std::vector<std::string> loops_for(const Case& wanted);

Wave wave_of(const Case& wanted);

/// The problem with all its memory, before its first step. Throws std::invalid_argument on an unknown loop.
Started started(const Case& wanted);

/// Seconds of this thread's processor time.
double thread_seconds();

}  // namespace ordo::bench

#pragma once
// The choices of the fixed grid, each named as in the literature; declared once, in options.cpp.
#include <vector>

#include "core/parameter.hpp"
#include "solvers/godunov/fluxes.hpp"
#include "solvers/godunov/limiters.hpp"
#include "solvers/media/line.hpp"

namespace ordo::solvers::godunov {

/// How the method discretises; chosen between the passes of a step.
struct Options {
    bool second_order = true;  ///< MUSCL-Hancock; otherwise uniform cells
    RiemannSolver riemann = Hllc{};
    SpeedEstimate speeds = Davis{};
    Limiter limiter = MonotonizedCentral{};
    bool skip_quiet = true;  ///< cells that keep their contents are not touched; not declared: the bits are the same
};

/// How finely: equal cells, their width [m], and the largest dt (|v| + a) / h of a step.
struct Resolution {
    int cells = 2;
    double h = 1;
    double courant = 0.45;
};

std::vector<Parameter> option_parameters();
std::vector<Parameter> resolution_parameters();

/// Throws InputError on a speed estimate that is not for that medium.
Options options_from(const Medium& medium, const Values& values);

Resolution resolution_from(const LineScene& scene, const Values& values);

/// Throws InputError on an end that a fixed grid does not have, and on a piece that is no matter waves can run through.
void check(const LineScene& scene);

}  // namespace ordo::solvers::godunov

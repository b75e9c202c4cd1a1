#pragma once
// Iterations for one root of f(x) = 0: how fast an iteration converges is a study as well.
#include "solvers/solver.hpp"

namespace ordo::solvers::root_finding {

enum class Method { newton, modified_newton, secant };

/// The iterates x_0, x_1, ..., x_n.
///
///   newton           x' = x - f(x) / f'(x)
///   modified_newton  x' = x - f(x) / f'(x_0)
///   secant           x' = x - f(x) (x - x_before) / (f(x) - f(x_before)), from x_0 and x_1
///
/// An iteration that has arrived, f(x) = 0, stays. Where a slope is zero it throws Diverged.
std::vector<double> iterates(const ScalarEquation& equation, Method method, int n);

/// "root_finding": a run makes so many iterations; its h is the last correction |x_n - x_(n-1)|, which an iteration
/// knows without knowing the root, and which shrinks as the error before it does: error = C h^order.
Solver solver();

}  // namespace ordo::solvers::root_finding

#include "oracles/numerics/root.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <cmath>
#include <limits>
#include <memory>

#include "oracles/numerics/gsl.hpp"

namespace ordo::oracles {

double bracketed_root(Function f, double low, double high) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr int most_iterations = 400;  // a double's 64 bits by bisection alone, several times over
    const double at_low = f.value(low, f.context);
    const double at_high = f.value(high, f.context);
    if (at_low == 0) return low;
    if (at_high == 0) return high;
    if (!(std::signbit(at_low) != std::signbit(at_high)) || std::isnan(at_low) || std::isnan(at_high)) return nan;
    quiet_gsl();
    const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
        gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
    gsl_function function{f.value, f.context};
    if (gsl_root_fsolver_set(solver.get(), &function, low, high) != GSL_SUCCESS) return nan;
    for (int i = 0; i < most_iterations; ++i) {
        if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) return nan;
        const double a = gsl_root_fsolver_x_lower(solver.get());
        const double b = gsl_root_fsolver_x_upper(solver.get());
        const double root = gsl_root_fsolver_root(solver.get());
        if (std::abs(b - a) <= 2 * std::numeric_limits<double>::epsilon() * std::abs(root)) return root;
    }
    return nan;
}

}  // namespace ordo::oracles

#pragma once
// Mesh width and time step together: e = A h^p + B dt^q + f over a grid of runs, each part with its interval.
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "studies/order/convergence.hpp"

namespace ordo::studies {

/// One point of the grid: h [m], dt [s], error > 0.
struct JointPoint {
    double h = 0;
    double dt = 0;
    double error = 0;
};

/// A number with a two-sided 95 % interval; NaN where the points do not tell it.
struct Estimate {
    double value = std::numeric_limits<double>::quiet_NaN();
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN();
};

enum class ErrorPart { space, time, floor };
std::string text_of(ErrorPart part);

/// Parts of the fitted error at one point; their sum is 1.
struct Shares {
    double space = 0;
    double time = 0;
    double floor = 0;

    ErrorPart dominant() const;
};

/// The run that would teach most, one level further than the grid in h, in dt or in both.
struct NextRun {
    double h = 0;
    double dt = 0;
    double p_half_width = std::numeric_limits<double>::quiet_NaN();  ///< expected after it; NaN: cannot be foretold
    double q_half_width = std::numeric_limits<double>::quiet_NaN();
    std::string why;
};

struct JointFit {
    Estimate p;                  ///< order in h
    Estimate q;                  ///< order in dt
    Estimate A;                  ///< [error / m^p]
    Estimate B;                  ///< [error / s^q]
    Estimate f;                  ///< floor [error]; NaN where the points ask for none
    double scatter = 0;          ///< standard deviation of ln(error) around the fit
    std::vector<Shares> shares;  ///< of each point, in the order given; empty where nothing was fitted
    std::optional<NextRun> next;
    Convergence verdict = Convergence::inconclusive;
    std::string reason;
};

/// Least squares of ln e, as noise of errors is relative: Levenberg-Marquardt from several starts. Parts join the model
/// one by one: only where a corrected Akaike criterion falls and an F-test (1 %) asks for it, and a floor only where it
/// is the largest part at two points. An order is known only where its part is more than half of the error at two
/// values of its abscissa; what never dominates has no number. Intervals: Student, from the local covariance.
///
/// converges        both orders known, above zero, and to +- 0.5
/// pre_asymptotic   an order changes by more than 0.2 over the grid, as an F-test (1 %) sees; intervals are infinite
/// at_floor         neither h nor dt moves the error
/// stalled          an order lies within +- 0.1, interval included
/// diverges         an order is below zero
/// invalid          a point that is no number or not positive, or is there twice
/// inconclusive     otherwise, with the reason: fewer than three values of h or dt, or fewer than seven points
///
/// Where A and B have different signs the parts can cancel; no sum of positive parts fits then, and the scatter says
/// so.
JointFit fit_joint(const std::vector<JointPoint>& points);

}  // namespace ordo::studies

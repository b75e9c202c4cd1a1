#pragma once
// Where a series of measured values stepped: a piecewise-constant fit with a penalty for every step.
#include <cstddef>
#include <vector>

namespace ordo::reports {

/// A step in a series: from `before` to `now` between the places `at - 1` and `at`.
struct LevelStep {
    std::size_t at = 0;
    double before = 0;
    double now = 0;
};

struct Steps {
    std::vector<LevelStep> steps;
    double noise = 0;        ///< standard deviation of one value that the fit reckoned with
    bool few_places = true;  ///< too few places to estimate noise from the series itself
};

/// Fewer places than this say nothing about the noise between them.
inline constexpr std::size_t places_for_noise = 6;

/// Steps in a series of places, each with all values found there. Values of one place never make a step.
///
/// The levels minimise  sum w (y - level)^2 / noise^2 + penalty * steps,  y the mean of a place and w its values. The
/// noise is the largest of
///   - the scatter of values of one place (pooled standard deviation);
///   - the scatter between neighbouring places, from the median of their differences, which steps do not inflate. Where
///     most neighbours are equal to the bit it is zero, so that the steps of a deterministic figure are all found;
///   - as much as makes a change by `least` between two single values just count.
/// The penalty is the square of a Student quantile: noise alone makes a step in about one series of 10^5.
/// A NaN at a place is a level of its own: going to NaN and back are steps. Time: the square of the number of places.
Steps steps_in(const std::vector<std::vector<double>>& places, double least);

}  // namespace ordo::reports

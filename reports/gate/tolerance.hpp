#pragma once
// How far a figure may be off its accepted value: as far as it was measured to scatter, and no comfort beyond.
#include <vector>

#include "reports/gate/figure.hpp"

namespace ordo::reports {

/// A tolerance is this many times the measured spread ...
inline constexpr double times_spread = 10;
/// ... and at least this many units in the last place of the value; none for counts, which are whole numbers.
inline constexpr double least_ulps = 16;

/// Half-width of the interval around each figure of the first report. The other reports answer the same question and
/// were made by other builds or machines; they hold the same figures in the same order.
///
/// The spread of a figure is its largest value minus its smallest one over the reports, an absolute number: an error
/// near round-off scatters by its own size. Two reports often agree by luck, so a figure gets at least what its group
/// (same solver, same quantity) usually scatters by: the median spread; or the median share of the value where spreads
/// grow with the values and are small beside them. Where all reports agree to the bit, or there is one alone, the units
/// in the last place remain. A figure that no report has gets 0.
std::vector<double> tolerances(const std::vector<std::vector<Figure>>& reports);

/// Largest minus smallest value of each figure over the reports; 0 where none has it.
std::vector<double> spreads(const std::vector<std::vector<Figure>>& reports);

/// `least_ulps` units in the last place of the figure's value; 0 for a count.
double least_tolerance(const Figure& figure);

}  // namespace ordo::reports

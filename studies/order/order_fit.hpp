#pragma once
// Observed order of accuracy: a value, a 95 % interval that bears the model's uncertainty, and a verdict.
// docs/orders.md says how it is found and how often it is right.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/order/convergence.hpp"

namespace ordo::studies {

/// One point of a convergence line: abscissa (h or dt) and error.
struct FitPoint {
    double abscissa = 0;
    double error = 0;
};

/// e = A h^p; e = A h^p + f; e = A h^p + B h^q.
enum class ErrorModel { power, power_and_floor, two_powers };
std::string text_of(ErrorModel model);

/// Why points are no series.
enum class Refusal { none, too_few, abscissa, repeated, is_nan, infinite, negative, zero };

/// The same with its words: "the error is nan at abscissa 0.5".
struct Refused {
    Refusal refusal = Refusal::none;
    std::string why = {};
};

struct OrderFit {
    double order = 0;
    double low = 0;  ///< 95 % interval; infinite with two points, with too few above a floor, where the finest ones
                     ///< are not where the others foretell them, and where neighbour orders run away
    double high = 0;
    double coefficient = 0;  ///< A
    ErrorModel model = ErrorModel::power;
    double floor = 0;                ///< f, where the model has one [error]
    double second_coefficient = 0;   ///< B, likewise
    double second_order = 0;         ///< q
    double correlation = 0;          ///< of the logarithms of the points used
    std::vector<double> neighbours;  ///< log(e_1/e_2)/log(h_1/h_2) of all consecutive points

    double error_at(double abscissa) const;  ///< of the fitted model
};

/// A point that the fit does not use, by its place in the list that was given.
struct UnusedPoint {
    std::size_t place = 0;
    std::string why;
};

/// A fit where there is one, and in any case what the series shows and why that is said.
struct FitOutcome {
    std::optional<OrderFit> fit;
    Convergence verdict = Convergence::invalid;
    std::string reason;
    Refusal refusal = Refusal::none;  ///< where the verdict is invalid
    std::vector<UnusedPoint> left_out;
};

/// Fits all points or, where the corrected Akaike criterion and the residuals ask for it, leaves out coarse ones, adds
/// a floor or a second power. Points may come in any order; neighbours follow falling abscissae. Relative scatter of
/// the errors may be of any size, the same for all points.
FitOutcome fit_order(std::vector<FitPoint> points);

/// Order between two points; NaN where it is undefined.
double neighbour_order(FitPoint coarse, FitPoint fine);

}  // namespace ordo::studies

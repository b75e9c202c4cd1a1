#pragma once
// Observed order of accuracy: least squares in log-log, sign kept, points listed.
#include <optional>
#include <string>
#include <vector>

namespace ordo::studies {

/// One point of a convergence line: abscissa (h or dt) and error.
struct FitPoint {
    double abscissa = 0;
    double error = 0;
};

/// error = coefficient * abscissa^order, with a two-sided 95 % Student interval on the order.
struct OrderFit {
    double order = 0;
    double low = 0;  ///< interval; -inf and +inf with two points
    double high = 0;
    double coefficient = 0;
    double correlation = 0;          ///< of the logarithms
    std::vector<double> neighbours;  ///< log(e_1/e_2)/log(h_1/h_2) of consecutive points
};

/// A fit, or the reason why there is none.
struct FitOutcome {
    std::optional<OrderFit> fit;
    std::string refused;
};

/// Fits all points. Refuses, by name, fewer than two points, a NaN, infinite, negative or zero error, errors that are
/// all equal (no convergence, so no order), and an abscissa that is not positive or is repeated. Points may come in any
/// order; neighbours follow falling abscissae.
FitOutcome fit_order(std::vector<FitPoint> points);

/// Order between two points; NaN where it is undefined.
double neighbour_order(FitPoint coarse, FitPoint fine);

}  // namespace ordo::studies

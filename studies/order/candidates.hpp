#pragma once
// The answers that a series admits: a model over a window, each with the interval of its order. order_fit.cpp chooses.
#include <limits>
#include <string>

#include "studies/order/models.hpp"
#include "studies/order/order_fit.hpp"

namespace ordo::studies {

struct Candidate {
    ErrorModel model = ErrorModel::power;
    Eigen::Index dropped = 0;  ///< coarse points left out
    double order = 0;
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    LeastSquares fit;
    double sign = 1;                                          ///< of the second power
    double akaike = std::numeric_limits<double>::infinity();  ///< corrected; a point left out counts as a parameter
    double scatter = 0;                                       ///< standard deviation of ln e about the model
    Eigen::Index asymptotic = 0;                              ///< points where A h^p is the larger part
    Eigen::Index other = 0;                                   ///< the remaining ones of the window
    double least_neighbour = 0;  ///< least and largest order between neighbours above the floor, where there is one
    double largest_neighbour = 0;
    bool curved = false;       ///< a power law whose residuals bend
    bool finest_agree = true;  ///< the finest points are where the others foretell them
    bool possible = true;      ///< it was found, and there are points enough in each regime
};

/// A h^p over all but `dropped` points. From four points on the interval spans the slopes at both ends of a parabola
/// through the window, so that a bend too weak to be seen is inside; with three it is Student's, with two none.
Candidate power_law(const LogSeries& series, Eigen::Index dropped);

/// A h^p + f. The interval is Student's, with the model's own slope at the coarsest point in it, and no less than the
/// scatter of the neighbour orders above the floor.
Candidate above_floor(const LogSeries& series, Eigen::Index dropped);

/// A h^p + B h^q over all points. The interval is Student's, with the model's own slope at the finest point in it.
Candidate with_second_power(const LogSeries& series);

/// Widens the interval of a model with a floor or a second power to bootstrap's, where there are eight points.
void widen_to_bootstrap(Candidate& candidate, const LogSeries& series);

}  // namespace ordo::studies

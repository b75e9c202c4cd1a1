#pragma once
// Least squares of value = limit + C h^p, and of its neighbours with fixed powers.
#include <Eigen/Dense>
#include <string>

namespace ordo::studies {

/// A fitted law of values over h / h_max.
struct ValueFit {
    std::string model;    ///< "h^p", "h", "h^2", "h + h^2"
    double order = 0;     ///< p; NaN for "h + h^2"
    double limit = 0;     ///< at h = 0; NaN where p <= 0
    double constant = 0;  ///< C over h / h_max
    double spread = 0;    ///< standard deviation of the values around it
    Eigen::VectorXd fitted;
};

/// Weights that are all alike, or as 1/h; their mean is 1.
enum class Weights { equal, fine_grids };

/// p, limit and C together; p within -4 and 12. h rising or falling, n > 3.
ValueFit fit_power(const Eigen::VectorXd& h, const Eigen::VectorXd& values, Weights weights);

/// limit + C1 h (+ C2 h^2), by the powers 1, 2 or both; n > 3.
ValueFit fit_fixed(const Eigen::VectorXd& h, const Eigen::VectorXd& values, bool first, bool second, Weights weights);

/// Standard error of p from the local covariance of an unweighted `fit_power`.
double error_of_order(const Eigen::VectorXd& h, const ValueFit& fit);

}  // namespace ordo::studies

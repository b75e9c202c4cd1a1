#pragma once
// The error models in logarithms, and their least squares. x = ln(h / finest h), y = ln e.
#include <Eigen/Dense>

namespace ordo::studies {

/// Points from coarse to fine: x falls to 0.
struct LogSeries {
    Eigen::VectorXd x;
    Eigen::VectorXd y;

    Eigen::Index size() const { return x.size(); }
    LogSeries finest(Eigen::Index count) const { return {x.tail(count), y.tail(count)}; }
    LogSeries coarsest(Eigen::Index count) const { return {x.head(count), y.head(count)}; }
};

/// Rounding, as a relative error of an error: residuals below it are no information.
inline constexpr double rounding = 1e-9;

/// Parameters that minimise the sum of squared residuals of y.
struct LeastSquares {
    bool found = false;
    Eigen::VectorXd parameters;
    Eigen::MatrixXd inverse;    ///< of the normal matrix: times the variance it is the covariance
    Eigen::VectorXd residuals;  ///< y - model
    double squares = 0;         ///< of the residuals; not below those of rounding

    double variance() const;                         ///< of y about the model
    double deviation(Eigen::Index parameter) const;  ///< standard deviation of a parameter
};

/// y = sum c_k x^k, k = 0 .. degree.
LeastSquares polynomial(const LogSeries& series, int degree);

/// y = ln(A h^p + f): parameters ln A, p, ln f. `near` starts the search; else it starts from every split of the points
/// into a slope and a plateau.
LeastSquares power_and_floor(const LogSeries& series, const Eigen::VectorXd* near = nullptr);

/// y = ln(A h^p + B h^q) with B of this sign: parameters ln A, p, ln |B/A|, ln(q - p); 0.2 < q - p < 6.
LeastSquares two_powers(const LogSeries& series, double sign, const Eigen::VectorXd* near = nullptr);

}  // namespace ordo::studies

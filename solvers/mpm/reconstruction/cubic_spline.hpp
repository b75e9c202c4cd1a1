#pragma once
// The not-a-knot cubic spline through given points.
#include <span>
#include <vector>

namespace ordo::solvers::mpm {

/// Twice continuously differentiable, piecewise cubic, through (x_k, f_k), x rising, at least 4 of them; the third
/// derivative does not jump at the second and the last but one. Beyond the ends the outer cubics go on.
/// accurate  h^4 for smooth f      source [DeBoor2001], chapter IV
class CubicSpline {
public:
    void fit(std::span<const double> x, std::span<const double> f);
    double operator()(double at) const;

private:
    std::vector<double> x_, f_, slope_;
    std::vector<double> lower_, main_, upper_;  ///< scratch of the tridiagonal system
    mutable std::size_t piece_ = 0;             ///< where the last value was
};

}  // namespace ordo::solvers::mpm

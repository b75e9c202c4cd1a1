#include "solvers/mpm/reconstruction/cubic_spline.hpp"

#include <algorithm>

namespace ordo::solvers::mpm {

/// For the slopes s at the points: continuity of the second derivative inside,
///   s_{k-1} d_k + 2 s_k (d_{k-1} + d_k) + s_{k+1} d_{k-1} = 3 (d_k D_{k-1} + d_{k-1} D_k),
/// with d_k = x_{k+1} - x_k and D_k the difference quotient; at the ends the condition eliminated once.
void CubicSpline::fit(std::span<const double> x, std::span<const double> f) {
    x_.assign(x.begin(), x.end());
    f_.assign(f.begin(), f.end());
    const std::size_t n = x_.size();
    slope_.resize(n);
    lower_.assign(n, 0);
    main_.assign(n, 0);
    upper_.assign(n, 0);
    const auto d = [&](std::size_t k) { return x_[k + 1] - x_[k]; };
    const auto D = [&](std::size_t k) { return (f_[k + 1] - f_[k]) / d(k); };
    for (std::size_t k = 1; k + 1 < n; ++k) {
        lower_[k] = d(k);
        main_[k] = 2 * (d(k - 1) + d(k));
        upper_[k] = d(k - 1);
        slope_[k] = 3 * (d(k) * D(k - 1) + d(k - 1) * D(k));
    }
    const auto end = [](double near, double next, double D_near, double D_next) {
        const double both = near + next;
        return ((near + 2 * both) * next * D_near + near * near * D_next) / both;
    };
    main_[0] = d(1);
    upper_[0] = d(0) + d(1);
    slope_[0] = end(d(0), d(1), D(0), D(1));
    main_[n - 1] = d(n - 3);
    lower_[n - 1] = d(n - 3) + d(n - 2);
    slope_[n - 1] = end(d(n - 2), d(n - 3), D(n - 2), D(n - 3));
    for (std::size_t k = 1; k < n; ++k) {
        const double factor = lower_[k] / main_[k - 1];
        main_[k] -= factor * upper_[k - 1];
        slope_[k] -= factor * slope_[k - 1];
    }
    slope_[n - 1] /= main_[n - 1];
    for (std::size_t k = n - 1; k-- > 0;) slope_[k] = (slope_[k] - upper_[k] * slope_[k + 1]) / main_[k];
    piece_ = 0;
}

double CubicSpline::operator()(double at) const {
    while (piece_ + 2 < x_.size() && at > x_[piece_ + 1]) ++piece_;
    while (piece_ > 0 && at < x_[piece_]) --piece_;
    const double d = x_[piece_ + 1] - x_[piece_];
    const double r = (at - x_[piece_]) / d;
    const double rise = f_[piece_ + 1] - f_[piece_];
    const double a = d * slope_[piece_] - rise;
    const double b = rise - d * slope_[piece_ + 1];
    return f_[piece_] + r * rise + r * (1 - r) * ((1 - r) * a + r * b);
}

}  // namespace ordo::solvers::mpm

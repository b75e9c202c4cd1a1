#include "solvers/mpm/reconstruction/least_squares.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace ordo::solvers::mpm {
namespace {

/// Cubic spline weight of the distance in radii, as [SulskyGong2016].
double kernel(double r) {
    if (r >= 1) return 0;
    return r <= 0.5 ? 2.0 / 3 + 4 * r * r * (r - 1) : 4.0 / 3 * (1 - r) * (1 - r) * (1 - r);
}

}  // namespace

bool MovingLeastSquares::fit(double at, double radius, std::size_t fewest) {
    if (x_.size() < fewest) return false;
    while (first_ > 0 && x_[first_ - 1] > at - radius) --first_;
    while (first_ < x_.size() && x_[first_] <= at - radius) ++first_;
    last_ = std::max(last_, first_);
    while (last_ < x_.size() && x_[last_] < at + radius) ++last_;
    while (last_ > first_ && x_[last_ - 1] >= at + radius) --last_;
    while (last_ - first_ < fewest) {
        const bool left = first_ > 0 && (last_ == x_.size() || at - x_[first_ - 1] <= x_[last_] - at);
        if (left) --first_;
        else ++last_;
        radius = std::max(radius, 1.2 * std::abs(x_[left ? first_ : last_ - 1] - at));
    }
    switch (degree_) {
        case 1: return solve<1>(at, radius);
        case 2: return solve<2>(at, radius);
        case 3: return solve<3>(at, radius);
        case 4: return solve<4>(at, radius);
        case 5: return solve<5>(at, radius);
        default: return solve<highest_degree>(at, radius);
    }
}

/// phi_p = w_p c . b_p with c = G^-1 b(at), G = sum w b b^T and b the powers of the scaled distance.
template <int degree>
bool MovingLeastSquares::solve(double at, double radius) {
    constexpr int size = degree + 1;
    using Vector = Eigen::Matrix<double, size, 1>;
    using Matrix = Eigen::Matrix<double, size, size>;
    const auto powers = [](double s) {
        Vector b;
        b[0] = 1;
        for (int k = 1; k < size; ++k) b[k] = s * b[k - 1];
        return b;
    };
    // G is made of the sums of the powers up to 2 degree: a Hankel matrix.
    std::array<double, 2 * degree + 1> sums{};
    phi_.resize(last_ - first_);
    for (std::size_t p = first_; p < last_; ++p) {
        const double s = (x_[p] - at) / radius;
        double term = kernel(std::abs(s));
        phi_[p - first_] = term;
        for (double& sum : sums) {
            sum += term;
            term *= s;
        }
    }
    Matrix moments;
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) moments(i, j) = sums[static_cast<std::size_t>(i + j)];
    }
    const Eigen::LLT<Matrix> factors(moments);
    if (factors.info() != Eigen::Success) return false;
    const Vector c = factors.solve(Vector::Unit(0));
    for (std::size_t p = first_; p < last_; ++p) phi_[p - first_] *= c.dot(powers((x_[p] - at) / radius));
    return true;
}

}  // namespace ordo::solvers::mpm

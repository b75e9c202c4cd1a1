#include "studies/order/value_fit.hpp"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

namespace ordo::studies {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double lowest = -4, highest = 12;

VectorXd weights_of(const VectorXd& h, Weights weights) {
    if (weights == Weights::equal) return VectorXd::Ones(h.size());
    const VectorXd inverse = h.cwiseInverse();
    return inverse / inverse.mean();
}

/// (x^p - 1) / p, which is ln x at p = 0: with it a fit does not degenerate there.
double bent(double x, double p) { return p == 0 ? std::log(x) : std::expm1(p * std::log(x)) / p; }

/// Of n values by `columns` with weights.
struct Linear {
    VectorXd coefficients, fitted;
    double squares;

    Linear(const MatrixXd& columns, const VectorXd& values, const VectorXd& weights) {
        const VectorXd roots = weights.cwiseSqrt();
        coefficients = (roots.asDiagonal() * columns).colPivHouseholderQr().solve(roots.cwiseProduct(values));
        fitted = columns * coefficients;
        squares = weights.dot((values - fitted).cwiseAbs2());
    }
};

MatrixXd power_columns(const VectorXd& x, double p) {
    MatrixXd columns(x.size(), 2);
    columns << VectorXd::Ones(x.size()), x.unaryExpr([p](double each) { return bent(each, p); });
    return columns;
}

double spread_of(const Linear& fit, Index parameters) {
    return std::sqrt(fit.squares / static_cast<double>(fit.fitted.size() - parameters));
}

}  // namespace

ValueFit fit_power(const VectorXd& h, const VectorXd& values, Weights weights) {
    const VectorXd x = h / h.maxCoeff();
    const VectorXd w = weights_of(h, weights);
    const auto squares = [&](double p) { return Linear(power_columns(x, p), values, w).squares; };
    double best = lowest;
    for (double p = lowest; p <= highest; p += 0.25) {
        if (squares(p) < squares(best)) best = p;
    }
    const double p = boost::math::tools::brent_find_minima(squares, best - 0.25, best + 0.25, 40).first;
    const Linear fit(power_columns(x, p), values, w);
    const double constant = fit.coefficients(1) / p;
    const double limit = p > 0 ? fit.coefficients(0) - constant : std::numeric_limits<double>::quiet_NaN();
    return {"h^p", p, limit, constant, spread_of(fit, 3), fit.fitted};
}

ValueFit fit_fixed(const VectorXd& h, const VectorXd& values, bool first, bool second, Weights weights) {
    const VectorXd x = h / h.maxCoeff();
    MatrixXd columns(h.size(), 1 + first + second);
    columns.col(0).setOnes();
    if (first) columns.col(1) = x;
    if (second) columns.rightCols(1) = x.cwiseAbs2();
    const Linear fit(columns, values, weights_of(h, weights));
    const bool both = first && second;
    const double order = both ? std::numeric_limits<double>::quiet_NaN() : first ? 1 : 2;
    return {both ? "h + h^2" : first ? "h" : "h^2", order,     fit.coefficients(0), fit.coefficients(1),
            spread_of(fit, columns.cols()),         fit.fitted};
}

double error_of_order(const VectorXd& h, const ValueFit& fit) {
    const VectorXd x = h / h.maxCoeff();
    const double p = fit.order;
    MatrixXd jacobian(h.size(), 3);
    jacobian << power_columns(x, p), x.unaryExpr([p](double each) {
        const double log = std::log(each);
        return p == 0 ? log * log / 2 : (std::pow(each, p) * log - bent(each, p)) / p;
    });
    jacobian.col(2) *= fit.constant * p;
    const MatrixXd covariance = (jacobian.transpose() * jacobian).colPivHouseholderQr().inverse();
    return fit.spread * std::sqrt(covariance(2, 2));
}

}  // namespace ordo::studies

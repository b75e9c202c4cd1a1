#include "studies/order/models.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ordo::studies {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_steps = 80;
constexpr int most_trials = 12;
constexpr Index most_starts = 12;  // of splits into two regimes

double squares_of(const VectorXd& residuals) {
    const double least = static_cast<double>(residuals.size()) * rounding * rounding;
    return std::max(residuals.squaredNorm(), least);
}

/// Levenberg-Marquardt from `start`. model(parameters, x, gradient) returns y, NaN outside its range.
template <class Model>
LeastSquares least_squares(const LogSeries& series, VectorXd start, Model model) {
    const Index n = series.size();
    const Index k = start.size();
    MatrixXd jacobian(n, k);
    VectorXd gradient(k);
    const auto residuals_at = [&](const VectorXd& at) {
        VectorXd residuals(n);
        for (Index i = 0; i < n; ++i) {
            residuals[i] = series.y[i] - model(at, series.x[i], gradient);
            jacobian.row(i) = gradient.transpose();
        }
        return residuals;
    };
    LeastSquares fit;
    fit.parameters = std::move(start);
    fit.residuals = residuals_at(fit.parameters);
    double damping = 1e-3;
    double gain = std::numeric_limits<double>::infinity();
    for (int step = 0; step < most_steps && fit.residuals.allFinite(); ++step) {
        const double before = fit.residuals.squaredNorm();
        if (gain <= 1e-10 * before + 1e-26) break;
        const MatrixXd normal = jacobian.transpose() * jacobian;
        const VectorXd downhill = jacobian.transpose() * fit.residuals;
        gain = 0;
        for (int trial = 0; trial < most_trials && gain == 0; ++trial) {
            MatrixXd damped = normal;
            damped.diagonal() += damping * (normal.diagonal().array() + 1e-12).matrix();
            const VectorXd next = fit.parameters + damped.ldlt().solve(downhill);
            VectorXd residuals = residuals_at(next);
            damping *= 4;
            if (!(residuals.squaredNorm() < before)) continue;
            gain = before - residuals.squaredNorm();
            damping = std::max(damping / 20, 1e-12);
            fit.parameters = next;
            fit.residuals = std::move(residuals);
        }
    }
    residuals_at(fit.parameters);  // for the Jacobian at the end
    const Eigen::FullPivLU<MatrixXd> normal(jacobian.transpose() * jacobian);
    if (!fit.residuals.allFinite() || !normal.isInvertible()) return fit;
    fit.squares = squares_of(fit.residuals);
    fit.inverse = normal.inverse();
    fit.found = fit.inverse.allFinite() && (fit.inverse.diagonal().array() > 0).all();
    return fit;
}

double floor_model(const VectorXd& at, double x, VectorXd& gradient) {
    const double slope = at[0] + at[1] * x;
    const double top = std::max(slope, at[2]);
    const double y = top + std::log(std::exp(slope - top) + std::exp(at[2] - top));
    const double share = std::exp(slope - y);
    gradient << share, share * x, 1 - share;
    return y;
}

/// y = ln A + p x + ln(1 + sign e^(b + (q - p) x)); two terms of unlike sign must not cancel.
struct TwoPowersModel {
    double sign;

    double operator()(const VectorXd& at, double x, VectorXd& gradient) const {
        const double difference = std::exp(at[3]);
        const double ratio = sign * std::exp(at[2] + difference * x);
        const double share = ratio / (1 + ratio);
        gradient << 1, x, share, share * difference * x;
        return 1 + ratio > 1e-3 ? at[0] + at[1] * x + std::log1p(ratio) : std::nan("");
    }
};

void keep_better(LeastSquares& best, LeastSquares other) {
    if (other.found && (!best.found || other.squares < best.squares)) best = std::move(other);
}

}  // namespace

double LeastSquares::variance() const {
    return squares / static_cast<double>(std::max<Index>(1, residuals.size() - parameters.size()));
}

double LeastSquares::deviation(Index parameter) const { return std::sqrt(variance() * inverse(parameter, parameter)); }

LeastSquares polynomial(const LogSeries& series, int degree) {
    MatrixXd powers(series.size(), degree + 1);
    powers.col(0).setOnes();
    for (int k = 1; k <= degree; ++k) powers.col(k) = powers.col(k - 1).cwiseProduct(series.x);
    LeastSquares fit;
    fit.parameters = powers.colPivHouseholderQr().solve(series.y);
    fit.residuals = series.y - powers * fit.parameters;
    fit.squares = squares_of(fit.residuals);
    fit.inverse = (powers.transpose() * powers).inverse();
    fit.found = true;
    return fit;
}

LeastSquares power_and_floor(const LogSeries& series, const VectorXd* near) {
    if (near != nullptr) return least_squares(series, *near, floor_model);
    LeastSquares best;
    const Index stride = 1 + series.size() / most_starts;
    for (Index split = 1; split + 1 < series.size(); split += stride) {
        const VectorXd line = polynomial(series.coarsest(split + 1), 1).parameters;
        const double plateau = series.y.tail(series.size() - split).mean();
        keep_better(best,
                    least_squares(series, Eigen::Vector3d(line[0], std::max(line[1], 0.3), plateau), floor_model));
    }
    return best;
}

LeastSquares two_powers(const LogSeries& series, double sign, const VectorXd* near) {
    if (near != nullptr) return least_squares(series, *near, TwoPowersModel{sign});
    LeastSquares best;
    const Index stride = 1 + series.size() / most_starts;
    for (Index split = 2; split <= series.size() - 2; split += stride) {
        const VectorXd line = polynomial(series.finest(series.size() - split), 1).parameters;
        for (const double difference : {0.7, 1.6}) {
            const double ratio = sign > 0 ? -difference * series.x[split] : -difference * series.x[0] - 0.5;
            auto fit = least_squares(series, Eigen::Vector4d(line[0], line[1], ratio, std::log(difference)),
                                     TwoPowersModel{sign});
            if (!fit.found) continue;
            const double found = std::exp(fit.parameters[3]);
            if (found > 0.2 && found < 6) keep_better(best, std::move(fit));
        }
    }
    return best;
}

}  // namespace ordo::studies

#include "studies/order/joint_model.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/NonLinearOptimization>
#include <vector>

#include "studies/order/distributions.hpp"

namespace ordo::studies {
namespace {

using Eigen::Index;
using Eigen::MatrixX3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int floor_part = 2;
constexpr double significant = 0.01;
constexpr double round_off = 1e-10;  ///< of a logarithm; smaller residuals say nothing

/// What Eigen's Levenberg-Marquardt (MINPACK's lmder) asks for.
struct Residuals {
    const JointLogs& logs;
    Parts3 parts;

    Index inputs() const { return parameters_of(parts); }
    Index values() const { return logs.y.size(); }
    int operator()(const VectorXd& theta, VectorXd& residuals) const {
        JointModel{parts, theta}.shares(logs.x, &residuals);
        residuals -= logs.y;
        return residuals.allFinite() ? 0 : -1;
    }
    int df(const VectorXd& theta, MatrixXd& jacobian) const {
        jacobian = JointModel{parts, theta}.jacobian(logs.x);
        return 0;
    }
};

/// Parameters with these orders, their amplitudes by linear least squares of the relative error; a part whose amplitude
/// is not positive begins at a hundredth of the error.
VectorXd start_at(const JointLogs& logs, const Parts3& parts, const std::array<double, 3>& orders) {
    std::vector<int> present;
    for (int part = 0; part < 3; ++part) {
        if (parts(part)) present.push_back(part);
    }
    MatrixXd relative(logs.y.size(), static_cast<Index>(present.size()));
    for (Index k = 0; k < relative.cols(); ++k) {
        const int part = present[static_cast<std::size_t>(k)];
        relative.col(k) = (orders[static_cast<std::size_t>(part)] * logs.x.col(part) - logs.y).array().exp();
    }
    const VectorXd weights = relative.colPivHouseholderQr().solve(VectorXd::Ones(logs.y.size()));
    VectorXd theta(parameters_of(parts));
    for (Index k = 0, at = 0; k < relative.cols(); ++k) {
        const int part = present[static_cast<std::size_t>(k)];
        theta(at++) = std::log(std::max(weights(k), 0.01 / relative.col(k).maxCoeff()));
        if (part != floor_part) theta(at++) = orders[static_cast<std::size_t>(part)];
    }
    return theta;
}

double akaike(const JointModel& model, Index points) {
    const double n = static_cast<double>(points);
    const double k = static_cast<double>(model.theta.size()) + 1;  // the variance is one more
    if (n - k - 1 <= 0) return std::numeric_limits<double>::infinity();
    const double squares = std::max(model.squares, n * round_off * round_off);
    return n * std::log(squares / n) + 2 * k + 2 * k * (k + 1) / (n - k - 1);
}

/// The largest part at two points: a floor that fewer show may as well be a bend.
bool floor_shows(const JointModel& model, const JointLogs& logs) {
    if (!model.parts(floor_part)) return true;
    const MatrixX3d shares = model.shares(logs.x);
    return (shares.col(floor_part).array() >= shares.rowwise().maxCoeff().array()).count() >= 2;
}

bool asked_for(const JointModel& richer, const JointModel& model, const JointLogs& logs) {
    const Index n = logs.y.size();
    if (!(akaike(richer, n) < akaike(model, n)) || !floor_shows(richer, logs)) return false;
    const double added = static_cast<double>(richer.theta.size() - model.theta.size());
    return chance_of(model.squares, richer.squares, added, static_cast<double>(n - richer.theta.size())) < significant;
}

}  // namespace

Index parameters_of(const Parts3& parts) { return 2 * parts(0) + 2 * parts(1) + parts(floor_part); }

Index JointModel::amplitude(int part) const { return part == 0 ? 0 : 2 * parts(0) + (part == 1 ? 0 : 2 * parts(1)); }

MatrixX3d JointModel::shares(const MatrixX3d& x, VectorXd* value) const {
    MatrixX3d logs = MatrixX3d::Constant(x.rows(), 3, -std::numeric_limits<double>::infinity());
    for (int part = 0; part < 3; ++part) {
        if (!parts(part)) continue;
        const Index at = amplitude(part);
        const double order = part == floor_part ? 0 : theta(at + 1);
        logs.col(part) = (order * x.col(part)).array() + theta(at);
    }
    const VectorXd largest = logs.rowwise().maxCoeff();
    MatrixX3d shares = (logs.colwise() - largest).array().exp();
    const VectorXd sums = shares.rowwise().sum();
    if (value != nullptr) *value = largest.array() + sums.array().log();
    return shares.array().colwise() / sums.array();
}

MatrixXd JointModel::jacobian(const MatrixX3d& x) const {
    const MatrixX3d weights = shares(x);
    MatrixXd derivatives(x.rows(), theta.size());
    for (int part = 0; part < 3; ++part) {
        if (!parts(part)) continue;
        const Index at = amplitude(part);
        derivatives.col(at) = weights.col(part);
        if (part != floor_part) derivatives.col(at + 1) = weights.col(part).cwiseProduct(x.col(part));
    }
    return derivatives;
}

std::optional<JointModel> fitted_model(const JointLogs& logs, const Parts3& parts) {
    if (logs.y.size() <= parameters_of(parts)) return {};
    std::optional<JointModel> best;
    for (const double p : {0.5, 1.0, 2.0, 4.0}) {
        for (const double q : {0.5, 1.0, 2.0, 4.0}) {
            JointModel model{parts, start_at(logs, parts, {p, q, 0})};
            Residuals residuals{logs, parts};
            Eigen::LevenbergMarquardt search(residuals);
            search.minimize(model.theta);
            VectorXd value;
            model.shares(logs.x, &value);
            model.squares = (value - logs.y).squaredNorm();
            if (!best || model.squares < best->squares) best = model;
            if (!parts(1)) break;
        }
        if (!parts(0)) break;
    }
    return best;
}

JointModel selected_model(const JointLogs& logs) {
    std::vector<Parts3> all;
    for (const int bits : {4, 1, 2, 5, 6, 3, 7}) all.emplace_back(Parts3{(bits & 1) != 0, (bits & 2) != 0, bits > 3});
    JointModel selected = fitted_model(logs, all.front()).value();
    std::optional<JointModel> best_of_size;
    for (std::size_t k = 1; k < all.size(); ++k) {
        auto model = fitted_model(logs, all[k]);
        if (model && (!best_of_size || model->squares < best_of_size->squares)) best_of_size = std::move(model);
        const bool last_of_size = k + 1 == all.size() || parameters_of(all[k + 1]) > parameters_of(all[k]);
        if (!last_of_size) continue;
        if (best_of_size && asked_for(*best_of_size, selected, logs)) selected = *best_of_size;
        best_of_size.reset();
    }
    return selected;
}

double chance_of(double squares, double fewer, double added, double freedom) {
    const double least = (freedom + added) * round_off * round_off;
    const double ratio = (std::max(squares, least) / std::max(fewer, least) - 1) * freedom / added;
    if (!(ratio > 0)) return 1;
    return fisher_chance(added, freedom, ratio);
}

}  // namespace ordo::studies

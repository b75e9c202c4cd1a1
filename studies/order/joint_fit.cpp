#include "studies/order/joint_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "studies/order/distributions.hpp"
#include "studies/order/joint_model.hpp"
#include "studies/order/joint_points.hpp"

namespace ordo::studies {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double widest = 0.5;        ///< half-width of an order that is still one
constexpr double most_scatter = 0.5;  ///< of ln(error)
constexpr double most_drift = 0.2;    ///< of an order over the grid
constexpr double standstill = 0.1;    ///< an order that is none
constexpr double significant = 0.01;

const char* error_of(int part) { return part == 0 ? "space error" : "time error"; }

JointLogs logs_of(const std::vector<JointPoint>& points) {
    const auto n = static_cast<Index>(points.size());
    JointLogs logs{Eigen::MatrixX3d::Zero(n, 3), VectorXd(n)};
    for (Index i = 0; i < n; ++i) {
        const auto& point = points[static_cast<std::size_t>(i)];
        logs.x.row(i) << std::log(point.h), std::log(point.dt), 0;
        logs.y(i) = std::log(point.error);
    }
    logs.centre = logs.x.colwise().mean();
    logs.x.rowwise() -= logs.centre.transpose();
    return logs;
}

double student(double freedom) { return student_quantile(freedom, 0.975); }

/// (J^T J)^-1, the covariance of the parameters in units of the residuals' variance.
MatrixXd covariance_of(const MatrixXd& jacobian) {
    return (jacobian.transpose() * jacobian).colPivHouseholderQr().inverse();
}

/// More than half of the error at two values of its own abscissa.
bool is_known(const JointModel& model, const std::vector<JointPoint>& points, const Eigen::MatrixX3d& shares,
              int part) {
    if (!model.parts(part)) return false;
    std::set<double> levels;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (shares(static_cast<Index>(i), part) > 0.5) levels.insert(abscissa_of(points[i], part));
    }
    return levels.size() >= 2;
}

/// The model of the points with what is needed to judge it.
struct Judged {
    const std::vector<JointPoint>& points;
    JointLogs logs;
    JointModel model;
    Eigen::MatrixX3d shares;
    MatrixXd covariance;
    double freedom;
    double variance;

    explicit Judged(const std::vector<JointPoint>& given)
        : points(given),
          logs(logs_of(given)),
          model(selected_model(logs)),
          shares(model.shares(logs.x)),
          covariance(covariance_of(model.jacobian(logs.x))),
          freedom(static_cast<double>(logs.y.size() - model.theta.size())),
          variance(model.squares / freedom) {}

    bool knows(int part) const { return is_known(model, points, shares, part); }

    /// Of `weights` times theta.
    Estimate estimate(const VectorXd& weights) const {
        const double value = weights.dot(model.theta);
        const double width = student(freedom) * std::sqrt(variance * weights.dot(covariance * weights));
        return {value, value - width, value + width};
    }
    VectorXd unit(Index place) const { return VectorXd::Unit(model.theta.size(), place); }
    Estimate order(int part) const { return estimate(unit(model.amplitude(part) + 1)); }
    /// The amplitude is given at the centre; this is it at h = 1 or dt = 1.
    Estimate coefficient(int part) const {
        VectorXd weights = unit(model.amplitude(part));
        if (part < 2) weights -= logs.centre(part) * unit(model.amplitude(part) + 1);
        const Estimate log = estimate(weights);
        return {std::exp(log.value), std::exp(log.low), std::exp(log.high)};
    }
};

/// How far an order drifts over the points that its part dominates, where an F-test sees that it does; else 0. One
/// Gauss-Newton step with a term in ln(h)^2 tells.
double drift_of(const Judged& fit, int part) {
    if (!fit.knows(part) || fit.freedom < 2) return 0;
    const VectorXd x = fit.logs.x.col(part);
    MatrixXd columns(x.size(), fit.model.theta.size() + 1);
    columns << fit.model.jacobian(fit.logs.x), fit.shares.col(part).cwiseProduct(x.cwiseAbs2());
    VectorXd value;
    fit.model.shares(fit.logs.x, &value);
    const VectorXd residuals = fit.logs.y - value;
    const VectorXd step = columns.colPivHouseholderQr().solve(residuals);
    const double squares = (residuals - columns * step).squaredNorm();
    if (chance_of(fit.model.squares, squares, 1, fit.freedom - 1) >= significant) return 0;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (Index i = 0; i < x.size(); ++i) {
        if (!(fit.shares(i, part) > 0.5)) continue;
        low = std::min(low, x(i));
        high = std::max(high, x(i));
    }
    return std::abs(2 * step(step.size() - 1) * (high - low));
}

/// The levels with one more on each side, in the ratio of the two that lie there.
std::vector<double> extended(const std::set<double>& levels) {
    std::vector<double> all(levels.begin(), levels.end());
    const double finer = all[0] * all[0] / all[1];
    const double coarser = all.back() * all.back() / all[all.size() - 2];
    all.insert(all.begin(), finer);
    all.push_back(coarser);
    return all;
}

/// D-optimal for the two orders: of the runs one level around the grid, or missing in it, the one that leaves the
/// smallest determinant of their covariance.
NextRun best_next(const Judged& fit, const std::vector<double>& widths, const std::vector<double>& steps) {
    const MatrixXd jacobian = fit.model.jacobian(fit.logs.x);
    const Index p = fit.model.amplitude(0) + 1, q = fit.model.amplitude(1) + 1;
    NextRun best;
    double least = std::numeric_limits<double>::infinity();
    for (const double h : widths) {
        for (const double dt : steps) {
            const auto there = [&](const JointPoint& point) { return point.h == h && point.dt == dt; };
            if (std::ranges::any_of(fit.points, there)) continue;
            Eigen::MatrixX3d place(1, 3);
            place << std::log(h) - fit.logs.centre(0), std::log(dt) - fit.logs.centre(1), 0;
            MatrixXd more(jacobian.rows() + 1, jacobian.cols());
            more << jacobian, fit.model.jacobian(place);
            const MatrixXd covariance = fit.variance * covariance_of(more);
            const double determinant = covariance(p, p) * covariance(q, q) - covariance(p, q) * covariance(q, p);
            if (!(determinant < least)) continue;
            least = determinant;
            const double quantile = student(fit.freedom + 1);
            best = {h, dt, quantile * std::sqrt(covariance(p, p)), quantile * std::sqrt(covariance(q, q)),
                    "shrinks the intervals of both orders most"};
        }
    }
    return best;
}

/// The three coarsest and the three finest: what lies between them teaches less.
std::vector<double> ends_of(std::vector<double> levels) {
    if (levels.size() > 6) levels.erase(levels.begin() + 3, levels.end() - 3);
    return levels;
}

/// Where an error does not show, it is largest at the coarsest level of its own and the finest of the other.
NextRun next_of(const Judged& fit) {
    const auto widths = ends_of(extended(levels_of(fit.points, 0)));
    const auto steps = ends_of(extended(levels_of(fit.points, 1)));
    const bool space = fit.knows(0), time = fit.knows(1);
    NextRun next;
    if (space && time) return best_next(fit, widths, steps);
    next.h = space ? widths.front() : widths.back();
    next.dt = time ? steps.front() : steps.back();
    if (!space && !time) next.why = "both errors are largest there, above the floor";
    else next.why = std::string("the ") + error_of(space ? 1 : 0) + " shows most there";
    return next;
}

std::string unknown_words(const Judged& fit, int part) {
    const auto count = (fit.shares.col(part).array() > 0.5).count();
    return fmt::format(
        "the {} is more than half of the error at {} of {} points, not at two values of {}: its order "
        "is unknown",
        error_of(part), count, fit.points.size(), name_of(part));
}

/// Verdict and reason, from the worst down.
std::pair<Convergence, std::string> verdict_of(const Judged& fit, const JointFit& found) {
    const bool known[] = {fit.knows(0), fit.knows(1)};
    const Estimate orders[] = {found.p, found.q};
    if (found.scatter > most_scatter)
        return {Convergence::inconclusive,
                fmt::format("errors scatter by a factor of {:.2g} around the fit", std::exp(found.scatter))};
    if (!known[0] && !known[1] && fit.model.parts(2))
        return {Convergence::at_floor, "neither h nor dt moves the error: it is at its floor"};
    for (const int part : {0, 1}) {
        if (known[part] && orders[part].high < 0)
            return {Convergence::diverges, fmt::format("errors grow as {} is refined", name_of(part))};
    }
    for (const int part : {0, 1}) {
        if (const double drift = drift_of(fit, part); drift > most_drift)
            return {Convergence::pre_asymptotic, fmt::format("the order in {} changes by {:.2f} over the grid: coarse "
                                                             "points, or a floor, bend it",
                                                             name_of(part), drift)};
    }
    for (const int part : {0, 1}) {
        if (known[part] && orders[part].low > -standstill && orders[part].high < standstill)
            return {Convergence::stalled, fmt::format("the error hardly moves with {}", name_of(part))};
    }
    for (const int part : {0, 1}) {
        if (!known[part]) return {Convergence::inconclusive, unknown_words(fit, part)};
        const double half = (orders[part].high - orders[part].low) / 2;
        if (!(half <= widest))
            return {Convergence::inconclusive, fmt::format("the order in {} is known to +- {:.2g} only, not to +- {}",
                                                           name_of(part), half, widest)};
        if (!(orders[part].low > 0))
            return {Convergence::inconclusive, fmt::format("the order in {} may be zero", name_of(part))};
    }
    return {Convergence::converges, ""};
}

/// The model does not hold over the grid, so that its covariance says nothing.
void withdraw_intervals(JointFit& found) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    for (Estimate* each : {&found.p, &found.q, &found.A, &found.B, &found.f}) {
        if (!std::isnan(each->value)) *each = {each->value, -inf, inf};
    }
}

}  // namespace

std::string text_of(ErrorPart part) {
    return part == ErrorPart::space ? "space" : part == ErrorPart::time ? "time" : "floor";
}

ErrorPart Shares::dominant() const {
    if (space >= time && space >= floor) return ErrorPart::space;
    return time >= floor ? ErrorPart::time : ErrorPart::floor;
}

JointFit fit_joint(const std::vector<JointPoint>& points) {
    JointFit found;
    if (found.reason = invalid_point(points); !found.reason.empty()) {
        found.verdict = Convergence::invalid;
        return found;
    }
    if (found.reason = too_few(points); !found.reason.empty()) return found;
    const Judged fit(points);
    if (fit.knows(0)) found.p = fit.order(0);
    if (fit.knows(1)) found.q = fit.order(1);
    if (fit.knows(0)) found.A = fit.coefficient(0);
    if (fit.knows(1)) found.B = fit.coefficient(1);
    if (fit.model.parts(2)) found.f = fit.coefficient(2);
    found.scatter = std::sqrt(fit.variance);
    for (Index i = 0; i < fit.shares.rows(); ++i)
        found.shares.push_back({fit.shares(i, 0), fit.shares(i, 1), fit.shares(i, 2)});
    std::tie(found.verdict, found.reason) = verdict_of(fit, found);
    if (found.verdict == Convergence::pre_asymptotic || found.scatter > most_scatter) withdraw_intervals(found);
    found.next = next_of(fit);
    return found;
}

}  // namespace ordo::studies

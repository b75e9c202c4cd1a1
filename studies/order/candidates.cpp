#include "studies/order/candidates.hpp"

#include <algorithm>
#include <cmath>

#include "studies/order/bootstrap.hpp"
#include "studies/order/distributions.hpp"

namespace ordo::studies {
namespace {

using Eigen::Index;

// Levels of the tests and quantiles. The first two are chosen together so that over the strata of
// tests/studies/order/random_series.hpp the intervals of pure power laws cover the truth in 95 % of the cases.
constexpr double end_quantile = 0.92;    // one-sided, of the slope at an end of the window
constexpr double unseen_levels = 1;      // how many more intervals the bend may go on for
constexpr double model_quantile = 0.98;  // one-sided, of the order of a model with three or four parameters
constexpr double bend_level = 0.1;       // a bend is seen below this probability of chance
constexpr double foretold_line = 0.98;   // quantile that the finest two points may reach beside a line
constexpr double foretold_floor = 0.95;  // and the finest three beside a floor

/// Corrected Akaike criterion of a fit with so many parameters, the variance among them; infinite with too few points.
double akaike_of(const LeastSquares& fit, Index points, Index parameters, Index dropped) {
    const double k = static_cast<double>(parameters + 1 + dropped);
    const double n = static_cast<double>(points);
    if (n - k < 2) return std::numeric_limits<double>::infinity();
    return n * std::log(fit.squares / n) + 2 * k + 2 * k * (k + 1) / (n - k - 1);
}

/// Slope of a parabola through the window at x, and its deviation under the scatter about the line.
struct EndSlope {
    double slope, deviation;
};

EndSlope end_slope(const LeastSquares& parabola, double variance, double x) {
    const Eigen::Vector3d derivative(0, 1, 2 * x);
    return {derivative.dot(parabola.parameters), std::sqrt(variance * derivative.dot(parabola.inverse * derivative))};
}

/// The interval of a line over four points or more, and whether its residuals bend.
void bear_bend(Candidate& candidate, const LogSeries& window, const LeastSquares& line) {
    const auto points = static_cast<double>(window.size());
    const LeastSquares parabola = polynomial(window, 2);
    const double bend = parabola.parameters[2] / parabola.deviation(2);
    candidate.curved = student_chance(points - 3, bend) < bend_level;
    const EndSlope fine = end_slope(parabola, line.variance(), window.x.tail(1)[0]);
    const EndSlope coarse = end_slope(parabola, line.variance(), window.x[0]);
    const double t = student_quantile(points - 2, end_quantile);
    const double further = unseen_levels * std::abs(coarse.slope - fine.slope) / (points - 1);
    const bool falls = coarse.slope > fine.slope;  // with refinement: a second power, or a floor
    candidate.low = std::min(candidate.order, fine.slope - t * fine.deviation - (falls ? further : 0));
    candidate.high = std::max({candidate.order, fine.slope + t * fine.deviation + (falls ? 0 : further),
                               coarse.slope + t * coarse.deviation + (falls ? further : 0)});
}

/// Whether the two finest points lie where a line through the others foretells them.
bool finest_two_agree(const LogSeries& window, const LeastSquares& line) {
    const auto points = static_cast<double>(window.size());
    if (points < 6) return true;
    const LeastSquares others = polynomial(window.coarsest(window.size() - 2), 1);
    const double excess = std::max(line.squares - others.squares, 0.0) / 2;
    return excess / (others.squares / (points - 4)) < fisher_quantile(2, points - 4, foretold_line);
}

/// Whether the three finest points scatter about the model no more than the others.
bool finest_three_agree(const LeastSquares& fit) {
    const auto points = static_cast<double>(fit.residuals.size());
    if (points < 7) return true;
    const double fine = fit.residuals.tail(3).squaredNorm() / 2;
    const double others =
        std::max(fit.residuals.head(fit.residuals.size() - 3).squaredNorm(), points * rounding * rounding);
    const Index last = fit.residuals.size() - 1;
    const double turn = fit.residuals[last] - fit.residuals[last - 1];  // above zero where errors grow again
    const double scatter = std::sqrt(others / (points - 5));
    return fine < fisher_quantile(2, points - 5, foretold_floor) * scatter * scatter &&
           turn < student_quantile(points - 5, foretold_floor) * scatter;
}

/// Least and largest neighbour order of e - f over the points where A h^p is the larger part.
void take_neighbours(Candidate& candidate, const LogSeries& window, const Eigen::VectorXd& parameters) {
    double least = std::numeric_limits<double>::infinity();
    double largest = -least;
    const double floor = std::exp(parameters[2]);
    for (Index i = 1; i < window.size() && parameters[0] + parameters[1] * window.x[i] > parameters[2]; ++i) {
        const double coarse = std::exp(window.y[i - 1]) - floor;
        const double fine = std::exp(window.y[i]) - floor;
        if (!(coarse > 0 && fine > 0)) continue;
        const double order = std::log(coarse / fine) / (window.x[i - 1] - window.x[i]);
        least = std::min(least, order);
        largest = std::max(largest, order);
    }
    if (least > largest) least = largest = candidate.order;
    candidate.least_neighbour = least;
    candidate.largest_neighbour = largest;
}

/// Order, scatter, and Student's interval.
void take(Candidate& candidate, LeastSquares fit) {
    const auto freedom = static_cast<double>(fit.residuals.size() - fit.parameters.size());
    const double half = student_quantile(freedom, model_quantile) * fit.deviation(1);
    candidate.order = fit.parameters[1];
    candidate.low = candidate.order - half;
    candidate.high = candidate.order + half;
    candidate.scatter = std::sqrt(fit.variance());
    candidate.fit = std::move(fit);
}

}  // namespace

Candidate power_law(const LogSeries& series, Index dropped) {
    Candidate candidate;
    candidate.dropped = dropped;
    const LogSeries window = series.finest(series.size() - dropped);
    const LeastSquares line = polynomial(window, 1);
    candidate.fit = line;
    candidate.order = line.parameters[1];
    candidate.akaike = akaike_of(line, series.size(), 2, dropped);
    candidate.scatter = std::sqrt(line.variance());
    candidate.asymptotic = window.size();
    if (window.size() == 3) {
        const double half = student_quantile(1, 0.975) * line.deviation(1);
        candidate.low = candidate.order - half;
        candidate.high = candidate.order + half;
    }
    if (window.size() < 4) return candidate;
    bear_bend(candidate, window, line);
    candidate.finest_agree = finest_two_agree(window, line);
    return candidate;
}

Candidate above_floor(const LogSeries& series, Index dropped) {
    Candidate candidate;
    candidate.model = ErrorModel::power_and_floor;
    candidate.dropped = dropped;
    candidate.possible = false;
    if (series.size() < 6 + dropped) return candidate;  // else the criterion is undefined
    const LogSeries window = series.finest(series.size() - dropped);
    const LeastSquares fit = power_and_floor(window);
    candidate.akaike = fit.found ? akaike_of(fit, series.size(), 3, dropped) : candidate.akaike;
    if (!std::isfinite(candidate.akaike)) return candidate;
    take(candidate, fit);
    const Eigen::ArrayXd slope = fit.parameters[0] + fit.parameters[1] * window.x.array();
    candidate.asymptotic = (slope > fit.parameters[2]).count();
    candidate.other = window.size() - candidate.asymptotic;
    const double share = 1 / (1 + std::exp(fit.parameters[2] - slope[0]));
    take_neighbours(candidate, window, fit.parameters);
    const double scatter = candidate.largest_neighbour - candidate.least_neighbour;
    candidate.low = std::min({candidate.low, candidate.order - scatter, candidate.order * share});
    candidate.high = std::max(candidate.high, candidate.order + scatter);
    candidate.finest_agree = finest_three_agree(fit);
    candidate.possible = candidate.asymptotic >= 2 && candidate.other >= 2;
    return candidate;
}

Candidate with_second_power(const LogSeries& series) {
    Candidate candidate;
    candidate.model = ErrorModel::two_powers;
    candidate.possible = false;
    if (series.size() < 7) return candidate;  // else the criterion is undefined
    LeastSquares fit = two_powers(series, 1);
    LeastSquares other = two_powers(series, -1);
    if (other.found && (!fit.found || other.squares < fit.squares)) {
        fit = std::move(other);
        candidate.sign = -1;
    }
    if (!fit.found) return candidate;
    candidate.akaike = akaike_of(fit, series.size(), 4, 0);
    take(candidate, fit);
    const double difference = std::exp(fit.parameters[3]);
    const Eigen::ArrayXd ratio = (fit.parameters[2] + difference * series.x.array()).exp();
    const double share = candidate.sign * ratio.tail(1)[0] / (1 + candidate.sign * ratio.tail(1)[0]);
    const double slope = candidate.order + difference * share;
    candidate.low = std::min(candidate.low, slope);
    candidate.high = std::max(candidate.high, slope);
    candidate.asymptotic = (ratio < (candidate.sign > 0 ? 1 : 0.1)).count();
    candidate.other = series.size() - candidate.asymptotic;
    candidate.possible = candidate.asymptotic >= 2 && candidate.other >= 1;
    return candidate;
}

void widen_to_bootstrap(Candidate& candidate, const LogSeries& series) {
    if (candidate.model == ErrorModel::power) return;
    const LogSeries window = series.finest(series.size() - candidate.dropped);
    const auto [low, high] = bootstrap_of_order(window, candidate.fit, [&](const LogSeries& drawn) {
        const Eigen::VectorXd& near = candidate.fit.parameters;
        return candidate.model == ErrorModel::power_and_floor ? power_and_floor(drawn, &near)
                                                              : two_powers(drawn, candidate.sign, &near);
    });
    candidate.low = std::min(candidate.low, low);
    candidate.high = std::max(candidate.high, high);
}

}  // namespace ordo::studies

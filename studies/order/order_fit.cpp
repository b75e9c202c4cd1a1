#include "studies/order/order_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/text.hpp"
#include "studies/order/candidates.hpp"
#include "studies/order/distributions.hpp"

namespace ordo::studies {
namespace {

using Eigen::Index;

constexpr double least_order = 0.1;       // below, halving an error takes a thousandfold refinement
constexpr double widest_line = 0.2;       // half-width up to which a power law's order is known
constexpr double narrow_line = 0.1;       // half-width up to which a bend does not matter, whatever it comes from
constexpr double widest_model = 0.4;      // and that of a model with a floor or a second power
constexpr double as_good = 3;             // difference of the criterion up to which models are equally good
constexpr double slope_quantile = 0.998;  // that a falling line must reach

/// Why these points, by falling abscissa, are no series.
Refused refused(const std::vector<FitPoint>& points) {
    for (const auto& [abscissa, error] : points) {
        const std::string at = " at abscissa " + shortest(abscissa);
        if (!(abscissa > 0) || !std::isfinite(abscissa))
            return {Refusal::abscissa, "the abscissa " + shortest(abscissa) + " is not positive"};
        if (std::isnan(error)) return {Refusal::is_nan, "the error is nan" + at};
        if (std::isinf(error)) return {Refusal::infinite, "the error is " + shortest(error) + at};
        if (error == 0) return {Refusal::zero, "the error is zero" + at};
        if (error < 0) return {Refusal::negative, "the error is negative" + at};
    }
    if (points.size() < 2) return {Refusal::too_few, "fewer than two points"};
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].abscissa == points[i - 1].abscissa)
            return {Refusal::repeated, "the abscissa " + shortest(points[i].abscissa) + " is repeated"};
    }
    return {};
}

LogSeries logarithms_of(const std::vector<FitPoint>& points) {
    const auto n = static_cast<Index>(points.size());
    LogSeries series{Eigen::VectorXd(n), Eigen::VectorXd(n)};
    for (Index i = 0; i < n; ++i) {
        const auto& point = points[static_cast<std::size_t>(i)];
        series.x[i] = std::log(point.abscissa) - std::log(points.back().abscissa);
        series.y[i] = std::log(point.error);
    }
    return series;
}

double neighbour(const LogSeries& series, Index i) {
    return (series.y[i] - series.y[i + 1]) / (series.x[i] - series.x[i + 1]);
}

/// Neighbour orders change less at the fine end than at the coarse one.
bool settles(const LogSeries& series) {
    const Index last = series.size() - 2;
    return std::abs(neighbour(series, last) - neighbour(series, last - 1)) <
           0.75 * std::abs(neighbour(series, 1) - neighbour(series, 0));
}

/// Neighbour orders move one way only, and no less at the fine end than at the coarse one.
bool runs_away(const LogSeries& series) {
    const Index last = series.size() - 2;
    const double coarse = neighbour(series, 1) - neighbour(series, 0);
    for (Index i = 1; i <= last; ++i) {
        if (!((neighbour(series, i) - neighbour(series, i - 1)) * coarse > 0)) return false;
    }
    return std::abs(neighbour(series, last) - neighbour(series, last - 1)) >= std::abs(coarse);
}

/// What was chosen, the interval over all that is equally good, and what else there is to say.
struct Choice {
    Candidate best;
    bool found = true;  ///< false: the line bends, and no model can be told from another
};

/// The line over all points unless it bends; then the model of least criterion among those that are possible.
Choice choice_of(const LogSeries& series) {
    Choice choice{power_law(series, 0)};
    if (!choice.best.curved) return choice;
    std::vector<Candidate> candidates{with_second_power(series)};
    const Index most_dropped = std::min<Index>(series.size() / 2, 8);
    for (Index dropped = 0; dropped <= most_dropped && dropped + 3 <= series.size(); ++dropped) {
        if (dropped > 0) candidates.push_back(power_law(series, dropped));
        candidates.push_back(above_floor(series, dropped));
    }
    std::erase_if(candidates, [](const Candidate& candidate) {
        return !candidate.possible || candidate.curved || !std::isfinite(candidate.akaike);
    });
    if (candidates.empty()) return {choice.best, false};
    choice.best = *std::ranges::min_element(candidates, {}, &Candidate::akaike);
    for (auto& candidate : candidates) {
        if (candidate.akaike > choice.best.akaike + as_good) continue;
        widen_to_bootstrap(candidate, series);
        choice.best.low = std::min(choice.best.low, candidate.low);
        choice.best.high = std::max(choice.best.high, candidate.high);
    }
    return choice;
}

struct Said {
    Convergence verdict;
    std::string reason;
};

/// Verdict on a bend that no model explains: too few points for the criterion, or none that fits.
Said said_of_bend(const LogSeries& series, const Candidate& line) {
    const double half = (line.high - line.low) / 2;
    if (line.low > least_order && (half <= narrow_line || (half <= widest_line && settles(series))))
        return {Convergence::converges, "power law that bends within the interval"};
    Index growing = 0;
    for (Index i = 0; i + 1 < series.size(); ++i) growing += neighbour(series, i) < 0;
    if (line.low <= least_order && line.low > -least_order && line.high < 0.3)
        return {Convergence::stalled, "errors do not fall"};
    if (growing == series.size() - 1) return {Convergence::diverges, "errors grow with every refinement"};
    const bool few = series.size() < 7;
    return {
        Convergence::pre_asymptotic,
        few ? fmt::format("neighbour orders drift; {} points are too few for a second term, which needs 6 (floor) or "
                          "7 (second power)",
                          series.size())
            : "neighbour orders drift, and no model explains it"};
}

std::string words_of(const Candidate& best, const LogSeries& series) {
    const auto points = series.size() - best.dropped;
    if (best.model == ErrorModel::power) return fmt::format("power law over {} points", points);
    if (best.model == ErrorModel::power_and_floor)
        return fmt::format("power law over a floor of {:.3g}, above it neighbour orders from {:.2f} to {:.2f}",
                           std::exp(best.fit.parameters[2]), best.least_neighbour, best.largest_neighbour);
    return fmt::format("power law and a second power {:.3g}", best.order + std::exp(best.fit.parameters[3]));
}

/// The line falls beyond chance.
bool falls(const LogSeries& series) {
    const LeastSquares line = polynomial(series, 1);
    const double t = student_quantile(static_cast<double>(series.size() - 2), slope_quantile);
    return line.parameters[1] > t * line.deviation(1);
}

Said said_of(const LogSeries& series, const Candidate& best) {
    if (series.size() == 2) return {Convergence::inconclusive, "two points have an order, and no interval"};
    if (best.high < 0 && best.low < -least_order) return {Convergence::diverges, "errors grow with refinement"};
    if (best.low <= least_order && best.high < 0.3) return {Convergence::stalled, "errors do not fall"};
    const bool line = best.model == ErrorModel::power;
    const double half = (best.high - best.low) / 2;
    if (best.low <= least_order)
        return {Convergence::inconclusive, fmt::format("the interval reaches down to {:.2g}", best.low)};
    if (half > (line ? widest_line : widest_model))
        return {Convergence::inconclusive, fmt::format("the order is known within +- {:.2g} only", half)};
    if (line && best.dropped == 0 && !falls(series)) return {Convergence::inconclusive, "the fall may be chance"};
    if (best.model == ErrorModel::power_and_floor && best.asymptotic < 3)
        return {Convergence::at_floor,
                fmt::format("{} points above a floor of {:.3g}", best.asymptotic, std::exp(best.fit.parameters[2]))};
    if (best.model == ErrorModel::two_powers && best.asymptotic < 3)
        return {Convergence::pre_asymptotic, "two points only where the first power leads"};
    const Index last = series.size() - 1;
    if (series.y[last] - series.y.minCoeff() > 3 * std::sqrt(2.0) * best.scatter)
        return {Convergence::pre_asymptotic, "the error grows again at the fine end"};
    if (!best.finest_agree)
        return {Convergence::pre_asymptotic, "the finest points are not where the others foretell them"};
    return {Convergence::converges, words_of(best, series)};
}

double correlation_of(const LogSeries& series) {
    const Eigen::ArrayXd x = series.x.array() - series.x.mean();
    const Eigen::ArrayXd y = series.y.array() - series.y.mean();
    return (x * y).sum() / std::sqrt(x.square().sum() * y.square().sum());
}

OrderFit fit_of(const Candidate& best, const LogSeries& series, double finest) {
    OrderFit fit;
    fit.order = best.order;
    fit.low = best.low;
    fit.high = best.high;
    fit.model = best.model;
    fit.coefficient = std::exp(best.fit.parameters[0] - best.order * std::log(finest));
    if (best.model == ErrorModel::power_and_floor) fit.floor = std::exp(best.fit.parameters[2]);
    if (best.model == ErrorModel::two_powers) {
        const double difference = std::exp(best.fit.parameters[3]);
        fit.second_order = best.order + difference;
        fit.second_coefficient =
            best.sign * fit.coefficient * std::exp(best.fit.parameters[2] - difference * std::log(finest));
    }
    fit.correlation = correlation_of(series.finest(series.size() - best.dropped));
    for (Index i = 0; i + 1 < series.size(); ++i) fit.neighbours.push_back(neighbour(series, i));
    return fit;
}

}  // namespace

std::string text_of(ErrorModel model) {
    static const std::vector<std::string> names{"A h^p", "A h^p + f", "A h^p + B h^q"};
    return names.at(static_cast<std::size_t>(model));
}

double OrderFit::error_at(double abscissa) const {
    return coefficient * std::pow(abscissa, order) + floor + second_coefficient * std::pow(abscissa, second_order);
}

double neighbour_order(FitPoint coarse, FitPoint fine) {
    return std::log(coarse.error / fine.error) / std::log(coarse.abscissa / fine.abscissa);
}

FitOutcome fit_order(std::vector<FitPoint> given) {
    std::vector<std::size_t> places(given.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::ranges::stable_sort(places, std::greater{}, [&](std::size_t place) { return given[place].abscissa; });
    std::vector<FitPoint> points;
    for (const auto place : places) points.push_back(given[place]);
    FitOutcome outcome;
    if (auto [refusal, why] = refused(points); refusal != Refusal::none) {
        outcome.refusal = refusal;
        outcome.reason = std::move(why);
        return outcome;
    }
    const LogSeries series = logarithms_of(points);
    if ((series.y.array() == series.y[0]).all()) {
        outcome.verdict = Convergence::stalled;
        outcome.reason = "all errors are equal: no convergence";
        return outcome;
    }
    auto [best, found] = choice_of(series);
    const auto [verdict, reason] = found ? said_of(series, best) : said_of_bend(series, best);
    outcome.verdict = verdict;
    outcome.reason = reason;
    const bool drifts = verdict == Convergence::pre_asymptotic;
    if (verdict == Convergence::at_floor || (drifts && (found || runs_away(series)))) {
        best.low = -std::numeric_limits<double>::infinity();
        best.high = std::numeric_limits<double>::infinity();
    }
    outcome.fit = fit_of(best, series, points.back().abscissa);
    for (Index i = 0; i < best.dropped; ++i)
        outcome.left_out.push_back({places[static_cast<std::size_t>(i)], "pre-asymptotic: it bends the line"});
    return outcome;
}

}  // namespace ordo::studies

#include "studies/order/order_fit.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

#include "core/text.hpp"

namespace ordo::studies {
namespace {

/// Why one of these points cannot be fitted, or "".
std::string refused_point(const std::vector<FitPoint>& points) {
    for (const auto& [abscissa, error] : points) {
        const std::string at = " at abscissa " + shortest(abscissa);
        if (!(abscissa > 0) || !std::isfinite(abscissa))
            return "the abscissa " + shortest(abscissa) + " is not positive";
        if (!std::isfinite(error)) return "the error is " + shortest(error) + at;
        if (error == 0) return "the error is zero" + at;
        if (error < 0) return "the error is negative" + at;
    }
    return "";
}

/// Why these points, by falling abscissa, cannot be fitted together, or "".
std::string refused_set(const std::vector<FitPoint>& points) {
    if (points.size() < 2) return "fewer than two points";
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].abscissa == points[i - 1].abscissa)
            return "the abscissa " + shortest(points[i].abscissa) + " is repeated";
    }
    const auto same = [&](const FitPoint& point) { return point.error == points.front().error; };
    if (std::all_of(points.begin(), points.end(), same)) return "all errors are equal: no convergence";
    return "";
}

/// Sums of the centred logarithms x = ln abscissa, y = ln error.
struct Moments {
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0, yy = 0;
};

Moments moments(const std::vector<FitPoint>& points) {
    Moments sum;
    const double n = static_cast<double>(points.size());
    for (const auto& point : points) {
        sum.mean_x += std::log(point.abscissa) / n;
        sum.mean_y += std::log(point.error) / n;
    }
    for (const auto& point : points) {
        const double x = std::log(point.abscissa) - sum.mean_x;
        const double y = std::log(point.error) - sum.mean_y;
        sum.xx += x * x;
        sum.xy += x * y;
        sum.yy += y * y;
    }
    return sum;
}

/// Half-width of the 95 % interval of a slope over n points; infinite for two.
double half_width(const std::vector<FitPoint>& points, const Moments& sum, double slope) {
    const std::size_t n = points.size();
    if (n < 3) return std::numeric_limits<double>::infinity();
    double squares = 0;
    for (const auto& point : points) {
        const double residual = std::log(point.error) - sum.mean_y - slope * (std::log(point.abscissa) - sum.mean_x);
        squares += residual * residual;
    }
    const double freedom = static_cast<double>(n - 2);
    const double quantile = boost::math::quantile(boost::math::students_t(freedom), 0.975);
    return quantile * std::sqrt(squares / freedom / sum.xx);
}

}  // namespace

double neighbour_order(FitPoint coarse, FitPoint fine) {
    return std::log(coarse.error / fine.error) / std::log(coarse.abscissa / fine.abscissa);
}

FitOutcome fit_order(std::vector<FitPoint> points) {
    if (auto why = refused_point(points); !why.empty()) return {.fit = {}, .refused = std::move(why)};
    std::stable_sort(points.begin(), points.end(),
                     [](const FitPoint& a, const FitPoint& b) { return a.abscissa > b.abscissa; });
    if (auto why = refused_set(points); !why.empty()) return {.fit = {}, .refused = std::move(why)};
    const Moments sum = moments(points);
    OrderFit fit;
    fit.order = sum.xy / sum.xx;
    const double width = half_width(points, sum, fit.order);
    fit.low = fit.order - width;
    fit.high = fit.order + width;
    fit.coefficient = std::exp(sum.mean_y - fit.order * sum.mean_x);
    fit.correlation = sum.xy / std::sqrt(sum.xx * sum.yy);
    for (std::size_t i = 1; i < points.size(); ++i) fit.neighbours.push_back(neighbour_order(points[i - 1], points[i]));
    return {.fit = std::move(fit), .refused = ""};
}

}  // namespace ordo::studies

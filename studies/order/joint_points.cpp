#include "studies/order/joint_points.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>

#include "core/text.hpp"

namespace ordo::studies {
namespace {

constexpr std::size_t fewest_points = 7;  ///< one more than Akaike's corrected criterion needs for two parts
constexpr std::size_t fewest_levels = 3;  ///< two lie on any power

/// One of h and dt tells the other, as along dt = C h^k: correlation of their logarithms above 0.99.
bool move_together(const std::vector<JointPoint>& points) {
    const auto n = static_cast<Eigen::Index>(points.size());
    Eigen::ArrayXd x(n), y(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        x(i) = std::log(points[static_cast<std::size_t>(i)].h);
        y(i) = std::log(points[static_cast<std::size_t>(i)].dt);
    }
    x -= x.mean();
    y -= y.mean();
    return std::abs((x * y).sum()) > 0.99 * std::sqrt(x.square().sum() * y.square().sum());
}

}  // namespace

double abscissa_of(const JointPoint& point, int part) { return part == 0 ? point.h : point.dt; }

const char* name_of(int part) { return part == 0 ? "h" : "dt"; }

std::set<double> levels_of(const std::vector<JointPoint>& points, int part) {
    std::set<double> levels;
    for (const auto& point : points) levels.insert(abscissa_of(point, part));
    return levels;
}

std::string invalid_point(const std::vector<JointPoint>& points) {
    std::set<std::pair<double, double>> places;
    for (const auto& [h, dt, error] : points) {
        const std::string at = " at h = " + shortest(h) + ", dt = " + shortest(dt);
        if (!(h > 0) || !(dt > 0) || !std::isfinite(h) || !std::isfinite(dt)) return "an abscissa is not positive" + at;
        if (!std::isfinite(error)) return "the error is " + shortest(error) + at;
        if (error == 0) return "the error is zero" + at;
        if (error < 0) return "the error is negative" + at;
        if (!places.emplace(h, dt).second) return "the point is repeated" + at;
    }
    return "";
}

std::string too_few(const std::vector<JointPoint>& points) {
    if (points.size() < fewest_points)
        return fmt::format("{} points, but at least {} are needed", points.size(), fewest_points);
    for (const int part : {0, 1}) {
        const auto levels = levels_of(points, part).size();
        if (levels < fewest_levels)
            return fmt::format("{} value{} of {}, but at least {} are needed", levels, levels == 1 ? "" : "s",
                               name_of(part), fewest_levels);
    }
    if (move_together(points)) return "h and dt move together: their orders cannot be told apart";
    return "";
}

}  // namespace ordo::studies

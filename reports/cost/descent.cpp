#include "reports/cost/descent.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ordo::reports {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// y at x on the power law through a and b: a straight line in logarithms. x lies between a.x and b.x.
double on_power_law(double ax, double ay, double bx, double by, double x) {
    if (ay == by) return ay;
    const double share = std::log(x / ax) / std::log(bx / ax);
    return ay * std::pow(by / ay, share);
}

double cost_at(const CostPoint& a, const CostPoint& b, double error) {
    return a.cost == b.cost ? a.cost : on_power_law(a.error, a.cost, b.error, b.cost, error);
}

/// Places of the points that have one, in rising cost; of points of one cost that with the least error alone.
std::vector<std::size_t> by_cost(std::span<const CostPoint> points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (placed(points[i])) order.push_back(i);
    }
    const auto cost = [&](std::size_t i) { return points[i].cost; };
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::pair(points[i].cost, points[i].error); });
    const auto [end, last] = std::ranges::unique(order, {}, cost);
    order.erase(end, last);
    return order;
}

/// Whether a run without an error stood between two of these places in the order of refinement.
bool gap_between(std::span<const CostPoint> points, std::size_t a, std::size_t b) {
    const auto [first, last] = std::minmax(a, b);
    return !std::all_of(points.begin() + static_cast<std::ptrdiff_t>(first),
                        points.begin() + static_cast<std::ptrdiff_t>(last), placed);
}

/// Error just below and at one cost: different where the descent falls there.
struct Sides {
    double below = infinite;
    double at = infinite;
};

Sides sides_at(const Descent& descent, double cost) {
    Sides sides;
    const auto& vertices = descent.vertices;
    for (std::size_t i = 0; i < vertices.size() && vertices[i].cost <= cost; ++i) {
        const bool inside = i + 1 < vertices.size() && vertices[i + 1].cost > cost && vertices[i].cost < cost;
        sides.at = inside ? on_power_law(vertices[i].cost, vertices[i].error, vertices[i + 1].cost,
                                         vertices[i + 1].error, cost)
                          : vertices[i].error;
        if (inside || i == 0 || vertices[i - 1].cost < vertices[i].cost) sides.below = sides.at;
    }
    return sides;
}

/// The costs of all vertices that both were measured for, rising, each once.
std::vector<double> shared_costs(const Descent& first, const Descent& second) {
    const double from = std::max(first.vertices.front().cost, second.vertices.front().cost);
    const double to = std::min(first.vertices.back().cost, second.vertices.back().cost);
    std::vector<double> costs;
    for (const auto* descent : {&first, &second}) {
        for (const auto& vertex : descent->vertices) {
            if (vertex.cost >= from && vertex.cost <= to) costs.push_back(vertex.cost);
        }
    }
    std::ranges::sort(costs);
    const auto [end, last] = std::ranges::unique(costs);
    costs.erase(end, last);
    return costs;
}

/// Follows the sign of ln(e_first / e_second) along rising costs.
class Follower {
public:
    void meet(double cost, double first, double second) {
        const double now = first == second ? 0 : std::log(first / second);
        if (now == 0) {
            if (std::isnan(touched_.cost)) touched_ = {cost, first};
            return;
        }
        if (before_ * now < 0) found.push_back({crossing(cost, first, second, now), now < 0});
        before_ = now;
        last_ = {cost, first};
        touched_ = {};
    }

    std::vector<Crossover> found;

private:
    CostPoint crossing(double cost, double first, double second, double now) const {
        if (placed(touched_)) return touched_;
        if (std::isinf(now)) return {cost, std::max(first, second)};  // one of both falls to zero
        const double share = before_ / (before_ - now);
        return {last_.cost * std::pow(cost / last_.cost, share), last_.error * std::pow(first / last_.error, share)};
    }

    double before_ = 0;
    CostPoint last_;
    CostPoint touched_;  ///< where both met since
};

}  // namespace

bool placed(const CostPoint& point) {
    return std::isfinite(point.cost) && point.cost > 0 && std::isfinite(point.error) && point.error >= 0;
}

std::vector<std::size_t> pareto_front(std::span<const CostPoint> points) {
    std::vector<std::size_t> front;
    for (const std::size_t i : by_cost(points)) {
        if (front.empty() || points[i].error < points[front.back()].error) front.push_back(i);
    }
    return front;
}

Descent descent_of(std::span<const CostPoint> points) {
    const auto order = by_cost(points);
    Descent descent;
    auto& vertices = descent.vertices;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const CostPoint& now = points[order[k]];
        if (k == 0) {
            vertices.push_back(now);
            continue;
        }
        const double least = vertices.back().error;
        const bool falls = now.error < least;
        const bool gap = falls && (now.error == 0 || gap_between(points, order[k - 1], order[k]));
        const double turn = !falls || gap ? now.cost : cost_at(points[order[k - 1]], now, least);
        if (turn > vertices.back().cost) vertices.push_back({turn, least});
        if (falls) vertices.push_back(now);
    }
    return descent;
}

CostToError cost_to(const Descent& descent, double error) {
    const auto& vertices = descent.vertices;
    const auto found = std::ranges::find_if(vertices, [&](const CostPoint& vertex) { return vertex.error <= error; });
    if (found == vertices.end()) return {};
    if (found == vertices.begin()) return {Reached::at_most, found->cost};
    return {Reached::between, cost_at(found[-1], *found, error)};
}

std::vector<Crossover> crossovers(const Descent& first, const Descent& second) {
    if (first.empty() || second.empty()) return {};
    Follower follower;
    const auto costs = shared_costs(first, second);
    for (std::size_t k = 0; k < costs.size(); ++k) {
        const Sides a = sides_at(first, costs[k]);
        const Sides b = sides_at(second, costs[k]);
        if (k > 0) follower.meet(costs[k], a.below, b.below);
        follower.meet(costs[k], a.at, b.at);
    }
    return follower.found;
}

double error_for(const Descent& descent, double cost) { return sides_at(descent, cost).at; }

}  // namespace ordo::reports

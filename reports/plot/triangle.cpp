#include "reports/plot/triangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ordo::reports {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The range of y - order * x over what the segments have between both ends of `x`; low > high where they have nothing.
Interval intercepts(const std::vector<Segment>& segments, const Interval& x, double order) {
    Interval found{infinity, -infinity};
    for (const auto& [a, b] : segments) {
        const Point left = a.x <= b.x ? a : b;
        const Point right = a.x <= b.x ? b : a;
        if (right.x < x.low || left.x > x.high) continue;
        const double slope = right.x > left.x ? (right.y - left.y) / (right.x - left.x) : 0;
        const double begin = std::max(left.x, x.low);
        const double end = std::min(right.x, x.high);
        found.include(left.y + slope * (begin - left.x) - order * begin);
        found.include(right.y - slope * (right.x - end) - order * end);
    }
    return found;
}

/// The slope runs from x to x + width; the right angle is below it or above it.
Triangle triangle_at(double order, double x, double width, double intercept, bool below) {
    const Point left{x, order * x + intercept};
    const Point right{x + width, order * (x + width) + intercept};
    const Point angle{(order > 0) == below ? right.x : left.x,
                      below ? std::min(left.y, right.y) : std::max(left.y, right.y)};
    return {order, {left, right, angle}};
}

/// How far the triangle stands out of the box, as a share of the box's height.
double overhang(const Triangle& triangle, const Box& box) {
    double out = 0;
    for (const auto& corner : triangle.corners) out = std::max({out, box.y.low - corner.y, corner.y - box.y.high});
    return out / box.y.span();
}

}  // namespace

void Interval::include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
}

Triangle placed_triangle(double order, double centre, const std::vector<Segment>& segments, const Box& box) {
    constexpr int tries = 40;
    const double width = std::min(0.12 * box.x.span(), 0.22 * box.y.span() / std::abs(order));
    const double label = 0.05 * box.x.span();
    // A gap of 4 % of the height at right angles to the slope, in a picture 1.7 times as wide as high.
    const double steepness = order * box.x.span() / box.y.span() / 1.7;
    const double gap = 0.04 * box.y.span() * std::hypot(1.0, steepness);
    Triangle best;
    double least = infinity;
    for (int i = 0; i <= tries; ++i) {
        const double x = box.x.low + (box.x.span() - width) * i / tries;
        const Interval taken = intercepts(segments, Interval{x, x + width}.widened(label), order);
        if (taken.low > taken.high) continue;
        for (const bool below : {true, false}) {
            const auto triangle = triangle_at(order, x, width, below ? taken.low - gap : taken.high + gap, below);
            const double away = std::abs(x + 0.5 * width - centre) / box.x.span();
            const double cost = 100 * overhang(triangle, box) + away + (below ? 0 : 0.3);
            if (cost < least) {
                least = cost;
                best = triangle;
            }
        }
    }
    return best;
}

}  // namespace ordo::reports

#pragma once
// Where a slope triangle stands, clear of everything drawn. All coordinates are decimal logarithms.
#include <array>
#include <vector>

namespace ordo::reports {

struct Point {
    double x = 0;
    double y = 0;
};

struct Segment {
    Point a;
    Point b;
};

struct Interval {
    double low = 0;
    double high = 0;

    double span() const { return high - low; }
    Interval widened(double by) const { return {low - by, high + by}; }
    void include(double value);
};

struct Box {
    Interval x;
    Interval y;
};

/// The right triangle under a slope: both ends of the slope from left to right, then the right angle.
struct Triangle {
    double order = 0;
    std::array<Point, 3> corners;
};

/// A triangle clear of all segments: inside the box where it can be, then as near to `centre` as it can be, rather
/// below the data than above. `order` is not 0; the box holds all segments and has a height and a width.
Triangle placed_triangle(double order, double centre, const std::vector<Segment>& segments, const Box& box);

}  // namespace ordo::reports

#pragma once
// A figure in numbers: curves, ranges and slope triangles, before any gnuplot.
#include <array>
#include <string>
#include <vector>

#include "reports/plot/triangle.hpp"
#include "reports/view.hpp"

namespace ordo::reports {

/// One run of a curve. Only a finite, positive error can be drawn on logarithmic axes.
struct CurvePoint {
    Point at;
    bool drawn = false;
    bool used = true;  ///< by a fit
};

/// One series: its points coarse to fine, both ends of each fitted line, and its legend entry.
struct Curve {
    std::string legend;
    std::vector<CurvePoint> points;
    std::vector<std::array<Point, 2>> fits;
};

struct Layout {
    std::vector<Curve> curves;
    std::vector<Triangle> triangles;  ///< one for each expected order
    Interval x;
    Interval y;
    bool empty = false;  ///< nothing can be drawn
};

/// All in the units of the data, the triangles too.
Layout layout_of(const studies::Result& result, const View& view);

}  // namespace ordo::reports

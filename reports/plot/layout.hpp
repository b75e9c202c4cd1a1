#pragma once
// A figure in numbers: curves, ranges and slope triangles, before any gnuplot.
#include <array>
#include <string>
#include <vector>

#include "reports/plot/triangle.hpp"
#include "reports/view.hpp"

namespace ordo::reports {

/// One run of a curve. Only what is finite and positive both ways can be drawn on logarithmic axes.
struct CurvePoint {
    Point at;
    bool drawn = false;
    bool used = true;   ///< by a fit
    double spread = 0;  ///< of the abscissa, relative: half a bar's length; 0: no bar
};

/// One series: its points coarse to fine, each fitted line from coarse to fine, and its legend entry.
struct Curve {
    std::string legend;
    std::vector<CurvePoint> points;
    std::vector<std::vector<Point>> fits;
};

struct Layout {
    std::vector<Curve> curves;
    std::vector<Triangle> triangles;  ///< one for each expected order
    Interval x;
    Interval y;
    bool empty = false;                ///< nothing can be drawn
    bool solid = false;                ///< the line that joins the points of a curve; dotted beside fitted lines
    std::vector<Point> front;          ///< drawn behind the curves as a staircase; empty: none
    std::vector<Point> crossovers;     ///< where the lead changes: marked by rings
    std::vector<double> levels;        ///< errors asked for: lines across the picture
    std::vector<Point> reached;        ///< where curves meet them: marked on the line
    std::vector<std::string> remarks;  ///< lines of the legend without a curve
};

/// Finite and positive: it has a logarithm.
bool drawable(double value);
bool drawable(const Point& point);

/// What a legend tells of the runs without an error to draw: "; 1 run diverged; 2 errors zero or not finite", or "".
std::string missing_words(const studies::Result& result, const studies::Series& series, const std::string& key);

/// Errors of one quantity against the refined resolution. All in the units of the data, the triangles too.
Layout layout_of(const studies::Result& result, const View& view);

/// These curves joined by solid lines, without triangles.
Layout layout_of(std::vector<Curve> curves);

}  // namespace ordo::reports

#pragma once
// Functions of one variable in panels side by side, above the boxes that particles stand for.
#include <string>
#include <vector>

#include "reports/plot/gnuplot.hpp"

namespace ordo::reports {

/// Functions over the same places, one row of values each. NaN breaks a line.
struct Curves {
    enum class Style { lines, backdrop, points };

    std::vector<double> x;
    std::vector<std::vector<double>> values;
    std::vector<std::string> names = {};  ///< of the legend; empty: none
    Style style = Style::lines;
};

struct FunctionPanel {
    std::string heading;
    std::vector<Curves> curves;
};

struct FunctionFigure {
    std::string title;
    std::string subtitle;
    std::string abscissa;  ///< "x [cells]"; whole numbers on it are grid lines
    double from = 0;
    double to = 1;
    std::vector<double> particles;
    std::vector<double> corners;  ///< lower and upper end of each particle's box
    std::size_t across = 1;       ///< panels in a row
    std::vector<FunctionPanel> panels;
};

/// The figure as a gnuplot script that holds its own data.
std::string script_of(const FunctionFigure& figure, PlotFormat format, const std::string& picture);

}  // namespace ordo::reports

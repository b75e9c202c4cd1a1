#pragma once
// Convergence plots by gnuplot, from a report.
#include <string>
#include <vector>

#include "reports/plot/gnuplot.hpp"
#include "reports/report.hpp"

namespace ordo::reports {

/// A picture as a gnuplot script that holds its own data.
struct Figure {
    std::string name;  ///< file name without folder and ending
    std::string script;
};

/// One log-log figure for each quantity and abscissa: markers, fitted line over the fitted range only, slope triangle
/// with the expected order, slope and interval in the legend.
std::vector<Figure> figures(const Report& report, PlotFormat format);

/// Writes NAME.gp and has gnuplot draw NAME.svg, .pdf or .png beside it; returns the files made. Throws
/// EnvironmentError when gnuplot is missing or fails; the .gp files are then there all the same.
std::vector<std::string> draw(const Report& report, const std::string& folder, PlotFormat format);

}  // namespace ordo::reports

#pragma once
// Diagrams by gnuplot, from a report: errors against the refined resolution, and against what they cost.
#include <string>
#include <vector>

#include "reports/plot/cost.hpp"
#include "reports/plot/gnuplot.hpp"
#include "reports/report.hpp"

namespace ordo::reports {

/// A picture as a gnuplot script that holds its own data.
struct Drawing {
    std::string name;  ///< file name without folder and ending
    std::string script;
};

/// One log-log figure for each quantity and abscissa: markers, fitted line over the fitted range only, slope triangle
/// with the expected order, slope and interval in the legend.
std::vector<Drawing> figures(const Report& report, PlotFormat format);

/// One log-log figure for each quantity, all series in it: error over the cost of the run, points joined from coarse to
/// fine, and what it takes to reach each of `errors`. Throws InputError when runs ended and none of them has a cost
/// above zero.
std::vector<Drawing> figures(const Report& report, PlotFormat format, Cost cost,
                             const std::vector<double>& errors = {});

/// One figure with a panel for each report, its first quantity over the cost; series of one label look alike in all of
/// them. Throws InputError as above.
Drawing board(const std::vector<Report>& reports, PlotFormat format, Cost cost);

/// Writes NAME.gp of each figure and has gnuplot draw NAME.svg, .pdf or .png beside it; returns the files made. Throws
/// InputError when the folder cannot be written into, EnvironmentError when gnuplot is missing or fails; the .gp files
/// are then there all the same.
std::vector<std::string> draw(const std::vector<Drawing>& figures, const std::string& folder, PlotFormat format);

/// The same of the convergence plots of a report.
std::vector<std::string> draw(const Report& report, const std::string& folder, PlotFormat format);

}  // namespace ordo::reports

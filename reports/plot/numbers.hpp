#pragma once
// Pictures of studies whose runs give numbers and no errors: curves over a swept axis, and maps of what is stable.
#include <string>
#include <vector>

#include "reports/plot/gnuplot.hpp"
#include "reports/report.hpp"

namespace ordo::reports {

/// Numbers over the axis with most values, a panel a solver, a colour for each combination of the other axes. Limits by
/// matrix are filled points, by runs hollow ones, in closed form lines.
std::string curves_script(const studies::Result& result, PlotFormat format, const std::string& picture);

/// Courant number over another axis, a panel a solver: what a run came to by its `growth` (or the radius alone), and
/// above it where the radius of one step's matrix passes 1, and the closed form.
std::string map_script(const studies::Result& result, PlotFormat format, const std::string& picture);

/// Whether the study makes a map: it sweeps the Courant number and asks what becomes of runs there.
bool makes_map(const studies::Study& study);

}  // namespace ordo::reports

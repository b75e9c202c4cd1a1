#pragma once
// A gnuplot script that holds its data.
#include <string>

#include "reports/plot/layout.hpp"
#include "reports/plot/plot.hpp"

namespace ordo::reports {

/// ".svg", ".pdf" or ".png"
std::string ending_of(PlotFormat format);

/// The script of one figure. It draws into the file `picture` in its folder, or into the file that a variable `output`
/// names. Text of the user stands in it inside quoted() alone, and never in a data block.
std::string script_of(const studies::Result& result, const View& view, PlotFormat format, const std::string& picture);

}  // namespace ordo::reports

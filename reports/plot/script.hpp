#pragma once
// A gnuplot script that holds its data.
#include <string>

#include "reports/plot/gnuplot.hpp"
#include "reports/plot/layout.hpp"
#include "reports/view.hpp"

namespace ordo::reports {

/// The script of one figure. It draws into the file `picture` in its folder, or into the file that a variable `output`
/// names. Text of the user stands in it inside quoted() alone, and never in a data block.
std::string script_of(const studies::Result& result, const View& view, PlotFormat format, const std::string& picture);

}  // namespace ordo::reports

#pragma once
// A gnuplot script that holds its data.
#include <string>

#include "reports/plot/gnuplot.hpp"
#include "reports/plot/layout.hpp"

namespace ordo::reports {

/// The words of one figure, as the user and the study gave them.
struct Words {
    std::string title;
    std::string subtitle;
    std::string abscissa;
    std::string ordinate;
    std::string legend;   ///< heading of the legend
    std::string nothing;  ///< stands in the middle where nothing can be drawn
};

/// Title, subtitle and ordinate of a figure that shows this quantity.
Words words_of(const studies::Result& result, const studies::Quantity& quantity);

/// The script of one figure. It draws into the file `picture` in its folder, or into the file that a variable `output`
/// names. Text of the user stands in it inside quoted() alone, and never in a data block.
std::string script_of(const Layout& layout, const Words& words, PlotFormat format, const std::string& picture);

}  // namespace ordo::reports

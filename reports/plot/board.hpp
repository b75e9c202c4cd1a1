#pragma once
// Error over cost of several studies in one picture: a panel each, one legend for all.
#include <string>
#include <vector>

#include "reports/cost/methods.hpp"
#include "reports/plot/gnuplot.hpp"

namespace ordo::reports {

struct BoardPanel {
    std::string heading;
    std::vector<std::size_t> styles;  ///< of each method: its place in Board::labels
    std::vector<Method> methods;
};

struct Board {
    std::string title;
    std::string abscissa;
    std::vector<std::string> labels;  ///< of all methods, each once
    std::vector<BoardPanel> panels;
};

/// The first quantity of each report that is measured against an exact solution.
Board board_of(const std::vector<Report>& reports, Cost cost);

/// The board as a gnuplot script that holds its data. Errors below 1e-10 lie under the panels.
std::string script_of(const Board& board, PlotFormat format, const std::string& picture);

}  // namespace ordo::reports

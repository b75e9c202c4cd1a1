#pragma once
// The figures of a report that a baseline and a history follow, under names that hold from report to report.
#include <string>
#include <vector>

#include "reports/report.hpp"

namespace ordo::reports {

enum class FigureKind { error, order, work };

/// Names in the order of the enumeration: "error", "order", "work".
const std::vector<std::string>& figure_kinds();

/// One number of a report.
struct Figure {
    FigureKind kind = FigureKind::error;
    std::string subject;  ///< its run, "mpm, cells = 4, ppc = 1"; of an order its series
    std::string solver;   ///< label of the solver
    std::string what;     ///< "displacement.rms", "displacement.rms: order against h", "particle_steps"
    double value = 0;     ///< NaN: there is none

    std::string name() const { return subject + ": " + what; }
    std::string group() const { return solver + ": " + what; }  ///< figures of like size and scatter
};

/// Errors and work counts of every run, then every order with both ends of its interval. An end that is not finite is
/// none.
std::vector<Figure> figures_of(const studies::Result& result);

/// "mpm, cells = 4, ppc = 1"
std::string run_words(const studies::Run& run);

/// Value of the figure of that name; NaN where there is none.
double value_of(const std::vector<Figure>& figures, const std::string& name);

}  // namespace ordo::reports

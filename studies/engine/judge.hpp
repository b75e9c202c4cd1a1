#pragma once
// From runs to fits to verdicts: pure functions of plain data, so that a gate can repeat them from a report.
#include "studies/engine/result.hpp"

namespace ordo::studies {

/// Lines of refinement through the runs, as the sweep's path says, in the order of the runs, each coarse to fine.
std::vector<Series> lines_of(const Study& study, const std::vector<Run>& runs);

/// Runs that differ in h and dt only, where the path is `grid`; else none.
std::vector<Series> grids_of(const Study& study, const std::vector<Run>& runs);

/// These lines against the abscissae that the study asks for: the path's own, and counted work.
std::vector<Series> series_of(const Study& study, const std::vector<Run>& runs);

/// A fit for each series, quantity and range that an order expectation names; over all runs where none does.
std::vector<SeriesFit> fits_of(const Study& study, const std::vector<Run>& runs, const std::vector<Series>& series);

/// Printed values beside ours.
std::vector<PublishedMatch> matches_of(const Study& study, const std::vector<Run>& runs);

/// Whether an expectation is about this quantity of this solver.
bool speaks_of(const Expectation& expectation, const std::string& quantity, const std::string& solver);

/// Whether an order is expected along this abscissa: the one that it names, or any that is no counted work.
bool speaks_along(const Expectation& expectation, const std::string& abscissa);

/// Whether the run lies in the range that the expectation is about.
bool admits(const Expectation& expectation, const Run& run);

/// " where cells <= 32"; "" for no condition.
std::string range_text(const std::vector<Condition>& where);

/// The verdicts: every run ended, each expectation on each series, each published table.
std::vector<Check> checks_of(const Result& result);

/// Everything that follows from the runs: series, fits, matches, checks and the verdict.
Result judged(const Study& study, std::vector<Run> runs);

/// `value` rounded to the digits of `printed`, written like it: ("3.6e-03", 3.5828e-3) gives "3.6e-03".
std::string as_printed(const std::string& printed, double value);

}  // namespace ordo::studies

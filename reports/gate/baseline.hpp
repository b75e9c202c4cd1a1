#pragma once
// An accepted answer: the figures of a report with a tolerance each, the reason, and what made it.
#include <string>
#include <vector>

#include "reports/gate/figure.hpp"

namespace ordo::reports {

/// What made a report that was accepted, or a twin of it.
struct Maker {
    std::string time_utc;
    std::string revision;
    std::string compiler;
    std::string flags;
    std::string cpu;
    std::string os;
};

/// A figure with the half-width of the interval that a later one must be inside of.
struct AcceptedFigure {
    Figure figure;
    double tolerance = 0;
};

/// A run and how it ended: "mpm, cells = 4", "ok".
struct AcceptedRun {
    std::string run;
    std::string status;
};

struct Baseline {
    std::string because;                  ///< the reason, as given
    std::vector<Maker> makers;            ///< of the report, then of its twins
    double time_ratio = 0;                ///< see `time_ratio`; NaN where it was not measured
    std::string study;                    ///< its name
    std::string question;                 ///< see `question_of`
    std::vector<AcceptedRun> runs;        ///< of the report
    std::vector<AcceptedFigure> figures;  ///< of the report; tolerances from it and its twins

    std::string source() const;  ///< "baseline of TIME at REVISION: because"
};

/// The baseline of this report. Twins are reports of the same study by other builds or machines; the scatter among all
/// is what tolerances are made of. Throws InputError, `names` opening the message, where a twin answers another
/// question, has other runs or figures, or was made by the same build on the same kind of machine.
Baseline baseline_of(const std::vector<Report>& report_and_twins, const std::vector<std::string>& names,
                     const std::string& because);

/// Thread time of all runs over the time of the reference kernel in the same process; NaN where it was not measured.
double time_ratio(const Report& report);

/// Relative spread of that time where the runs were repeated, as of independent ones; 0 where each was timed once.
double time_spread(const Report& report);

/// DIR/<study>.json, with every character of the name made safe.
std::string baseline_path(const std::string& folder, const std::string& study);

/// JSON, one figure a line, so that a diff shows which ones changed.
std::string to_json(const Baseline& baseline);

/// Throws InputError on anything that is not a baseline.
Baseline read_baseline(const std::string& path);

}  // namespace ordo::reports

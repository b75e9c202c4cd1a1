#pragma once
// Figures over the revisions of a code, and the revisions at which they stepped.
#include <string>
#include <vector>

#include "reports/gate/figure.hpp"

namespace ordo::reports {

/// What a history keeps of a report.
struct Entry {
    std::string study;
    std::string question;  ///< see `question_of`
    std::string revision;
    std::string time_utc;
    std::vector<Figure> figures;
};
Entry entry_of(const Report& report);

/// A figure that has another level from revision `now` on than it had up to revision `before`.
struct HistoryStep {
    std::string study;
    std::string figure;
    std::string before;
    std::string now;
    double old_level = 0;  ///< NaN: it had none
    double new_level = 0;
};

struct History {
    std::size_t reports = 0;
    std::size_t studies = 0;
    std::size_t revisions = 0;
    std::size_t figures = 0;  ///< series looked at
    std::vector<HistoryStep> steps;
    std::vector<std::string> notes;  ///< what a reader must know: short series, a study that changed, no revision
};

/// Steps of every figure, reports grouped by study and revision, revisions in the order of their first report. Reports
/// of one revision are repetitions of each other and never make a step; their scatter is the noise. Improvements are
/// steps too. Where a study asks another question from some revision on, its figures begin anew, and a note says so.
History history_of(const std::vector<Entry>& entries);

std::string history_text(const History& history);
std::string history_json(const History& history);

}  // namespace ordo::reports

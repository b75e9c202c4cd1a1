#pragma once
// What a gate found, and how it is shown to people and to continuous integration.
#include <string>
#include <vector>

#include "studies/engine/result.hpp"

namespace ordo::reports {

/// Checks of one study, for the writers.
struct GateResult {
    std::string study;
    std::vector<studies::Check> checks;
    studies::Verdict verdict() const;  ///< of the worst check; without checks inconclusive
};

/// Name of what is wrong with a check that does not pass: its fault, or its verdict where it names none.
std::string name_of(const studies::Check& check);

/// What to look at next, one sentence.
std::string advice(studies::Fault fault);

/// Faults of all checks that do not pass, each once, in the order in which they were found.
std::vector<studies::Fault> faults_of(const std::vector<GateResult>& results);

/// Checks that pass, fail, or are inconclusive.
struct Counts {
    std::size_t pass = 0;
    std::size_t fail = 0;
    std::size_t inconclusive = 0;
};
Counts counts_of(const std::vector<GateResult>& results);

/// A table of what does not pass (study, subject, fault, expected, found), what to look at next, and "" where all pass.
std::string failures_text(const std::vector<GateResult>& results);

/// JUnit XML: one suite a study, one case a check; `inconclusive` counts as a failure, as it does under `ordo check`.
std::string junit(const std::vector<GateResult>& results);

/// Workflow commands of GitHub Actions: "::error title=TITLE::MESSAGE", one a check that does not pass.
std::string annotations(const std::vector<GateResult>& results);

/// A page of Markdown: the counts, a table of what does not pass, what to look at next, a line a study.
std::string summary(const std::vector<GateResult>& results);

/// Rows of cells as lines, columns aligned to the left; control characters become spaces.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace ordo::reports

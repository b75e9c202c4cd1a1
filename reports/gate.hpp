#pragma once
// The regression gate: a report against its expectations and against an accepted one.
#include <string>
#include <vector>

#include "reports/report.hpp"

namespace ordo::reports {

/// An accepted report, with who vouches for it and how far a later one may be off.
struct Baseline {
    std::string because;  ///< the reason, as given
    std::string time_utc;
    std::string revision;
    std::string compiler;
    double band = 1e-6;  ///< relative; libm differs in last digits from machine to machine
    Report report;
};

/// DIR/<study>.json, with every character of the name made safe.
std::string baseline_path(const std::string& folder, const std::string& study);

std::string to_json(const Baseline& baseline);
Baseline read_baseline(const std::string& path);

/// One check a quantity: every run of both reports stands in the other, ends alike, and its error agrees within the
/// band. Fails by name where the studies differ, so that different questions are never compared.
std::vector<studies::Check> checks_against(const Report& report, const Baseline& baseline);

/// Checks of one study, for the writers.
struct GateResult {
    std::string study;
    std::vector<studies::Check> checks;
    studies::Verdict verdict() const;
};

/// JUnit XML: one suite a study, one case a check; `inconclusive` counts as a failure, as it does under `ordo check`.
std::string junit(const std::vector<GateResult>& results);

}  // namespace ordo::reports

#pragma once
// What the tests of the gate begin with: the sample, its twin that rounds elsewhere, and the baseline of both.
#include <algorithm>
#include <string>
#include <vector>

#include "reports/gate/baseline.hpp"
#include "tests/reports/samples.hpp"

namespace ordo::gated {

inline const reports::Report& sample() {
    static const reports::Report report = samples::report_of(samples::study());
    return report;
}

/// The sample with these runs.
inline reports::Report with(std::vector<studies::Run> runs) {
    return samples::report_of(samples::study(), std::move(runs));
}

/// The sample's runs, the error of the second one times `factor`.
inline std::vector<studies::Run> with_error_times(double factor) {
    auto runs = sample().result.runs;
    runs[1].errors[0].value *= factor;
    return runs;
}

/// The sample as another build would have it: every error off by a part in 10^9, up and down in turns.
inline reports::Report twin() {
    auto runs = sample().result.runs;
    for (auto& run : runs) run.errors[0].value *= run.id % 2 == 0 ? 1 - 1e-9 : 1 + 1e-9;
    auto report = with(std::move(runs));
    report.provenance.flags += " -march=x86-64-v3 -ffp-contract=fast";
    return report;
}

inline reports::Baseline accepted(const reports::Report& report) {
    return reports::baseline_of({report}, {"r.json"}, "a test");
}

inline reports::Baseline accepted_with_twin() {
    return reports::baseline_of({sample(), twin()}, {"r.json", "twin.json"}, "a test");
}

inline bool all_pass(const std::vector<studies::Check>& checks) {
    const auto passes = [](const studies::Check& check) { return check.verdict == studies::Verdict::pass; };
    return !checks.empty() && std::ranges::all_of(checks, passes);
}

/// The faults of these checks, each once, in their order.
inline std::vector<std::string> faults(const std::vector<studies::Check>& checks) {
    std::vector<std::string> names;
    for (const auto& check : checks) {
        const auto name = studies::text_of(check.fault);
        if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    return names;
}

}  // namespace ordo::gated

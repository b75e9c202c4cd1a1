#include "tests/mutations/mutation.hpp"

#include <algorithm>
#include <map>

#include "studies/engine/judge.hpp"
#include "studies/reader/study_reader.hpp"
#include "tests/catch.hpp"

namespace ordo::tests {
namespace {

using namespace studies;

const auto never = [] { return false; };

/// A row of a printed table whose place is on the axes as swept.
bool is_swept(const PublishedValue& value, const Sweep& sweep) {
    return std::ranges::all_of(sweep.axes, [&](const Axis& axis) {
        const auto place = value.axes.find(axis.name);
        return place == value.axes.end() || std::ranges::find(axis.values, place->second) != axis.values.end();
    });
}

Study read(const Shipped& shipped) {
    std::vector<Setting> settings;
    for (const auto& level : shipped.levels) settings.push_back(setting_from("sweep." + level));
    Study study = read_study(std::string(ORDO_SOURCE_DIR) + "/studies/" + shipped.name + ".json", settings);
    for (auto& table : study.published)
        std::erase_if(table.values, [&](const PublishedValue& value) { return !is_swept(value, study.sweep); });
    return study;
}

Run run_of(const RunSpec& spec, const Parts& parts) { return executed(spec, never, parts).run; }

std::vector<Run> runs_of(const Study& study) {
    std::vector<Run> runs;
    for (const auto& spec : specs_of(study)) runs.push_back(run_of(spec, house_parts()));
    return runs;
}

/// Runs that the fault does not touch are those of the unbroken answer: the same description gives the same bits.
std::vector<Run> runs_of(const Result& whole, const Broken& broken) {
    auto specs = specs_of(whole.study);
    if (broken.plan) broken.plan(specs);
    std::vector<Run> runs;
    for (std::size_t i = 0; i < specs.size(); ++i) {
        const bool other = !broken.solver.empty() && specs[i].solver.name != broken.solver;
        const bool touched = broken.plan || (broken.parts && !other);
        runs.push_back(touched ? run_of(specs[i], broken.parts.value_or(house_parts())) : whole.runs[i]);
    }
    return runs;
}

bool passes(const Check& check) { return check.verdict == Verdict::pass; }

}  // namespace

std::vector<MutationClass> all_mutations() {
    return {broken_solvers(), broken_kernels(), broken_norms(), broken_times(), broken_oracles(), broken_studies()};
}

const Result& unbroken(const Shipped& shipped) {
    static std::map<std::string, Result> kept;
    std::string key = shipped.name;
    for (const auto& level : shipped.levels) key += " " + level;
    const auto found = kept.find(key);
    if (found != kept.end()) return found->second;
    const Study study = read(shipped);
    return kept.emplace(key, judged(study, runs_of(study))).first->second;
}

Result broken(const Shipped& shipped, const Broken& broken) {
    const Result& whole = unbroken(shipped);
    auto runs = runs_of(whole, broken);
    if (broken.runs) broken.runs(runs);
    return judged(whole.study, std::move(runs));
}

std::string what_rings(const Result& result) {
    std::string lines;
    for (const auto& check : result.checks) {
        if (passes(check)) continue;
        lines += "  " + text_of(check.verdict) + " " + text_of(check.fault) + " | " + check.claim + " | " +
                 check.subject + " | " + check.found + "\n";
    }
    return lines;
}

bool rings(const Result& result, const std::vector<Fault>& names) {
    return std::ranges::any_of(result.checks, [&](const Check& check) {
        if (passes(check)) return false;
        return std::ranges::find(names, check.fault) != names.end();
    });
}

void try_all(const MutationClass& mutations) {
    for (const auto& [what, study, fault, caught_by] : mutations.rows) {
        INFO(mutations.name << ": " << what << ", " << study.name);
        const Result& whole = unbroken(study);
        INFO("unbroken:\n" << what_rings(whole));
        CHECK(whole.verdict == Verdict::pass);
        const Result result = broken(study, fault);
        INFO("broken:\n" << what_rings(result));
        CHECK(result.verdict != Verdict::pass);
        CHECK(rings(result, caught_by));
    }
}

}  // namespace ordo::tests

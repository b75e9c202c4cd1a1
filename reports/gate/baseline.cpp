#include "reports/gate/baseline.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "reports/gate/question.hpp"
#include "reports/gate/tolerance.hpp"

namespace ordo::reports {
namespace {

Maker maker_of(const Report& report) {
    const Provenance& from = report.provenance;
    return {from.time_utc, from.revision, from.compiler, from.flags, from.cpu, from.os};
}

bool same_build_and_machine(const Maker& a, const Maker& b) {
    return a.compiler == b.compiler && a.flags == b.flags && a.cpu == b.cpu && a.os == b.os;
}

std::vector<AcceptedRun> runs_of(const Report& report) {
    std::vector<AcceptedRun> runs;
    for (const auto& run : report.result.runs) runs.push_back({run_words(run), studies::text_of(run.status)});
    return runs;
}

void check_runs(const Report& report, const Report& twin, const std::string& name) {
    const auto ours = runs_of(report);
    const auto theirs = runs_of(twin);
    if (ours.size() != theirs.size())
        throw InputError(name, fmt::format("is no twin: it has {} runs, not {}", theirs.size(), ours.size()));
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const auto& [run, status] = theirs[i];
        if (run != ours[i].run || status != ours[i].status)
            throw InputError(name, fmt::format("is no twin: its run '{}' is {}, where ours '{}' is {}", run, status,
                                               ours[i].run, ours[i].status));
    }
}

void check_figures(const std::vector<Figure>& ours, const std::vector<Figure>& theirs, const std::string& name) {
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const bool alike = i < theirs.size() && ours[i].name() == theirs[i].name() &&
                           std::isnan(ours[i].value) == std::isnan(theirs[i].value);
        if (!alike) throw InputError(name, "is no twin: only one of both has a value of '" + ours[i].name() + "'");
    }
    if (theirs.size() > ours.size())
        throw InputError(name, "is no twin: only it has '" + theirs[ours.size()].name() + "'");
}

void check_twin(const Report& report, const Report& twin, const std::string& name) {
    const auto other = differences(question_of(report.result.study), question_of(twin.result.study));
    if (!other.empty()) throw InputError(name, "is no twin, it answers another question: " + text_of(other));
    check_runs(report, twin, name);
    if (maker_of(report).revision != maker_of(twin).revision)
        throw InputError(name, "is no twin: it was made by another revision, '" + maker_of(twin).revision +
                                   "', whose changes are no scatter");
    if (same_build_and_machine(maker_of(report), maker_of(twin)))
        throw InputError(name,
                         "is no twin: the same compiler, flags and machine give the same bits and show no scatter "
                         "(nearest: a report of the preset 'fma')");
}

}  // namespace

std::string Baseline::source() const {
    return fmt::format("baseline of {} at {}: {}", makers.front().time_utc, makers.front().revision, because);
}

double time_ratio(const Report& report) {
    double seconds = 0;
    for (const auto& run : report.result.runs) seconds += run.seconds;
    return seconds / report.provenance.kernel_seconds;
}

double time_spread(const Report& report) {
    double seconds = 0;
    double squares = 0;
    for (const auto& run : report.result.runs) {
        seconds += run.seconds;
        if (run.repeats && run.repeats->number > 1) squares += std::pow(run.repeats->spread * run.seconds, 2);
    }
    return squares > 0 ? std::sqrt(squares) / seconds : 0;
}

std::string baseline_path(const std::string& folder, const std::string& study) {
    return folder + "/" + safe_path(study) + ".json";
}

Baseline baseline_of(const std::vector<Report>& report_and_twins, const std::vector<std::string>& names,
                     const std::string& because) {
    const Report& report = report_and_twins.front();
    Baseline baseline{.because = because,
                      .makers = {},
                      .time_ratio = time_ratio(report),
                      .study = report.result.study.name,
                      .question = question_of(report.result.study),
                      .runs = runs_of(report),
                      .figures = {}};
    std::vector<std::vector<Figure>> figures;
    for (std::size_t i = 0; i < report_and_twins.size(); ++i) {
        const Report& twin = report_and_twins[i];
        if (i > 0) check_twin(report, twin, names[i]);
        figures.push_back(figures_of(twin.result));
        check_figures(figures.front(), figures.back(), names[i]);
        baseline.makers.push_back(maker_of(twin));
    }
    const auto found = tolerances(figures);
    for (std::size_t i = 0; i < found.size(); ++i) baseline.figures.push_back({figures.front()[i], found[i]});
    return baseline;
}

}  // namespace ordo::reports

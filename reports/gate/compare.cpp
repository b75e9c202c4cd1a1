#include "reports/gate/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/text.hpp"
#include "reports/gate/question.hpp"

namespace ordo::reports {
namespace {

using studies::Check;
using studies::Fault;
using studies::Verdict;

/// Passes where nothing is wrong.
Check check_of(std::string claim, std::string subject, const Baseline& baseline, Fault fault, std::string found) {
    const Verdict verdict = fault == Fault::none ? Verdict::pass : Verdict::fail;
    return {std::move(claim), std::move(subject), baseline.source(), verdict, std::move(found), fault};
}

std::vector<Check> study_checks(const std::vector<Difference>& differences, const Baseline& baseline) {
    std::vector<Check> checks;
    for (const auto& [member, before, now] : differences)
        checks.push_back(check_of(before, "study: " + member, baseline, Fault::study_differs, now));
    return checks;
}

/// "a; b; and 3 more"
std::string first_of(const std::vector<std::string>& names) {
    constexpr std::size_t most = 3;
    const std::vector<std::string> first(names.begin(),
                                         names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), most)));
    const std::string text = joined(first, "; ");
    return names.size() > most ? text + fmt::format("; and {} more", names.size() - most) : text;
}

/// Every accepted run is there once and ends as it did; no other run is.
Check runs_check(const Report& report, const Baseline& baseline) {
    std::map<std::string, std::vector<std::string>> now;
    for (const auto& run : report.result.runs) now[run_words(run)].push_back(studies::text_of(run.status));
    std::vector<std::string> missing, repeated, changed;
    for (const auto& [name, status] : baseline.runs) {
        const auto found = now.find(name);
        if (found == now.end()) missing.push_back(name);
        else if (found->second.size() > 1) repeated.push_back(name);
        else if (found->second.front() != status) changed.push_back(name + ": " + found->second.front());
        if (found != now.end()) now.erase(found);
    }
    for (const auto& [name, status] : now) changed.push_back(name + ": not accepted");
    const auto answer = [&](Fault fault, const std::string& found) {
        return check_of(fmt::format("the {} accepted runs, ending alike", baseline.runs.size()), "all runs", baseline,
                        fault, found);
    };
    if (report.result.runs.empty()) return answer(Fault::nothing_measured, "no run");
    if (!missing.empty()) return answer(Fault::point_missing, "without " + first_of(missing));
    if (!repeated.empty()) return answer(Fault::point_repeated, "twice " + first_of(repeated));
    if (!changed.empty()) return answer(Fault::runs_changed, first_of(changed));
    return answer(Fault::none, fmt::format("{} runs", report.result.runs.size()));
}

/// An accepted figure and the same of now.
struct Pair {
    AcceptedFigure accepted;
    double now = 0;

    /// Distance from the accepted value, in tolerances: inside up to 1; infinite where there is none.
    double excursion() const {
        if (fault_of(accepted, now) == Fault::none && accepted.tolerance == 0) return 0;
        const double distance = std::abs(now - accepted.figure.value) / accepted.tolerance;
        return std::isnan(distance) ? (std::isnan(accepted.figure.value) && std::isnan(now) ? 0 : INFINITY) : distance;
    }
};

std::string value_words(double value) { return std::isnan(value) ? "none" : shortest(value); }

std::string accepted_words(const AcceptedFigure& accepted) {
    return fmt::format("{} +- {:.2g}", value_words(accepted.figure.value), accepted.tolerance);
}

const char* plural_of(FigureKind kind) {
    switch (kind) {
        case FigureKind::error: return "errors";
        case FigureKind::order: return "orders";
        case FigureKind::work: return "work counts";
    }
    return "";
}

/// One check for the figures of one solver and quantity: the first that is wrong names the fault, the worst is shown.
Check group_check(const std::string& group, const std::vector<Pair>& pairs, const Baseline& baseline) {
    Fault fault = Fault::none;
    std::size_t outside = 0;
    for (const auto& pair : pairs) {
        const Fault wrong = fault_of(pair.accepted, pair.now);
        outside += wrong != Fault::none;
        if (fault == Fault::none) fault = wrong;
    }
    const auto by_excursion = [](const Pair& a, const Pair& b) { return a.excursion() < b.excursion(); };
    const Pair& worst = *std::ranges::max_element(pairs, by_excursion);
    const std::string claim =
        fmt::format("{} {} as accepted", pairs.size(), plural_of(pairs.front().accepted.figure.kind));
    if (fault == Fault::none)
        return check_of(claim, group, baseline, fault,
                        fmt::format("all inside, the farthest at {:.2g} of its tolerance", worst.excursion()));
    return check_of(claim, group, baseline, fault,
                    fmt::format("{} outside, the farthest of {}: {}, accepted {}", outside,
                                worst.accepted.figure.subject, value_words(worst.now), accepted_words(worst.accepted)));
}

/// Accepted figures beside those of now, by group. A figure that was never accepted is paired with none.
std::map<std::string, std::vector<Pair>> pairs_of(const Report& report, const Baseline& baseline) {
    std::map<std::string, Figure> now;
    for (const auto& figure : figures_of(report.result)) now[figure.name()] = figure;
    std::map<std::string, std::vector<Pair>> groups;
    for (const auto& accepted : baseline.figures) {
        const auto found = now.find(accepted.figure.name());
        groups[accepted.figure.group()].push_back({accepted, found == now.end() ? std::nan("") : found->second.value});
        if (found != now.end()) now.erase(found);
    }
    for (auto& [name, figure] : now) {
        const double value = std::exchange(figure.value, std::nan(""));
        groups[figure.group()].push_back({{figure, 0}, value});
    }
    return groups;
}

}  // namespace

Fault fault_of(const AcceptedFigure& accepted, double value) {
    const double before = accepted.figure.value;
    const bool error = accepted.figure.kind == FigureKind::error;
    if (error && value < 0) return Fault::error_is_negative;
    if (std::isnan(value) && std::isnan(before)) return Fault::none;
    if (std::abs(value - before) <= accepted.tolerance) return Fault::none;
    if (error && std::isnan(value)) return Fault::error_is_nan;
    if (error && std::isinf(value)) return Fault::error_is_infinite;
    if (error && value == 0) return Fault::error_is_zero;
    switch (accepted.figure.kind) {
        case FigureKind::error: return Fault::error_changed;
        case FigureKind::order: return Fault::order_changed;
        case FigureKind::work: return Fault::work_changed;
    }
    return Fault::error_changed;
}

std::vector<Check> checks_against(const Report& report, const Baseline& baseline) {
    const auto other = differences(baseline.question, question_of(report.result.study));
    if (!other.empty()) return study_checks(other, baseline);
    std::vector<Check> checks{runs_check(report, baseline)};
    if (report.result.runs.empty()) return checks;
    for (const auto& [group, pairs] : pairs_of(report, baseline)) checks.push_back(group_check(group, pairs, baseline));
    return checks;
}

Check no_baseline(const std::string& path) {
    return {"an accepted report",  "baseline",        "rule of the house", Verdict::fail,
            "there is no " + path, Fault::no_baseline};
}

Check time_check(const Report& report, const Baseline& baseline, double factor) {
    const double now = time_ratio(report);
    const double ratio = now / baseline.time_ratio;
    const double spread = time_spread(report);
    const bool inside = 1 / factor <= ratio * (1 - spread) && ratio * (1 + spread) <= factor;
    const std::string scatter = spread > 0 ? fmt::format(" +- {:.2g} %", 100 * spread) : "";
    return check_of(fmt::format("time within a factor {} of the accepted", shortest(factor)), "time of all runs",
                    baseline, inside ? Fault::none : Fault::time_changed,
                    std::isnan(ratio)
                        ? "one of both reports holds no time"
                        : fmt::format("{:.3g}{} times the accepted: {:.4g} reference kernels, accepted {:.4g}", ratio,
                                      scatter, now, baseline.time_ratio));
}

std::vector<Change> changes(const Baseline& before, const Baseline& now) {
    std::map<std::string, AcceptedFigure> gone;
    for (const auto& accepted : before.figures) gone[accepted.figure.name()] = accepted;
    std::vector<Change> found;
    for (const auto& accepted : now.figures) {
        const auto old = gone.find(accepted.figure.name());
        if (old == gone.end()) {
            found.push_back({std::nullopt, accepted});
            continue;
        }
        const bool inside = fault_of(old->second, accepted.figure.value) == Fault::none;
        if (!inside || accepted.tolerance > 2 * old->second.tolerance) found.push_back({old->second, accepted});
        gone.erase(old);
    }
    for (const auto& [name, accepted] : gone) found.push_back({accepted, std::nullopt});
    return found;
}

}  // namespace ordo::reports

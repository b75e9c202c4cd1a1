#include "reports/plot/cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/cost/methods.hpp"

namespace ordo::reports {
namespace {

using namespace ordo::studies;

/// It has an error to show, and lacks a cost to show it at.
bool lacks_cost(const Run& run, const std::string& key, Cost cost) {
    return !stopped(run) && drawable(run.error(key)) && !drawable(cost_of(run, cost));
}

/// What the runs of a series that stand in the diagram count, in the order of their names.
std::set<std::string> units_of(const Result& result, const Series& series, const std::string& key) {
    std::set<std::string> units;
    for (const int id : series.runs) {
        const Run& run = run_of(result, id);
        if (!stopped(run) && drawable(run.error(key)) && drawable(cost_of(run, Cost::work)))
            units.insert(spoken(counted_in(run)));
    }
    return units;
}

std::set<std::string> units_of(const Result& result, const std::string& key) {
    std::set<std::string> units;
    for (const auto& series : result.series) units.merge(units_of(result, series, key));
    return units;
}

/// " [element steps]"
std::string bracketed(const std::set<std::string>& units) {
    const std::vector<std::string> words(units.begin(), units.end());
    return words.empty() ? "" : " [" + joined(words) + "]";
}

/// "; 2 runs without a time above zero: cells = 2, 4", or "".
std::string costless_words(const Result& result, const Series& series, const std::string& key, Cost cost) {
    std::vector<std::string> places;
    for (const int id : series.runs) {
        const Run& run = run_of(result, id);
        if (lacks_cost(run, key, cost)) places.push_back(shortest(run.at(series.shown)));
    }
    if (places.empty()) return "";
    return fmt::format("; {} {} without {}: {} = {}", places.size(), places.size() == 1 ? "run" : "runs",
                       cost == Cost::time ? "a time above zero" : "counted work", series.shown, joined(places));
}

/// "; error ~ 1/time^0.98 [0.9, 1.1]" where the points tell an exponent and errors fall with the cost, "" where not.
std::string exponent_words(const Method& method, Cost cost) {
    const auto found = cost_exponent(method);
    const bool known = found.fit && found.fit->low > 0 && std::isfinite(found.fit->high);
    return known ? "; error ~ 1/" + text_of(cost) + "^" + order_words(*found.fit) : "";
}

Curve curve_of(const Result& result, const Series& series, const Method& method, const std::string& key, Cost cost,
               bool mixed) {
    const std::string unit = mixed ? bracketed(units_of(result, series, key)) : "";
    const std::string words =
        exponent_words(method, cost) + missing_words(result, series, key) + costless_words(result, series, key, cost);
    Curve curve{clipped(series.label, 50) + unit + (words.empty() ? "" : ":" + words.substr(1)), {}, {}};
    for (const int id : series.runs) {
        const Run& run = run_of(result, id);
        const Point at{cost_of(run, cost), run.error(key)};
        curve.points.push_back({at, !stopped(run) && drawable(at), true, spread_of(run, cost)});
    }
    return curve;
}

std::string cost_text(double value, Cost cost) {
    return cost == Cost::time ? fmt::format("{:.2g} s", value) : fmt::format("{:.2g}", value);
}

/// "error 1e-04 (2 of 3 reach it): B 0.0012 s, A 0.003 s": the quickest two, by name.
std::string reach_words(const std::vector<Method>& methods, double error, Cost cost) {
    const auto order = ranked_at(methods, error);
    std::string text = fmt::format("error {} ({} of {} reach it)", shortest(error), order.size(), methods.size());
    for (std::size_t k = 0; k < std::min<std::size_t>(order.size(), 2); ++k) {
        const auto& method = methods[order[k]];
        const auto [reached, spent] = cost_to(method.descent, error);
        text += (k == 0 ? ": " : ", ") + clipped(method.label, 30) + (reached == Reached::at_most ? " <= " : " ") +
                cost_text(spent, cost);
    }
    return text;
}

/// What compares the methods: the front, changes of the lead, and the errors asked for.
void add_comparison(Layout& layout, const std::vector<Method>& methods, Cost cost, const std::vector<double>& errors) {
    for (const auto& [at, method, run] : front_of(methods)) {
        if (at.error > 0) layout.front.push_back({at.cost, at.error});
    }
    for (const auto& [at, before, after] : lead_changes(methods)) {
        layout.crossovers.push_back({at.cost, at.error});
        layout.remarks.push_back(fmt::format("ring at {}, error {:.2g}: up to there {}, from there {}",
                                             cost_text(at.cost, cost), at.error, clipped(methods[before].label, 30),
                                             clipped(methods[after].label, 30)));
    }
    for (const double error : errors) {
        layout.remarks.push_back(reach_words(methods, error, cost));
        if (!(layout.y.low < error && error < layout.y.high)) continue;
        layout.levels.push_back(error);
        for (const auto& method : methods) {
            const auto [reached, spent] = cost_to(method.descent, error);
            if (reached == Reached::between) layout.reached.push_back({spent, error});
        }
    }
}

/// "each run once"; "medians of 5 to 25 samples (bars: spread)".
std::string repetition_words(const Result& result) {
    int fewest = 0, most = 0;
    for (const auto& run : result.runs) {
        if (!run.repeats || stopped(run)) continue;
        fewest = fewest == 0 ? run.repeats->number : std::min(fewest, run.repeats->number);
        most = std::max(most, run.repeats->number);
    }
    return most == 0 ? "each run once" : fmt::format("medians of {} to {} samples (bars: spread)", fewest, most);
}

}  // namespace

void refuse_without(const Result& result, Cost cost) {
    const auto ended = [](const Run& run) { return !stopped(run); };
    const auto has_cost = [&](const Run& run) { return ended(run) && drawable(cost_of(run, cost)); };
    if (std::ranges::none_of(result.runs, ended) || std::ranges::any_of(result.runs, has_cost)) return;
    throw InputError(result.study.name, cost == Cost::time
                                            ? "no run of this report has a time above zero, which a diagram of errors "
                                              "against time needs; run the study again"
                                            : "no run of this report counts steps or iterations, which a diagram of "
                                              "errors against work needs");
}

Layout layout_of(const Result& result, const Quantity& quantity, Cost cost, const std::vector<double>& errors) {
    const std::string key = quantity.key();
    const bool mixed = cost == Cost::work && units_of(result, key).size() > 1;
    const auto lines = lines_in(result);
    const auto methods = methods_of(result, quantity, cost);
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < lines.size(); ++i)
        curves.push_back(curve_of(result, lines[i], methods[i], key, cost, mixed));
    Layout layout = layout_of(std::move(curves));
    if (!mixed && lines.size() > 1) add_comparison(layout, methods, cost, errors);
    return layout;
}

Words cost_words(const Report& report, const Quantity& quantity, Cost cost) {
    Words words = words_of(report.result, quantity);
    if (cost == Cost::time) {
        words.abscissa = "thread time [s], one machine, this run";
        words.legend =
            fmt::format("{}, set-up included, measuring of errors not; {} {}; {}", repetition_words(report.result),
                        report.provenance.jobs, report.provenance.jobs == 1 ? "job" : "jobs", report.provenance.cpu);
        words.nothing += " and a time above zero";
        return words;
    }
    const auto units = units_of(report.result, quantity.key());
    words.abscissa =
        units.size() > 1 ? "counted work, not the same for all: see the legend" : "counted work" + bracketed(units);
    words.legend = "counts are the same on every machine; what one of them costs differs from solver to solver";
    words.nothing += " and counted work";
    return words;
}

}  // namespace ordo::reports

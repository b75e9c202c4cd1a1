#include "reports/plot/cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::reports {
namespace {

using namespace ordo::studies;

/// It has an error to show, and lacks a cost to show it at.
bool lacks_cost(const Run& run, const std::string& key, Cost cost) {
    return !stopped(run) && drawable(run.error(key)) && !drawable(cost_of(run, cost));
}

/// The series of the result, once each where a study fits them against several abscissae.
std::vector<Series> lines_in(const Result& result) {
    std::vector<Series> lines;
    for (const auto& series : result.series) {
        const auto same = [&](const Series& line) { return line.label == series.label && line.runs == series.runs; };
        if (std::ranges::none_of(lines, same)) lines.push_back(series);
    }
    return lines;
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

Curve curve_of(const Result& result, const Series& series, const std::string& key, Cost cost, bool mixed) {
    const std::string unit = mixed ? bracketed(units_of(result, series, key)) : "";
    const std::string missing = missing_words(result, series, key) + costless_words(result, series, key, cost);
    Curve curve{clipped(series.label, 50) + unit + (missing.empty() ? "" : ":" + missing.substr(1)), {}, {}};
    for (const int id : series.runs) {
        const Run& run = run_of(result, id);
        const Point at{cost_of(run, cost), run.error(key)};
        curve.points.push_back({at, !stopped(run) && drawable(at), true});
    }
    return curve;
}

}  // namespace

std::string text_of(Cost cost) { return cost == Cost::time ? "time" : "work"; }

std::string counted_in(const Run& run) {
    const auto first = [&](auto&& fits) {
        const auto found = std::ranges::find_if(run.work, fits, &RunFigure::name);
        return found == run.work.end() ? std::string() : found->name;
    };
    std::string unit = first([](const std::string& name) { return name.ends_with("_steps"); });
    for (const char* plain : {"iterations", "chop_outs", "cell_updates", "steps"}) {
        if (unit.empty()) unit = first([&](const std::string& name) { return name == plain; });
    }
    return unit;
}

double cost_of(const Run& run, Cost cost) {
    if (cost == Cost::time) return run.seconds;
    const auto found = std::ranges::find(run.work, counted_in(run), &RunFigure::name);
    return found == run.work.end() ? std::nan("") : found->value;
}

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

Layout layout_of(const Result& result, const Quantity& quantity, Cost cost) {
    const std::string key = quantity.key();
    const bool mixed = cost == Cost::work && units_of(result, key).size() > 1;
    std::vector<Curve> curves;
    for (const auto& series : lines_in(result)) curves.push_back(curve_of(result, series, key, cost, mixed));
    return layout_of(std::move(curves));
}

Words cost_words(const Report& report, const Quantity& quantity, Cost cost) {
    Words words = words_of(report.result, quantity);
    if (cost == Cost::time) {
        words.abscissa = "thread time [s], one machine, this run";
        words.legend =
            fmt::format("each run once, set-up included, measuring of errors not; {} {}; {}", report.provenance.jobs,
                        report.provenance.jobs == 1 ? "job" : "jobs", report.provenance.cpu);
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

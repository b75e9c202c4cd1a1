#include "studies/engine/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "studies/order/grid_convergence.hpp"

namespace ordo::studies {
namespace {

const Run& run_of(const std::vector<Run>& runs, int id) { return runs[static_cast<std::size_t>(id)]; }

/// Why a fit leaves this run out; "" where it uses it. A NaN is not left out: the fit refuses it by name.
std::string why_left_out(const Run& run, const std::vector<Condition>& where, const Quantity& quantity,
                         const std::string& abscissa) {
    for (const auto& condition : where) {
        if (!condition.holds(run.axis(condition.axis))) return "outside " + text_of(where);
    }
    if (run.status == Status::reference && quantity.against == Against::finest) return "it is the reference";
    if (run.status != Status::ok && run.status != Status::reference) return text_of(run.status) + ": " + run.reason;
    const std::string counter = counter_of(abscissa);
    return counter.empty() || !std::isnan(run.at(counter)) ? "" : "it counts no '" + counter + "'";
}

SeriesFit fit_of(const Series& series, const Quantity& quantity, const std::vector<Condition>& where,
                 const std::vector<Run>& runs) {
    SeriesFit fit{series.label, quantity.key(), text_of(where), {}, {}, {}, series.abscissa};
    std::vector<FitPoint> points;
    std::vector<GridValue> values;
    for (const int id : series.runs) {
        const Run& run = run_of(runs, id);
        if (auto why = why_left_out(run, where, quantity, series.abscissa); !why.empty()) {
            fit.left_out.push_back({id, std::move(why)});
            continue;
        }
        fit.used.push_back(id);
        points.push_back({run.at(series.abscissa), run.error(quantity.key())});
        values.push_back({points.back().abscissa, points.back().error});
    }
    const bool errors = quantity.against != Against::itself;
    fit.outcome = errors ? fit_order(std::move(points)) : fit_order_of_values(std::move(values));
    for (const auto& [place, why] : fit.outcome.left_out) fit.left_out.push_back({fit.used[place], why});
    for (const auto& [run, why] : fit.left_out) std::erase(fit.used, run);
    return fit;
}

/// The ranges that orders are expected over; one range without limits where none is. What is expected to be exact has
/// no order: its errors are round-off.
std::vector<std::vector<Condition>> ranges_of(const Study& study, const std::string& quantity,
                                              const std::string& solver, const std::string& abscissa) {
    std::vector<std::vector<Condition>> ranges;
    bool exact = false;
    for (const auto& expectation : study.expect) {
        if (!speaks_of(expectation, quantity, solver)) continue;
        exact = exact || expectation.kind == Expectation::Kind::exact_within;
        if (expectation.kind != Expectation::Kind::order || !speaks_along(expectation, abscissa)) continue;
        const auto same = [&](const auto& range) { return text_of(range) == text_of(expectation.where); };
        if (std::none_of(ranges.begin(), ranges.end(), same)) ranges.push_back(expectation.where);
    }
    if (ranges.empty() && !exact) ranges.emplace_back();
    return ranges;
}

bool at_place(const Run& run, const PublishedValue& value) {
    return std::all_of(value.axes.begin(), value.axes.end(),
                       [&](const auto& axis) { return run.axis(axis.first) == axis.second; });
}

PublishedMatch match_of(const Published& table, const PublishedValue& value, const std::vector<Run>& runs) {
    PublishedMatch match{table.id, -1, value.printed, std::nan(""), "", false, table.compare != Compare::none};
    for (const auto& run : runs) {
        if (run.solver != table.solver || !at_place(run, value)) continue;
        match.run = run.id;
        match.ours = run.error(table.quantity);
    }
    if (!std::isfinite(match.ours)) return match;
    const double printed = std::stod(value.printed);
    match.ours_as_printed = as_printed(value.printed, match.ours);
    match.agrees = table.compare == Compare::band ? std::abs(match.ours - printed) <= table.band * std::abs(printed)
                                                  : std::stod(match.ours_as_printed) == printed;
    return match;
}

Verdict overall(const std::vector<Check>& checks) {
    Verdict verdict = Verdict::pass;
    for (const auto& check : checks) {
        if (check.verdict == Verdict::fail) return Verdict::fail;
        if (check.verdict == Verdict::inconclusive) verdict = Verdict::inconclusive;
    }
    return verdict;
}

}  // namespace

bool admits(const Expectation& expectation, const Run& run) {
    return std::ranges::all_of(expectation.where,
                               [&](const Condition& condition) { return condition.holds(run.axis(condition.axis)); });
}

std::string range_text(const std::vector<Condition>& where) { return where.empty() ? "" : " where " + text_of(where); }

bool speaks_of(const Expectation& expectation, const std::string& quantity, const std::string& solver) {
    const auto admits = [](const std::vector<std::string>& names, const std::string& name) {
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    return admits(expectation.quantities, quantity) && admits(expectation.solvers, solver);
}

bool speaks_along(const Expectation& expectation, const std::string& abscissa) {
    return expectation.against.empty() ? abscissa == "h" || abscissa == "dt" : expectation.against == abscissa;
}

std::string as_printed(const std::string& printed, double value) {
    const auto exponent = printed.find_first_of("eE");
    const auto point = printed.find('.');
    const auto end = exponent == std::string::npos ? printed.size() : exponent;
    const std::size_t decimals = point == std::string::npos ? 0 : end - point - 1;
    return exponent == std::string::npos ? fmt::format("{:.{}f}", value, decimals)
                                         : fmt::format("{:.{}e}", value, decimals);
}

std::vector<SeriesFit> fits_of(const Study& study, const std::vector<Run>& runs, const std::vector<Series>& series) {
    std::vector<SeriesFit> fits;
    for (const auto& quantity : study.measure.quantities) {
        if (is_value(quantity.norm)) continue;
        for (const auto& line : series) {
            const auto& solver = run_of(runs, line.runs.front()).solver;
            for (const auto& range : ranges_of(study, quantity.key(), solver, line.abscissa))
                fits.push_back(fit_of(line, quantity, range, runs));
        }
    }
    return fits;
}

std::vector<PublishedMatch> matches_of(const Study& study, const std::vector<Run>& runs) {
    std::vector<PublishedMatch> matches;
    for (const auto& table : study.published) {
        for (const auto& value : table.values) matches.push_back(match_of(table, value, runs));
    }
    return matches;
}

Result judged(const Study& study, std::vector<Run> runs) {
    Result result;
    result.study = study;
    result.runs = std::move(runs);
    result.series = series_of(study, result.runs);
    result.fits = fits_of(study, result.runs, result.series);
    result.published = matches_of(study, result.runs);
    result.checks = checks_of(result);
    result.verdict = overall(result.checks);
    return result;
}

}  // namespace ordo::studies

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.hpp"
#include "studies/engine/judge.hpp"
#include "studies/engine/run.hpp"

namespace ordo::studies {
namespace {

const Run& run_of(const Result& result, int id) { return result.runs[static_cast<std::size_t>(id)]; }

std::string range_text(const std::vector<Condition>& where) { return where.empty() ? "" : " where " + text_of(where); }

std::string found_text(const SeriesFit& fit) {
    if (!fit.outcome.fit) return "no order: " + fit.outcome.refused;
    const OrderFit& order = *fit.outcome.fit;
    return fmt::format("{:.3f} [{:.3f}, {:.3f}], {} points", order.order, order.low, order.high, fit.used.size());
}

/// Passes only inside the band, and with an interval no wider than the band: points that scatter more, or two alone,
/// can fail an order but not prove it.
Verdict order_verdict(const Expectation& expectation, const SeriesFit& fit) {
    if (!fit.outcome.fit) return Verdict::fail;
    if (!(std::abs(fit.outcome.fit->order - expectation.value) <= expectation.within)) return Verdict::fail;
    const bool sharp = fit.outcome.fit->high - fit.outcome.fit->low <= 2 * expectation.within;
    return sharp ? Verdict::pass : Verdict::inconclusive;
}

/// An order that no series can show fails.
void check_orders(const Result& result, const Expectation& expectation, std::vector<Check>& checks) {
    const std::string claim = text_of_order(expectation) +
                              (expectation.against.empty() ? "" : " against " + expectation.against) +
                              range_text(expectation.where);
    const std::size_t before = checks.size();
    for (const auto& fit : result.fits) {
        const auto& solver = run_of(result, fit.used.empty() ? fit.left_out.front().run : fit.used.front()).solver;
        const bool ours = speaks_of(expectation, fit.quantity, solver) && speaks_along(expectation, fit.abscissa);
        if (!ours || fit.where != text_of(expectation.where)) continue;
        checks.push_back({claim, fit.series + ": " + fit.quantity, expectation.source, order_verdict(expectation, fit),
                          found_text(fit)});
    }
    if (checks.size() == before) checks.push_back({claim, "all runs", expectation.source, Verdict::fail, "no series"});
}

bool admits(const Expectation& expectation, const Run& run) {
    return std::all_of(expectation.where.begin(), expectation.where.end(),
                       [&](const Condition& condition) { return condition.holds(run.axis(condition.axis)); });
}

/// Every admitted run of the series has a finite error inside the bound; `error_at_most` does not take a zero for one.
Check bound_check(const Result& result, const Expectation& expectation, const Series& series,
                  const Quantity& quantity) {
    const bool zero_accepted = expectation.kind == Expectation::Kind::exact_within;
    const std::string name = zero_accepted ? "exact within " : "error at most ";
    Check check{name + shortest(expectation.value) + range_text(expectation.where),
                series.label + ": " + quantity.key(), expectation.source, Verdict::pass, ""};
    double worst = -1;
    int runs = 0;
    for (const int id : series.runs) {
        const Run& run = run_of(result, id);
        const bool is_reference = run.status == Status::reference && quantity.against == Against::finest;
        if (is_reference || !admits(expectation, run)) continue;
        ++runs;
        const double error = run.error(quantity.key());
        const bool inside = error <= expectation.value && (zero_accepted ? error >= 0 : error > 0);
        if (!inside) check.verdict = Verdict::fail;
        if (!(error <= worst)) worst = error;
        if (std::isnan(error)) break;
    }
    if (runs == 0) check.verdict = Verdict::fail;
    check.found = runs == 0 ? "no run" : fmt::format("largest {:.4e}", worst);
    return check;
}

void check_bounds(const Result& result, const Expectation& expectation, std::vector<Check>& checks) {
    const auto lines = lines_of(result.study, result.runs);
    for (const auto& quantity : result.study.measure.quantities) {
        for (const auto& series : lines) {
            const auto& solver = run_of(result, series.runs.front()).solver;
            if (speaks_of(expectation, quantity.key(), solver))
                checks.push_back(bound_check(result, expectation, series, quantity));
        }
    }
}

/// Planned runs that are not there, there twice, or there without being planned.
int misplaced(const Result& result) {
    const auto same = [](const RunSpec& spec, const Run& run) {
        return spec.solver.label == run.solver && spec.axes == run.axes;
    };
    const auto planned = specs_of(result.study);
    int wrong = 0;
    for (const auto& spec : planned) {
        wrong +=
            std::count_if(result.runs.begin(), result.runs.end(), [&](const Run& run) { return same(spec, run); }) != 1;
    }
    for (const auto& run : result.runs) {
        wrong += std::none_of(planned.begin(), planned.end(), [&](const RunSpec& spec) { return same(spec, run); });
    }
    return wrong;
}

/// Nothing is measured unless every planned run came to its end, or the study says that it may blow up.
Check ends_check(const Result& result) {
    Check check{"every planned run ends", "all runs", "rule of the house", Verdict::pass, ""};
    const int wrong = misplaced(result);
    int blown_up = 0;
    int broken = 0;
    for (const auto& run : result.runs) {
        blown_up += run.status == Status::diverged;
        broken += run.status == Status::failed || run.status == Status::timed_out;
    }
    if (wrong + broken > 0 || (blown_up > 0 && !result.study.diverged_allowed)) check.verdict = Verdict::fail;
    check.found = fmt::format("{} runs, {} diverged{}, {} failed, {} missing or repeated", result.runs.size(), blown_up,
                              result.study.diverged_allowed ? " (allowed)" : "", broken, wrong);
    return check;
}

/// Abscissae of all that the runs count.
std::vector<std::string> counters_of(const Result& result) {
    std::set<std::string> names;
    for (const auto& run : result.runs) {
        for (const auto& [name, value] : run.work) names.insert("1/" + name);
    }
    return {names.begin(), names.end()};
}

Check published_check(const Result& result, const Published& table) {
    std::size_t agree = 0;
    for (const auto& match : result.published) agree += match.table == table.id && match.agrees;
    const std::string how =
        table.compare == Compare::digits ? "to every printed digit" : fmt::format("within {} relative", table.band);
    const Verdict verdict = agree == table.values.size() ? Verdict::pass : Verdict::fail;
    return {fmt::format("{} printed values {}", table.values.size(), how), "table " + table.id + ": " + table.quantity,
            table.source, verdict, fmt::format("{} of {}", agree, table.values.size())};
}

}  // namespace

std::vector<Check> checks_of(const Result& result) {
    std::vector<Check> checks{ends_check(result)};
    for (const auto& abscissa : result.study.measure.orders_against) {
        const auto counts = [&](const Run& run) { return !std::isnan(run.at(abscissa)); };
        if (!result.runs.empty() && std::ranges::none_of(result.runs, counts))
            checks.push_back({"orders against " + abscissa, "all runs", "rule of the house", Verdict::fail,
                              "no run counts it; counted are " + joined(counters_of(result))});
    }
    for (const auto& expectation : result.study.expect) {
        if (expectation.kind == Expectation::Kind::order) check_orders(result, expectation, checks);
        else check_bounds(result, expectation, checks);
    }
    for (const auto& table : result.study.published) {
        if (table.compare != Compare::none) checks.push_back(published_check(result, table));
    }
    if (checks.size() == 1) {
        checks.push_back({"at least one expectation", "the study", "rule of the house", Verdict::inconclusive,
                          "the study expects nothing"});
    }
    return checks;
}

}  // namespace ordo::studies

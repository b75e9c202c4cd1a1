#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/text.hpp"
#include "studies/engine/decided.hpp"
#include "studies/engine/judge.hpp"
#include "studies/engine/order_check.hpp"
#include "studies/engine/run.hpp"
#include "studies/engine/value_check.hpp"

namespace ordo::studies {
namespace {

const Run& run_of(const Result& result, int id) { return result.runs[static_cast<std::size_t>(id)]; }

/// Whether the expectation's range holds a run of the fit's series; a range of other axes may leave none.
bool admits_any(const Result& result, const Expectation& expectation, const SeriesFit& fit) {
    const auto admitted = [&](const LeftOut& left_out) { return admits(expectation, run_of(result, left_out.run)); };
    return !fit.used.empty() || std::ranges::any_of(fit.left_out, admitted);
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
        if (!ours || fit.where != text_of(expectation.where) || !admits_any(result, expectation, fit)) continue;
        checks.push_back(order_check(expectation, fit, claim));
    }
    if (checks.size() == before)
        checks.push_back({claim, "all runs", expectation.source, Verdict::fail, "no series", Fault::no_such_series});
}

/// What keeps an error from being inside its bound; a zero is no error at most, exactness is expected by its own name.
Fault fault_of_error(double error, const Expectation& expectation) {
    if (std::isnan(error)) return Fault::error_is_nan;
    if (std::isinf(error)) return Fault::error_is_infinite;
    if (error < 0) return Fault::error_is_negative;
    if (error == 0 && expectation.kind != Expectation::Kind::exact_within) return Fault::error_is_zero;
    return error <= expectation.value ? Fault::none : Fault::error_too_large;
}

std::string bound_claim(const Expectation& expectation) {
    const std::string name = expectation.kind == Expectation::Kind::exact_within ? "exact within " : "error at most ";
    return name + shortest(expectation.value) + range_text(expectation.where);
}

/// Every admitted run of the series has a finite error inside the bound; nothing where none is admitted.
std::optional<Check> bound_check(const Result& result, const Expectation& expectation, const Series& series,
                                 const Quantity& quantity) {
    Check check{bound_claim(expectation), series.label + ": " + quantity.key(), expectation.source, Verdict::pass, ""};
    double worst = -1;
    int runs = 0;
    for (const int id : series.runs) {
        const Run& run = run_of(result, id);
        const bool is_reference = run.status == Status::reference && quantity.against == Against::finest;
        if (is_reference || run.status == Status::skipped || !admits(expectation, run)) continue;
        ++runs;
        const double error = run.error(quantity.key());
        if (check.fault == Fault::none) check.fault = fault_of_error(error, expectation);
        if (!(error <= worst)) worst = error;
        if (std::isnan(error)) break;
    }
    if (runs == 0) return {};
    if (check.fault != Fault::none) check.verdict = Verdict::fail;
    check.found = fmt::format("largest {:.4e}", worst);
    if (check.fault == Fault::error_is_zero) check.found += "; an error is zero, which is expected by exact_within";
    return check;
}

void check_bounds(const Result& result, const Expectation& expectation, std::vector<Check>& checks) {
    const auto lines = lines_of(result.study, result.runs);
    const std::size_t before = checks.size();
    for (const auto& quantity : result.study.measure.quantities) {
        for (const auto& series : lines) {
            const auto& solver = run_of(result, series.runs.front()).solver;
            if (!speaks_of(expectation, quantity.key(), solver)) continue;
            if (auto check = bound_check(result, expectation, series, quantity)) checks.push_back(std::move(*check));
        }
    }
    if (checks.size() == before)
        checks.push_back(
            {bound_claim(expectation), "all runs", expectation.source, Verdict::fail, "no run", Fault::no_such_series});
}

/// Planned runs that are not there, runs that are there twice or without being planned, and runs that were not made as
/// planned.
struct Misplaced {
    long missing = 0;
    long repeated = 0;
    long off_plan = 0;
};

bool is_finest(const Quantity& quantity) { return quantity.against == Against::finest; }

/// Time, mesh width and step of the run are those of its plan, to the rounding that machines differ by.
bool as_planned(const RunSpec& spec, const Run& run) {
    const auto alike = [](double found, double planned) {
        return std::abs(found - planned) <= 1e-12 * std::abs(planned);
    };
    const bool compared = run.status != Status::reference || std::ranges::any_of(spec.measure.quantities, is_finest);
    return compared && alike(run.t, spec.t_end) && alike(run.h, spec.plan.h) && alike(run.dt, step_taken(spec));
}

Misplaced misplaced(const Result& result) {
    const auto same = [](const RunSpec& spec, const Run& run) {
        return spec.solver.label == run.solver && spec.axes == run.axes;
    };
    const auto planned = specs_of(result.study);
    Misplaced wrong;
    for (const auto& spec : planned) {
        const long there = std::ranges::count_if(result.runs, [&](const Run& run) { return same(spec, run); });
        wrong.missing += there == 0;
        wrong.repeated += there > 1;
        wrong.off_plan +=
            std::ranges::any_of(result.runs, [&](const Run& run) { return same(spec, run) && !as_planned(spec, run); });
    }
    for (const auto& run : result.runs) {
        wrong.repeated += std::ranges::none_of(planned, [&](const RunSpec& spec) { return same(spec, run); });
    }
    return wrong;
}

/// What is wrong with an error of a run that came to its end, whether an expectation speaks of it or not. The place of
/// a wave that a coarse answer does not show is no number, and only an expectation asks for it.
Fault no_error(const Result& result) {
    for (const auto& quantity : result.study.measure.quantities) {
        if (is_place(quantity.norm) || is_value(quantity.norm)) continue;
        for (const auto& run : result.runs) {
            const bool is_reference = run.status == Status::reference && quantity.against == Against::finest;
            if ((run.status != Status::ok && run.status != Status::reference) || is_reference) continue;
            const double error = run.error(quantity.key());
            if (!std::isfinite(error)) return std::isnan(error) ? Fault::error_is_nan : Fault::error_is_infinite;
            if (error < 0) return Fault::error_is_negative;
        }
    }
    return Fault::none;
}

/// Nothing is measured unless every planned run came to its end, or the study says that it may blow up.
Check ends_check(const Result& result) {
    const auto [missing, repeated, off_plan] = misplaced(result);
    const auto ended = [&](Status status) { return std::ranges::count(result.runs, status, &Run::status); };
    const auto blown_up = ended(Status::diverged);
    const auto late = ended(Status::timed_out);
    const auto broken = ended(Status::failed) + (result.study.time_out_allowed ? 0 : late);
    const auto skipped = ended(Status::skipped);
    Check check{"every planned run ends", "all runs", "rule of the house", Verdict::pass, ""};
    if (blown_up > 0 && !result.study.diverged_allowed) check.fault = Fault::run_diverged;
    if (broken > 0) check.fault = Fault::run_failed;
    const Fault unmeasured = no_error(result);
    if (unmeasured != Fault::none) check.fault = unmeasured;
    if (off_plan > 0) check.fault = Fault::off_plan;
    if (repeated > 0) check.fault = Fault::point_repeated;
    if (missing > 0 || skipped_wrongly(result.study, result.runs) > 0) check.fault = Fault::point_missing;
    if (result.runs.empty()) check.fault = Fault::nothing_measured;
    if (check.fault != Fault::none) check.verdict = Verdict::fail;
    check.found =
        fmt::format("{} runs, {} diverged{}, {} failed{}, {} missing, {} repeated or not planned, {} off their plan{}",
                    result.runs.size(), blown_up, result.study.diverged_allowed ? " (allowed)" : "", broken,
                    result.study.time_out_allowed ? fmt::format(", {} timed out (allowed)", late) : "", missing,
                    repeated, off_plan, unmeasured == Fault::none ? "" : "; " + text_of(unmeasured));
    if (skipped > 0) check.found += fmt::format(", {} skipped", skipped);
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
    const bool all = agree == table.values.size();
    return {fmt::format("{} printed values {}", table.values.size(), how),
            "table " + table.id + ": " + table.quantity,
            table.source,
            all ? Verdict::pass : Verdict::fail,
            fmt::format("{} of {}", agree, table.values.size()),
            all ? Fault::none : Fault::published_differs};
}

}  // namespace

std::vector<Check> checks_of(const Result& result) {
    std::vector<Check> checks{ends_check(result)};
    for (const auto& abscissa : result.study.measure.orders_against) {
        const auto counts = [&](const Run& run) { return !std::isnan(run.at(abscissa)); };
        if (!result.runs.empty() && std::ranges::none_of(result.runs, counts))
            checks.push_back({"orders against " + abscissa, "all runs", "rule of the house", Verdict::fail,
                              "no run counts it; counted are " + joined(counters_of(result)), Fault::no_such_series});
    }
    for (const auto& expectation : result.study.expect) {
        using Kind = Expectation::Kind;
        if (expectation.kind == Kind::order) check_orders(result, expectation, checks);
        else if (expectation.kind == Kind::value || expectation.kind == Kind::agreement)
            check_values(result, expectation, checks);
        else check_bounds(result, expectation, checks);
    }
    for (const auto& table : result.study.published) {
        if (table.compare != Compare::none) checks.push_back(published_check(result, table));
    }
    if (checks.size() == 1) {
        checks.push_back({"at least one expectation", "the study", "rule of the house", Verdict::inconclusive,
                          "the study expects nothing", Fault::expects_nothing});
    }
    return checks;
}

}  // namespace ordo::studies

#include "reports/table/rank.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "reports/cost/methods.hpp"
#include "reports/plot/cost.hpp"
#include "reports/table/write.hpp"
#include "reports/view.hpp"

namespace ordo::reports {
namespace {

/// The methods of one report for one quantity.
struct Contest {
    const Report* report = nullptr;
    studies::Quantity quantity;
    std::vector<Method> methods;
};

std::vector<Contest> contests_of(const std::vector<Report>& reports) {
    std::vector<Contest> contests;
    for (const auto& report : reports) {
        refuse_without(report.result, Cost::time);
        for (const auto& quantity : report.result.study.measure.quantities) {
            if (quantity.against == studies::Against::itself) continue;
            contests.push_back({&report, quantity, methods_of(report.result, quantity, Cost::time)});
        }
    }
    return contests;
}

std::string seconds_text(double seconds) { return fmt::format("{:.1e}", seconds); }

std::string time_text(const Method& method, const CostToError& cost) {
    switch (cost.reached) {
        case Reached::between: return seconds_text(cost.cost);
        case Reached::at_most: return "<= " + seconds_text(cost.cost);
        case Reached::never: break;
    }
    return method.limit > 0 ? fmt::format("not in {:.2g} s", method.limit) : "not run";
}

/// "cells 64"
std::string resolution_text(const Contest& contest, const Method& method, const Reach& reach) {
    if (reach.run < 0) return "-";
    return spoken(method.shown) + " " + shortest(run_of(contest.report->result, reach.run).at(method.shown));
}

/// 1 for the fastest at this error; 0 for who does not reach it.
std::size_t place_of(const std::vector<std::size_t>& order, std::size_t method) {
    const auto found = std::ranges::find(order, method);
    return found == order.end() ? 0 : static_cast<std::size_t>(found - order.begin()) + 1;
}

std::string heading_of(const Contest& contest) {
    const auto& result = contest.report->result;
    return result.study.name + ": " + error_words(contest.quantity) + unit_words(contest.quantity) + " " +
           time_words(result, contest.quantity);
}

/// How often runs were repeated, how much their times scatter, and where.
std::string timing_note(const Report& report) {
    std::vector<double> spreads;
    for (const auto& run : report.result.runs) {
        if (run.repeats && std::isfinite(run.repeats->spread)) spreads.push_back(run.repeats->spread);
    }
    if (spreads.empty()) return "each run was timed once; ordo run --time repeats them";
    std::ranges::sort(spreads);
    return fmt::format(
        "times are medians of repeated runs, one at a time; their spread is {:.1g} % (median of the runs), "
        "{:.2g} % at most; {}",
        100 * spreads[spreads.size() / 2], 100 * spreads.back(), report.provenance.cpu);
}

std::string error_head(double error) { return "error " + shortest(error); }

/// Who is fastest in each contest.
Table fastest(const std::vector<Contest>& contests, const std::vector<double>& errors) {
    Table table{"fastest method at each error, its thread time [s] and its resolution", "study", {}, {}, {}};
    for (const double error : errors) table.groups.push_back({error_head(error), {{"method"}, {"time"}, {"at"}}});
    for (const auto& contest : contests) {
        Row row{contest.report->result.study.name, {}};
        for (const double error : errors) {
            const auto order = ranked_at(contest.methods, error);
            if (order.empty()) {
                const auto longest = std::ranges::max(contest.methods, {}, &Method::limit).limit;
                row.cells.insert(row.cells.end(), {{"none"}, {fmt::format("not in {:.2g} s", longest)}, {"-"}});
                continue;
            }
            const Method& method = contest.methods[order.front()];
            const Reach reach = reach_of(method, error);
            row.cells.insert(
                row.cells.end(),
                {{method.label}, {time_text(method, reach.cost)}, {resolution_text(contest, method, reach)}});
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

/// All methods of a contest: who reaches the smallest errors stands first, of these the fastest.
Table places(const Contest& contest, std::vector<double> errors) {
    Table table{heading_of(contest), "method", {}, {}, {}};
    std::vector<std::vector<std::size_t>> orders;
    for (const double error : errors) {
        table.groups.push_back({error_head(error), {{"place"}, {"time [s]"}, {"at"}}});
        orders.push_back(ranked_at(contest.methods, error));
    }
    std::vector<std::size_t> rows(contest.methods.size());
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = k;
    for (std::size_t e = 0; e < errors.size(); ++e) {
        std::ranges::stable_sort(rows, {}, [&](std::size_t k) {
            const std::size_t place = place_of(orders[e], k);
            return place == 0 ? contest.methods.size() + 1 : place;
        });
    }
    for (const std::size_t k : rows) {
        const Method& method = contest.methods[k];
        Row row{method.label, {}};
        for (std::size_t e = 0; e < errors.size(); ++e) {
            const std::size_t place = place_of(orders[e], k);
            const Reach reach = reach_of(method, errors[e]);
            row.cells.insert(row.cells.end(), {{place == 0 ? "-" : std::to_string(place)},
                                               {time_text(method, reach.cost)},
                                               {resolution_text(contest, method, reach)}});
        }
        table.rows.push_back(std::move(row));
    }
    for (const auto& [at, before, after] : lead_changes(contest.methods))
        table.notes.push_back(fmt::format("crossover at {} s, error {:.1e}: up to there {}, from there {}",
                                          seconds_text(at.cost), at.error, contest.methods[before].label,
                                          contest.methods[after].label));
    table.notes.push_back(timing_note(*contest.report));
    return table;
}

std::string reached_text(Reached reached) {
    switch (reached) {
        case Reached::between: return "reached";
        case Reached::at_most: return "at_most";
        case Reached::never: break;
    }
    return "not_reached";
}

/// The time looked at, where it was not reached, stands as `limit`.
std::string as_csv(const std::vector<Contest>& contests, const std::vector<double>& errors) {
    std::string text =
        csv_row({"study", "quantity", "method", "error", "place", "reached", "seconds", "axis", "resolution", "limit"});
    for (const auto& contest : contests) {
        for (const double error : errors) {
            const auto order = ranked_at(contest.methods, error);
            for (std::size_t k = 0; k < contest.methods.size(); ++k) {
                const Method& method = contest.methods[k];
                const Reach reach = reach_of(method, error);
                const bool there = reach.run >= 0;
                text += csv_row({contest.report->result.study.name, contest.quantity.key(), method.label,
                                 shortest(error), there ? std::to_string(place_of(order, k)) : "",
                                 reached_text(reach.cost.reached), there ? shortest(reach.cost.cost) : "", method.shown,
                                 there ? shortest(run_of(contest.report->result, reach.run).at(method.shown)) : "",
                                 shortest(method.limit)});
            }
        }
    }
    return text;
}

}  // namespace

std::string ranking(const std::vector<Report>& reports, const std::vector<double>& errors, TableFormat format) {
    const auto contests = contests_of(reports);
    if (format == TableFormat::csv) return as_csv(contests, errors);
    TableModel model{"time to reach an error", "", {fastest(contests, errors)}, {}, ""};
    for (const auto& contest : contests) model.tables.push_back(places(contest, errors));
    return written(model, format);
}

}  // namespace ordo::reports

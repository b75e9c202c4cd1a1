#include "reports/table/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>

#include "core/text.hpp"
#include "reports/order_view.hpp"
#include "reports/table/numbers.hpp"
#include "reports/view.hpp"
#include "studies/engine/extrapolated.hpp"
#include "studies/engine/joint.hpp"

namespace ordo::reports {
namespace {

using namespace ordo::studies;

/// The place of a run in its table. `repeat` counts earlier runs of the series at the same place, so that none is
/// hidden.
struct Place {
    double shown = 0;
    int repeat = 0;
    double abscissa = 0;  ///< orders the rows

    /// Of the row, whatever its abscissa: one Courant number is another step on each mesh.
    bool operator==(const Place& other) const {
        return std::strong_order(shown, other.shown) == 0 && repeat == other.repeat;
    }
};

bool coarser(const Place& a, const Place& b) {
    const auto by_abscissa = std::strong_order(b.abscissa, a.abscissa);
    return by_abscissa != 0 ? by_abscissa < 0 : a.repeat < b.repeat;
}

/// Of a run that did not count what is shown.
bool is_none(const Place& place) { return std::isnan(place.shown) && std::isnan(place.abscissa); }

/// The places of the series' runs, in the order of the runs.
std::vector<Place> places_of(const Result& result, const Series& series) {
    std::vector<Place> places;
    for (const int id : series.runs) {
        const Run& run = run_of(result, id);
        Place place{run.at(series.shown), 0, run.at(series.abscissa)};
        while (std::ranges::find(places, place) != places.end()) ++place.repeat;
        places.push_back(place);
    }
    return places;
}

/// All places of all series, coarse to fine; a place that they share counts with its coarsest abscissa.
std::vector<Place> rows_of(const Result& result, const View& view) {
    std::vector<Place> rows;
    for (const Series* series : view.series) {
        for (const Place& place : places_of(result, *series)) {
            if (is_none(place)) continue;
            const auto found = std::ranges::find(rows, place);
            if (found == rows.end()) rows.push_back(place);
            else found->abscissa = std::max(found->abscissa, place.abscissa);
        }
    }
    std::ranges::sort(rows, coarser);
    return rows;
}

const PublishedMatch* match_at(const Result& result, const std::string& table, int run) {
    const auto found = std::ranges::find_if(
        result.published, [&](const PublishedMatch& match) { return match.table == table && match.run == run; });
    return found == result.published.end() ? nullptr : &*found;
}

/// Ids of the published tables of this quantity that have a value in this series.
std::vector<std::string> tables_beside(const Result& result, const View& view, const Series& series) {
    std::vector<std::string> ids;
    for (const auto& published : result.study.published) {
        const auto has_value = [&](int run) { return match_at(result, published.id, run) != nullptr; };
        if (published.quantity == view.quantity.key() && std::ranges::any_of(series.runs, has_value)) {
            ids.push_back(published.id);
        }
    }
    return ids;
}

/// The error to four decimals, or with the digits of the printed value; the status where the run has no error.
std::string error_text(const Run& run, double error, const PublishedMatch* match) {
    if (stopped(run) || (run.status == Status::reference && std::isnan(error))) return text_of(run.status);
    if (match != nullptr && std::isfinite(error)) return match->ours_as_printed;
    return std::isfinite(error) ? fmt::format("{:.4e}", error) : shortest(error);
}

Cell printed_cell(const PublishedMatch* match) {
    if (match == nullptr) return {};
    return {match->printed, !match->judged ? ' ' : match->agrees ? '=' : '!'};
}

/// Order from the coarser run of the series to this one; "-" where there is none or one of them has no error.
std::string order_text(const View& view, const Run* coarse, const Run& fine) {
    if (view.quantity.against == Against::itself) return "-";  // neighbours have an order by threes only
    if (coarse == nullptr || stopped(*coarse) || stopped(fine)) return "-";
    const std::string key = view.quantity.key();
    const double order =
        neighbour_order({coarse->at(view.abscissa), coarse->error(key)}, {fine.at(view.abscissa), fine.error(key)});
    return std::isfinite(order) ? decimal(order, 2) : "-";
}

Group group_of(const Series& series, const std::vector<std::string>& printed) {
    Group group{series.label, {{"error"}}};
    for (const auto& id : printed) group.columns.push_back({id, true});
    group.columns.push_back({"order"});
    return group;
}

/// Appends the columns of one series to the table.
void add_series(Table& table, const Result& result, const View& view, const Series& series,
                const std::vector<Place>& rows) {
    const auto printed = tables_beside(result, view, series);
    const auto places = places_of(result, series);
    if (std::ranges::all_of(places, is_none)) return;
    table.groups.push_back(group_of(series, printed));
    const Run* coarser_run = nullptr;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        auto& cells = table.rows[i].cells;
        const auto found = std::ranges::find(places, rows[i]);
        if (found == places.end()) {
            cells.resize(cells.size() + printed.size() + 2);
            continue;
        }
        const Run& run = run_of(result, series.runs[static_cast<std::size_t>(found - places.begin())]);
        const auto match = printed.empty() ? nullptr : match_at(result, printed.front(), run.id);
        cells.push_back({error_text(run, run.error(view.quantity.key()), match)});
        for (const auto& id : printed) cells.push_back(printed_cell(match_at(result, id, run.id)));
        cells.push_back({order_text(view, coarser_run, run)});
        coarser_run = &run;
    }
}

std::string place_text(double shown) { return fmt::format("{:.8g}", shown); }

/// "64"; "none at delta = 0.001, ppc = 4" for a run that did not count what is shown.
std::string point_words(const Result& result, const Series& series, int id) {
    const Run& run = run_of(result, id);
    if (!std::isnan(run.at(series.abscissa))) return place_text(run.at(series.shown));
    std::vector<std::string> axes;
    for (const auto& axis : run.axes) axes.push_back(axis.name + " = " + shortest(axis.value));
    return "none at " + joined(axes);
}

/// "64, 128 (not where cells <= 32); 256 (diverged)": neighbours with one reason stand together.
std::string left_out_words(const Result& result, const Series& series, const std::vector<LeftOut>& left_out) {
    std::string text;
    for (std::size_t i = 0; i < left_out.size(); ++i) {
        text += (text.empty() ? "" : ", ") + point_words(result, series, left_out[i].run);
        const bool last = i + 1 == left_out.size() || left_out[i + 1].why != left_out[i].why;
        if (last) text += " (" + left_out[i].why + ")";
    }
    return text;
}

std::string fit_line(const Result& result, const Series& series, const SeriesFit& fit) {
    std::string line = series.label + (fit.where.empty() ? "" : " where " + fit.where) + ": ";
    line += fit.outcome.fit ? "order " + order_words(*fit.outcome.fit) : "no order";
    line += ", " + studies::text_of(fit.outcome.verdict) + ": " + fit.outcome.reason;
    std::vector<std::string> points;
    for (const int run : fit.used) points.push_back(point_words(result, series, run));
    if (!points.empty()) line += "; points " + series.shown + " = " + joined(points);
    if (!fit.left_out.empty()) {
        line += "; left out " + series.shown + " = " + left_out_words(result, series, fit.left_out);
    }
    return line;
}

std::vector<std::string> notes_of(const Result& result, const View& view) {
    std::vector<std::string> notes;
    for (const Series* series : view.series) {
        for (const int id : series->runs) {
            const Run& run = run_of(result, id);
            if (!stopped(run)) continue;
            notes.push_back(series->label + ", " + series->shown + " = " + point_words(result, *series, id) + ": " +
                            text_of(run.status) + (run.reason.empty() ? "" : ", " + run.reason));
        }
    }
    for (const Series* series : view.series) {
        for (const SeriesFit* fit : fits_along(result, view, *series)) {
            notes.push_back(fit_line(result, *series, *fit));
        }
    }
    for (const auto& found : extrapolations_of(result)) {
        if (found.quantity != view.quantity.key() || found.abscissa != view.abscissa) continue;
        for (const auto& method : found.methods) notes.push_back(found.series + ": " + line_of(method));
    }
    return notes;
}

std::string published_line(const Result& result, const Published& published) {
    int values = 0, judged = 0, agree = 0, without_run = 0;
    for (const auto& match : result.published) {
        if (match.table != published.id) continue;
        ++values;
        judged += match.judged ? 1 : 0;
        agree += match.judged && match.agrees ? 1 : 0;
        without_run += match.run < 0 ? 1 : 0;
    }
    std::string line = published.id + ": ";
    if (judged == 0) {
        line += fmt::format("{} printed values, not judged: {}", values, published.because);
    } else if (published.compare == Compare::band) {
        line += fmt::format("{} of {} printed values met within {:g} %", agree, judged, 100 * published.band);
    } else {
        line += fmt::format("{} of {} printed values reproduced to every digit", agree, judged);
    }
    if (without_run > 0) line += fmt::format("; {} without a run", without_run);
    return line;
}

Table table_of(const Result& result, const View& view) {
    const std::string unit = view.shown == "dt" ? " [s]" : view.shown == "h" ? " [m]" : "";
    Table table;
    table.title = error_words(view.quantity) + unit_words(view.quantity) + " " + time_words(result, view.quantity);
    if (!counter_of(view.abscissa).empty()) table.title += ", order against " + view.abscissa;
    table.place_head = view.shown + unit;
    const auto rows = rows_of(result, view);
    for (const auto& place : rows) table.rows.push_back({place_text(place.shown), {}});
    for (const Series* series : view.series) add_series(table, result, view, *series, rows);
    table.notes = notes_of(result, view);
    return table;
}

/// Characters across the columns of one group, two between columns and four before the group.
std::size_t group_width(const Table& table, const Group& group, std::size_t first_cell) {
    std::size_t sum = 2;
    for (std::size_t i = 0; i < group.columns.size(); ++i) {
        std::size_t widest = width_of(group.columns[i].head);
        for (const auto& row : table.rows) widest = std::max(widest, width_of(row.cells[first_cell + i].text));
        sum += 2 + widest + (group.columns[i].marked ? 2 : 0);
    }
    return std::max(sum, width_of(group.label) + 4);
}

}  // namespace

TableModel table_model(const Report& report) {
    const Result& result = report.result;
    TableModel model{result.study.name, result.study.about, {}, {}, text_of(result.verdict)};
    if (gives_numbers(result.study)) model.tables.push_back(number_table(result));
    else
        for (const auto& view : views_of(result)) model.tables.push_back(table_of(result, view));
    for (const auto& joint : joint_fits_of(result.study, result.runs)) {
        const std::string subject = "joint fit of " + joint.quantity + ", " + joint.grid + ": ";
        for (const auto& line : lines_of(joint.fit)) model.verdicts.push_back(subject + line);
    }
    for (const auto& check : result.checks) {
        model.verdicts.push_back(text_of(check.verdict) + ": " + check.claim + "; " + check.subject + "; " +
                                 check.found);
    }
    for (const auto& published : result.study.published) model.verdicts.push_back(published_line(result, published));
    return model;
}

std::vector<Table> panels(const Table& table, std::size_t widest) {
    Table blank{table.title, table.place_head, {}, {}, {}};
    std::size_t place_width = width_of(table.place_head);
    for (const auto& row : table.rows) {
        blank.rows.push_back({row.place, {}});
        place_width = std::max(place_width, width_of(row.place));
    }
    std::vector<Table> all;
    std::size_t width = 0;
    std::size_t cell = 0;
    for (const auto& group : table.groups) {
        const std::size_t added = group_width(table, group, cell);
        const bool next = all.empty() || width + added > widest;
        if (next) all.push_back(blank);
        width = (next ? place_width : width) + added;
        Table& panel = all.back();
        panel.groups.push_back(group);
        for (std::size_t end = cell + group.columns.size(); cell < end; ++cell) {
            for (std::size_t r = 0; r < table.rows.size(); ++r)
                panel.rows[r].cells.push_back(table.rows[r].cells[cell]);
        }
    }
    return all;
}

}  // namespace ordo::reports

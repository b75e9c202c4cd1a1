#include "reports/table/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "reports/view.hpp"

namespace ordo::reports {
namespace {

using namespace ordo::studies;

std::string number_text(const Run& run, double value) {
    if (stopped(run)) return text_of(run.status);
    return std::isfinite(value) ? fmt::format("{:.5g}", value) : "-";
}

/// Published tables of this quantity.
std::vector<const Published*> tables_of(const Study& study, const Quantity& quantity) {
    std::vector<const Published*> tables;
    for (const auto& table : study.published) {
        if (table.quantity == quantity.key()) tables.push_back(&table);
    }
    return tables;
}

Cell printed_cell(const Result& result, const std::string& table, int run) {
    for (const auto& match : result.published) {
        if (match.table == table && match.run == run)
            return {match.printed, !match.judged ? ' ' : match.agrees ? '=' : '!'};
    }
    return {};
}

std::string place_of(const Run& run) {
    std::vector<std::string> axes;
    for (const auto& axis : run.axes) axes.push_back(axis.name + " = " + shortest(axis.value));
    return run.solver + (axes.empty() ? "" : ", " + joined(axes));
}

}  // namespace

bool gives_numbers(const Study& study) {
    return std::ranges::all_of(study.measure.quantities, is_value, &Quantity::norm);
}

Table number_table(const Result& result) {
    Table table{.title = "", .place_head = "run", .groups = {}, .rows = {}, .notes = {}};
    for (const Run& run : result.runs) table.rows.push_back({place_of(run), {}});
    for (const auto& quantity : result.study.measure.quantities) {
        Group group{spoken(quantity.key()), {{"found"}}};
        const auto tables = tables_of(result.study, quantity);
        for (const auto* printed : tables) group.columns.push_back({printed->id, true});
        for (std::size_t i = 0; i < result.runs.size(); ++i) {
            const Run& run = result.runs[i];
            table.rows[i].cells.push_back({number_text(run, run.error(quantity.key()))});
            for (const auto* printed : tables) table.rows[i].cells.push_back(printed_cell(result, printed->id, run.id));
        }
        table.groups.push_back(std::move(group));
        table.title += (table.title.empty() ? "" : "; ") + spoken(quantity.key()) + ": " + error_words(quantity);
    }
    for (const Run& run : result.runs) {
        if (!run.reason.empty()) table.notes.push_back(place_of(run) + ": " + run.reason);
    }
    return table;
}

}  // namespace ordo::reports

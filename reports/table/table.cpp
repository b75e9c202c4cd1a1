#include "reports/table/table.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "reports/table/write.hpp"

namespace ordo::reports {
namespace {

std::vector<std::string> axis_names(const studies::Result& result) {
    std::vector<std::string> names;
    for (const auto& run : result.runs) {
        for (const auto& axis : run.axes) {
            if (std::ranges::find(names, axis.name) == names.end()) names.push_back(axis.name);
        }
    }
    return names;
}

/// A swept dt is not always the step that was taken, so it gets a head of its own.
std::string axis_head(const std::string& axis) { return axis == "dt" || axis == "h" ? "swept_" + axis : axis; }

std::string swept_value(const studies::Run& run, const std::string& axis) {
    const auto found = std::ranges::find(run.axes, axis, &studies::RunFigure::name);
    return found == run.axes.end() ? "" : shortest(found->value);
}

/// One row a run and quantity.
std::string as_csv(const studies::Result& result) {
    const auto axes = axis_names(result);
    std::vector<std::string> heads{"study", "solver"};
    for (const auto& axis : axes) heads.push_back(axis_head(axis));
    heads.insert(heads.end(), {"h", "dt", "t", "status", "reason", "quantity", "error"});
    std::string text = csv_row(heads);
    for (const auto& run : result.runs) {
        for (const auto& quantity : result.study.measure.quantities) {
            std::vector<std::string> cells{result.study.name, run.solver};
            for (const auto& axis : axes) cells.push_back(swept_value(run, axis));
            cells.insert(cells.end(), {shortest(run.h), shortest(run.dt), shortest(run.t), studies::text_of(run.status),
                                       run.reason, quantity.key(), shortest(run.error(quantity.key()))});
            text += csv_row(cells);
        }
    }
    return text;
}

}  // namespace

std::string table(const Report& report, TableFormat format) {
    return format == TableFormat::csv ? as_csv(report.result) : written(table_model(report), format);
}

}  // namespace ordo::reports

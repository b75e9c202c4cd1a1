#include "app/columns.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::app {
namespace {

std::string as_cell(const Column& column, std::size_t row) {
    if (!column.words.empty()) return column.words[row];
    return std::isnan(column.values[row]) ? "" : seventeen_digits(column.values[row]);
}

std::string as_member(const Column& column, std::size_t row) {
    if (!column.words.empty()) return '"' + column.words[row] + '"';
    return std::isfinite(column.values[row]) ? seventeen_digits(column.values[row]) : "null";
}

std::string as_csv(const std::vector<Column>& columns, std::size_t rows) {
    std::string text;
    for (const auto& column : columns) text += (text.empty() ? "" : ",") + column.name;
    text += '\n';
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t k = 0; k < columns.size(); ++k) text += (k == 0 ? "" : ",") + as_cell(columns[k], row);
        text += '\n';
    }
    return text;
}

std::string as_json(const std::vector<Column>& columns, std::size_t rows) {
    std::string text = "[\n";
    for (std::size_t row = 0; row < rows; ++row) {
        text += " {";
        for (std::size_t k = 0; k < columns.size(); ++k)
            text += (k == 0 ? "\"" : ", \"") + columns[k].name + "\": " + as_member(columns[k], row);
        text += row + 1 < rows ? "},\n" : "}\n";
    }
    return text + "]\n";
}

}  // namespace

std::string columns_as(const std::string& format, const std::vector<Column>& columns, const std::string& where) {
    const std::size_t rows =
        columns.empty() ? 0 : std::max(columns.front().values.size(), columns.front().words.size());
    if (format == "csv") return as_csv(columns, rows);
    if (format == "json") return as_json(columns, rows);
    const std::vector<std::string> formats{"csv", "json"};
    throw InputError(where + " --format", "there is no format '" + format + "'" + did_you_mean(format, formats));
}

std::vector<std::string> component_names(const std::string& field, int components, int dim) {
    if (components == 1) return {field};
    const std::string axes = "xyz";
    std::vector<std::string> names;
    for (std::size_t k = 0; k < static_cast<std::size_t>(components); ++k) {
        const auto width = static_cast<std::size_t>(dim);
        names.push_back(field + "_" + (components > dim ? std::string{axes[k / width]} : "") + axes[k % width]);
    }
    return names;
}

}  // namespace ordo::app

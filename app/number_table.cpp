#include "app/number_table.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::app {
namespace {

/// Without blanks and quotes around it.
std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r\"");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    if (line.find(',') == std::string::npos) {
        for (std::string cell; stream >> cell;) cells.push_back(trimmed(cell));
        return cells;
    }
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(trimmed(cell));
    if (line.ends_with(',')) cells.emplace_back();
    return cells;
}

std::optional<double> number_in(const std::string& cell) {
    double value = 0;
    const char* end = cell.data() + cell.size();
    const auto parsed = std::from_chars(cell.data(), end, value);
    if (parsed.ec != std::errc{} || parsed.ptr != end) return {};
    return value;
}

/// No cell is a number: a row with one that cannot be read is no head, it would be lost.
bool is_head(const std::vector<std::string>& cells) {
    return std::ranges::none_of(cells, [](const std::string& cell) { return number_in(cell).has_value(); });
}

std::vector<std::string> head_from(const std::vector<std::string>& cells, const std::string& where) {
    std::set<std::string> names;
    for (const auto& cell : cells) {
        if (cell.empty()) throw InputError(where, "a column has no name");
        if (!names.insert(cell).second) throw InputError(where, "the column '" + cell + "' stands twice");
    }
    return cells;
}

std::vector<double> row_from(const std::vector<std::string>& cells, std::size_t columns, const std::string& where) {
    if (cells.size() != columns)
        throw InputError(where,
                         "has " + std::to_string(cells.size()) + " cells, but must have " + std::to_string(columns));
    std::vector<double> row;
    for (const auto& cell : cells) {
        const auto value = number_in(cell);
        if (!value) throw InputError(where, "'" + cell + "' is not a number that a double holds");
        row.push_back(*value);
    }
    return row;
}

}  // namespace

bool NumberTable::has(const std::string& name) const { return std::ranges::find(names, name) != names.end(); }

std::size_t NumberTable::columns() const { return rows.front().size(); }

std::vector<double> NumberTable::column(const std::string& name, std::size_t place, const std::string& where) const {
    std::size_t index = place;
    if (!names.empty()) {
        const auto found = std::ranges::find(names, name);
        if (found == names.end())
            throw InputError(where, "there is no column '" + name + "'" + did_you_mean(name, names));
        index = static_cast<std::size_t>(found - names.begin());
    }
    std::vector<double> values;
    for (const auto& row : rows) values.push_back(row.at(index));
    return values;
}

NumberTable number_table(const std::string& text, const std::string& where) {
    NumberTable table;
    std::istringstream lines(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text);
    std::size_t columns = 0, number = 0;
    for (std::string line; std::getline(lines, line);) {
        const std::string at = where + ": line " + std::to_string(++number);
        if (const std::string content = trimmed(line); content.empty() || content.starts_with('#')) continue;
        const auto cells = cells_of(line);
        const bool first = columns == 0;
        if (first) columns = cells.size();
        if (first && is_head(cells)) table.names = head_from(cells, at);
        else table.rows.push_back(row_from(cells, columns, at));
    }
    if (table.rows.empty()) throw InputError(where, "has no row of numbers");
    return table;
}

}  // namespace ordo::app

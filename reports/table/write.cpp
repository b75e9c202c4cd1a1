#include "reports/table/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/text.hpp"
#include "reports/view.hpp"

namespace ordo::reports {
namespace {

/// Each of `escaped_characters` in `text` replaced by what `replacement` says; control characters become spaces.
template <class Replacement>
std::string escaped(const std::string& text, Replacement replacement) {
    std::string safe;
    for (const char c : one_line(text)) safe += replacement(c);
    return safe;
}

// Text: columns aligned to the right, groups side by side as far as they fit, then below one another.

constexpr std::size_t widest_line = 120;

/// Lines of equal width, one below the other.
using Block = std::vector<std::string>;

Block right_aligned(Block lines) {
    std::size_t widest = 0;
    for (const auto& line : lines) widest = std::max(widest, width_of(line));
    for (auto& line : lines) line.insert(0, widest - width_of(line), ' ');
    return lines;
}

Block beside(Block left, const Block& right, std::size_t gap) {
    for (std::size_t i = 0; i < left.size(); ++i) left[i] += std::string(gap, ' ') + right[i];
    return left;
}

Block column_block(const Table& table, const Column& column, std::size_t cell) {
    Block block{one_line(column.head) + (column.marked ? "  " : "")};
    for (const auto& row : table.rows) {
        const Cell& found = row.cells[cell];
        block.push_back(column.marked ? found.text + ' ' + found.mark : found.text);
    }
    return right_aligned(block);
}

/// The label of a group, a rule, the heads of its columns and its part of each row.
Block group_block(const Table& table, const Group& group, std::size_t first_cell) {
    Block block = column_block(table, group.columns.front(), first_cell);
    for (std::size_t i = 1; i < group.columns.size(); ++i) {
        block = beside(std::move(block), column_block(table, group.columns[i], first_cell + i), 2);
    }
    const std::string label = one_line(group.label);
    const std::size_t width = std::max(width_of(label), width_of(block.front()));
    const std::string rest(width - width_of(label), ' ');
    block.insert(block.begin(), {label + rest, std::string(width, '-')});
    return right_aligned(block);
}

Block place_block(const Table& table) {
    Block block{"", "", table.place_head};
    for (const auto& row : table.rows) block.push_back(row.place);
    return right_aligned(block);
}

std::string text_panel(const Table& panel) {
    Block lines = place_block(panel);
    std::size_t cell = 0;
    for (const auto& group : panel.groups) {
        lines = beside(std::move(lines), group_block(panel, group, cell), 4);
        cell += group.columns.size();
    }
    std::string text;
    for (const auto& line : lines) text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    return text + '\n';
}

std::string text_table(const Table& table) {
    std::string text = one_line(table.title) + "\n\n";
    for (const auto& panel : panels(table, widest_line)) text += text_panel(panel);
    for (const auto& note : table.notes) text += one_line(note) + '\n';
    return text + '\n';
}

std::string as_text(const TableModel& model) {
    std::string text = one_line(model.study) + '\n';
    if (!model.about.empty()) text += one_line(model.about) + '\n';
    text += '\n';
    for (const auto& table : model.tables) text += text_table(table);
    for (const auto& line : model.verdicts) text += one_line(line) + '\n';
    return model.verdict.empty() ? text : text + "verdict: " + model.verdict + '\n';
}

// Markdown of GitHub: every character with a meaning gets a backslash.

std::string markdown(const std::string& text) {
    return escaped(text, [](char c) {
        const bool special = std::string_view("\\`*_{}[]<>|~&$#!").find(c) != std::string_view::npos;
        return special ? std::string{'\\', c} : std::string{c};
    });
}

std::string markdown_row(const std::vector<std::string>& cells) { return "| " + joined(cells, " | ") + " |\n"; }

std::string markdown_table(const Table& table) {
    std::vector<std::string> heads{markdown(table.place_head)};
    for (const auto& group : table.groups) {
        std::string label = group.label + ": ";
        for (const auto& column : group.columns) heads.push_back(markdown(std::exchange(label, "") + column.head));
    }
    std::string text = "**" + markdown(table.title) + "**\n\n" + markdown_row(heads);
    text += markdown_row(std::vector<std::string>(heads.size(), "---:"));
    for (const auto& row : table.rows) {
        std::vector<std::string> cells{markdown(row.place)};
        for (const auto& cell : row.cells) {
            cells.push_back(markdown(cell.mark == ' ' ? cell.text : cell.text + ' ' + cell.mark));
        }
        text += markdown_row(cells);
    }
    text += '\n';
    for (const auto& note : table.notes) text += "- " + markdown(note) + '\n';
    return text + '\n';
}

std::string as_markdown(const TableModel& model) {
    std::string text = "## " + markdown(model.study) + "\n\n";
    if (!model.about.empty()) text += markdown(model.about) + "\n\n";
    for (const auto& table : model.tables) text += markdown_table(table);
    for (const auto& line : model.verdicts) text += "- " + markdown(line) + '\n';
    return model.verdict.empty() ? text : text + "\n**verdict: " + model.verdict + "**\n";
}

// LaTeX with the package booktabs, for a page of the class article.

constexpr std::size_t latex_line = 88;  // characters of the size \footnotesize

std::string latex(const std::string& text) {
    return escaped(text, [](char c) -> std::string {
        switch (c) {
            case '\\': return "\\textbackslash{}";
            case '~': return "\\textasciitilde{}";
            case '^': return "\\textasciicircum{}";
            case '<': return "\\textless{}";
            case '>': return "\\textgreater{}";
            case '|': return "\\textbar{}";
            case '{':
            case '}':
            case '#':
            case '$':
            case '%':
            case '&':
            case '_': return {'\\', c};
            default: return {c};
        }
    });
}

/// A number with a true minus sign, a dash where nothing stands, or a status.
std::string latex_cell(const Cell& cell) {
    if (cell.text == "-") return "--";
    return cell.text.starts_with('-') ? "$-$" + latex(cell.text.substr(1)) : latex(cell.text);
}

std::string latex_mark(char mark) { return mark == '=' ? "$=$" : mark == '!' ? "$\\neq$" : ""; }

/// The lines between \toprule and \midrule: labels of the groups with their rules, then heads of the columns.
std::string latex_heads(const Table& table) {
    std::string labels, rules, heads = latex(table.place_head);
    std::size_t column_number = 2;
    for (const auto& group : table.groups) {
        std::size_t span = 0;
        for (const auto& column : group.columns) {
            span += column.marked ? 2 : 1;
            heads += column.marked ? " & \\multicolumn{2}{c}{" + latex(column.head) + "}" : " & " + latex(column.head);
        }
        labels += fmt::format(" & \\multicolumn{{{}}}{{c}}{{{}}}", span, latex(group.label));
        rules += fmt::format("\\cmidrule(lr){{{}-{}}}", column_number, column_number + span - 1);
        column_number += span;
    }
    return labels + " \\\\\n" + rules + "\n" + heads + " \\\\\n";
}

std::string latex_rows(const Table& table) {
    std::string text;
    for (const auto& row : table.rows) {
        text += latex(row.place);
        auto cell = row.cells.begin();
        for (const auto& group : table.groups) {
            for (const auto& column : group.columns) {
                text += " & " + latex_cell(*cell) + (column.marked ? " & " + latex_mark(cell->mark) : "");
                ++cell;
            }
        }
        text += " \\\\\n";
    }
    return text;
}

std::string latex_lines(const std::vector<std::string>& lines) {
    std::string text = "\\begin{minipage}{\\linewidth}\\footnotesize\n";
    for (const auto& line : lines) text += latex(line) + "\\par\n";
    return text + "\\end{minipage}\n";
}

std::string latex_tabular(const Table& panel) {
    std::string columns = "r";
    for (const auto& group : panel.groups) {
        for (const auto& column : group.columns) columns += column.marked ? "r@{\\,}l" : "r";
    }
    return "\\begin{tabular}{" + columns + "}\n\\toprule\n" + latex_heads(panel) + "\\midrule\n" + latex_rows(panel) +
           "\\bottomrule\n\\end{tabular}\n";
}

std::string latex_table(const Table& table, const std::string& study) {
    std::string text = "\\begin{table}[htbp]\n\\centering\\footnotesize\\setlength{\\tabcolsep}{3pt}\n";
    text += "\\caption{" + latex(study + ": " + table.title) + "}\\medskip\n";
    for (const auto& panel : panels(table, latex_line)) text += latex_tabular(panel) + "\\par\\medskip\n";
    return text + latex_lines(table.notes) + "\\end{table}\n\n";
}

std::string as_latex(const TableModel& model) {
    std::string text = "% needs \\usepackage{booktabs}\n";
    for (const auto& table : model.tables) text += latex_table(table, model.study);
    if (model.verdict.empty()) return text;
    auto lines = model.verdicts;
    lines.push_back("verdict: " + model.verdict);
    return text + "\\noindent\n" + latex_lines(lines);
}

// CSV after RFC 4180.

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string{c};
    return quoted + '"';
}

}  // namespace

std::string written(const TableModel& model, TableFormat format) {
    switch (format) {
        case TableFormat::text: return as_text(model);
        case TableFormat::markdown: return as_markdown(model);
        case TableFormat::latex: return as_latex(model);
        case TableFormat::csv: break;
    }
    throw std::logic_error("a table model has no CSV of its own");
}

std::string csv_row(std::vector<std::string> cells) {
    std::ranges::transform(cells, cells.begin(), csv_cell);
    return joined(cells, ",") + '\n';
}

}  // namespace ordo::reports

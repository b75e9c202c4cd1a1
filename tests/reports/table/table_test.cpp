#include "reports/table/table.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "reports/table/model.hpp"
#include "tests/catch.hpp"
#include "tests/reports/sample.hpp"

using namespace ordo;
using namespace ordo::reports;
using samples::sample;

namespace {

using Words = std::vector<std::string>;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The first line that begins with `start`, after blanks.
std::string line_of(const std::string& text, const std::string& start) {
    for (const auto& line : lines_of(text)) {
        if (line.find(start) != std::string::npos && line.find_first_not_of(' ') == line.find(start)) return line;
    }
    throw std::runtime_error("no line begins with " + start);
}

Words words_of(const std::string& line) {
    std::istringstream stream(line);
    return {std::istream_iterator<std::string>(stream), {}};
}

Words cells_of(const Table& table, std::size_t row) {
    Words texts;
    for (const auto& cell : table.rows.at(row).cells) texts.push_back(cell.text);
    return texts;
}

std::string marks_of(const Table& table, std::size_t column) {
    std::string marks;
    for (const auto& row : table.rows) marks += row.cells.at(column).mark;
    return marks;
}

bool has(const std::vector<std::string>& lines, const std::string& line) {
    return std::ranges::find(lines, line) != lines.end();
}

/// Number of `c` in the line that no backslash stands before.
std::ptrdiff_t bare(const std::string& line, char c) {
    std::ptrdiff_t found = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '\\') ++i;
        else found += line[i] == c;
    }
    return found;
}

/// CSV after RFC 4180, read by its grammar: records of fields.
std::vector<Words> records_of(const std::string& csv) {
    std::vector<Words> records;
    Words record(1);
    bool inside = false;
    for (std::size_t i = 0; i < csv.size(); ++i) {
        if (inside && csv[i] == '"' && i + 1 < csv.size() && csv[i + 1] == '"') record.back() += csv[i++];
        else if (csv[i] == '"') inside = !inside;
        else if (csv[i] == ',' && !inside) record.emplace_back();
        else if (csv[i] == '\n' && !inside) records.push_back(std::exchange(record, Words(1)));
        else record.back() += csv[i];
    }
    return records;
}

}  // namespace

TEST_CASE("table: rows go from coarse to fine with errors, printed values and orders", "[unit]") {
    const auto model = table_model(sample());
    REQUIRE(model.tables.size() == 1);
    const Table& table = model.tables[0];
    CHECK(table.title == "RMS error of displacement [m] at t = 0.5 s");
    REQUIRE(table.rows.size() == 5);
    CHECK(table.place_head == "cells");
    CHECK(table.rows[4].place == "243");
    // Refinement by three: log(9)/log(3) = 2 exactly, where log2(9) would be 3.17; log(20/9)/log(3) = 0.727.
    // Where a value is printed ours has its digits; fem has nothing printed, so it has no such column.
    CHECK(cells_of(table, 0) == Words{"9.0e-02", "9.0e-02", "-", "2.7000e-02", "-"});
    CHECK(cells_of(table, 1) == Words{"1.0e-02", "1.1e-02", "2.00", "nan", "-"});
    CHECK(cells_of(table, 2) == Words{"1.1111e-03", "-", "2.00", "1.0000e-03", "-"});
    CHECK(cells_of(table, 3) == Words{"5.0000e-04", "-", "0.73", "-", "-"});
    CHECK(cells_of(table, 4) == Words{"diverged", "-", "-", "-", "-"});
    CHECK(marks_of(table, 1) == "=!   ");
}

TEST_CASE("table: a printed value that nobody judges has no mark", "[unit]") {
    auto report = sample();
    for (auto& match : report.result.published) match.judged = false;
    report.result.study.published[0].because = "the paper's script has a fault";
    const auto model = table_model(report);
    CHECK(marks_of(model.tables[0], 1) == "     ");
    CHECK(has(model.verdicts, "T1: 3 printed values, not judged: the paper's script has a fault; 1 without a run"));
}

TEST_CASE("table: notes say why runs stopped and what each fit used", "[unit]") {
    const auto model = table_model(sample());
    CHECK(model.tables[0].notes ==
          Words{"mpm, cells = 243: diverged, a speed above 1e3 m/s",
                "mpm where cells <= 27: order 2.000 [1.98, 2.02], converges: power law; points cells = 3, 9, 27; "
                "left out cells = 81, 243 (outside)",
                "fem: no order, invalid: the error is nan; points cells = 3, 9, 27"});
    CHECK(model.verdicts == Words{"pass: order 2 +- 0.1; mpm; 2.000",
                                  "T1: 1 of 3 printed values reproduced to every digit; 1 without a run"});
    CHECK(model.verdict == "fail");
}

TEST_CASE("table: two points have no interval, and a band is named", "[unit]") {
    auto report = sample();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    report.result.fits[0].outcome.fit->low = -infinity;
    report.result.fits[0].outcome.fit->high = infinity;
    report.result.study.published[0].compare = studies::Compare::band;
    report.result.study.published[0].band = 0.05;
    const auto model = table_model(report);
    CHECK_THAT(model.tables[0].notes[1], ContainsSubstring("order 2.000 [no interval],"));
    CHECK(has(model.verdicts, "T1: 1 of 3 printed values met within 5 %; 1 without a run"));
}

TEST_CASE("table: a time study has the steps that were taken as rows and abscissae", "[unit]") {
    const auto table = table_model(samples::time_sample()).tables.at(0);
    CHECK(table.title == "L2 error of velocity [m/s * m^(dim/2)] at t = 0.5 s");
    CHECK(table.place_head == "dt [s]");
    CHECK(table.rows[0].place == "0.25");
    CHECK(table.rows[1].place == "0.0625");
    CHECK(table.rows[1].cells[1].text == "1.50");  // errors are 3 dt^1.5 of the steps taken
}

TEST_CASE("table: a repeated run is shown and has no order", "[unit]") {
    auto report = sample();
    auto again = report.result.runs[1];
    again.id = 8;
    again.errors[0].value = 0.02;
    report.result.runs.push_back(again);
    report.result.series[0].runs = {0, 1, 8, 2};
    const auto table = table_model(report).tables.at(0);
    REQUIRE(table.rows.size() == 4);
    CHECK(table.rows[1].place == "9");
    CHECK(table.rows[2].place == "9");
    CHECK(table.rows[2].cells[0].text == "2.0000e-02");
    CHECK(table.rows[2].cells[2].text == "-");
}

TEST_CASE("table: series with different runs share rows from coarse to fine", "[unit]") {
    auto report = sample();
    auto& series = report.result.series;
    series[1].runs = {5, 7};  // fem on 3 and 27 cells
    std::swap(series[0], series[1]);
    const auto table = table_model(report).tables.at(0);
    Words places;
    for (const auto& row : table.rows) places.push_back(row.place);
    CHECK(places == Words{"3", "9", "27", "81", "243"});
    CHECK(cells_of(table, 1) == Words{"-", "-", "1.0e-02", "1.1e-02", "2.00"});
    CHECK(table.rows[2].cells[1].text == "1.50");  // to the series' last value above: log(27)/log(9)
}

TEST_CASE("table: one Courant number on two meshes is one row", "[unit]") {
    auto report = samples::time_sample();
    auto& result = report.result;
    for (int mesh : {1, 2}) {
        for (double courant : {0.5, 0.25}) {
            auto run = samples::run_on(mesh, "mpm", 0);
            run.id = static_cast<int>(result.runs.size());
            run.axes = {{"courant", courant}};
            run.dt = courant / mesh;
            run.errors = {{"velocity.l2", run.dt}};
            result.runs.push_back(run);
        }
    }
    result.series = {{"cells = 2", "dt", "courant", {4, 5}}, {"cells = 1", "dt", "courant", {2, 3}}};
    const auto table = table_model(report).tables.at(0);
    CHECK(table.place_head == "courant");
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[0].place == "0.5");
    CHECK(cells_of(table, 1) == Words{"1.2500e-01", "1.00", "2.5000e-01", "1.00"});
}

TEST_CASE("table: text aligns its columns and keeps to 120 characters", "[unit]") {
    auto report = sample();
    report.result.series[0].label =
        "gr\xC3\xB6\xC3\x9F"
        "er";  // two letters of two bytes each
    for (int i = 0; i < 6; ++i) report.result.series.push_back(report.result.series[1]);
    const std::string text = table(report, TableFormat::text);
    const std::string heads = line_of(text, "cells");
    const std::string row = line_of(text, "9 ");
    CHECK(words_of(row)[3] == "!");
    CHECK(heads.find("error") + 5 == row.find("1.0e-02") + 7);
    CHECK(heads.find("order") + 5 == row.find("2.00") + 4);
    // A label begins where its rule begins: two bytes later behind two letters of two bytes.
    const std::string labels = line_of(text, "gr");
    const std::string rules = line_of(text, "---");
    const auto second_rule = rules.find(" -", rules.find('-')) + 1;
    CHECK(labels.find("gr") == rules.find('-'));
    CHECK(labels.find("fem") == second_rule + 2);
    const auto lines = lines_of(text);
    CHECK(std::ranges::count(lines, "") >= 4);  // two panels
    CHECK(std::ranges::all_of(lines, [](const std::string& line) { return line.size() <= 120; }));
    CHECK(lines.back() == "verdict: fail");
}

TEST_CASE("table: text sends no control characters to a terminal", "[unit]") {
    auto report = sample();
    report.result.study.name = "a\x1B[2Jb\nc";
    report.result.runs[4].reason = "x\r\x07y";
    const std::string text = table(report, TableFormat::text);
    CHECK(lines_of(text).front() == "a [2Jb c");
    CHECK(std::ranges::none_of(text, [](char c) { return c != '\n' && static_cast<unsigned char>(c) < 0x20; }));
}

TEST_CASE("table: Markdown keeps its columns whatever the names are", "[unit]") {
    auto report = sample();
    report.result.study.name = "a|b *c* <script> `d`";
    report.result.series[0].label = "x|y\\|z\n|";
    report.result.fits[0].series = report.result.series[0].label;
    const std::string text = table(report, TableFormat::markdown);
    CHECK(lines_of(text).front() == "## a\\|b \\*c\\* \\<script\\> \\`d\\`");
    // Head, rule and five rows of six columns: place, error, printed, order, error, order.
    const auto is_row = [](const std::string& line) { return line.starts_with("|") && bare(line, '|') == 7; };
    CHECK(std::ranges::count_if(lines_of(text), is_row) == 7);
    CHECK_THAT(text, ContainsSubstring("| 9 | 1.0e-02 | 1.1e-02 \\! | 2.00 | nan | - |\n"));
    CHECK_THAT(text, ContainsSubstring("| cells | x\\|y\\\\\\|z \\|: error | T1 | order | fem: error | order |\n"));
    CHECK_THAT(text, ContainsSubstring("\n**verdict: fail**\n"));
}

TEST_CASE("table: LaTeX has booktabs rules, group heads and escaped names", "[unit]") {
    auto report = sample();
    report.result.study.name = "a_b%c\\input{x}$&#^~";
    report.result.series[0].label = "50% & more";
    report.result.runs[2].errors[0].value = 0.04;  // error grows: a negative order
    const std::string text = table(report, TableFormat::latex);
    CHECK_THAT(text, ContainsSubstring("\\caption{a\\_b\\%c\\textbackslash{}input\\{x\\}\\$\\&\\#"
                                       "\\textasciicircum{}\\textasciitilde{}: RMS error"));
    CHECK_THAT(text,
               ContainsSubstring("\\begin{tabular}{rrr@{\\,}lrrr}\n\\toprule\n"
                                 " & \\multicolumn{4}{c}{50\\% \\& more} & \\multicolumn{2}{c}{fem} \\\\\n"
                                 "\\cmidrule(lr){2-5}\\cmidrule(lr){6-7}\n"
                                 "cells & error & \\multicolumn{2}{c}{T1} & order & error & order \\\\\n\\midrule\n"));
    CHECK_THAT(text, ContainsSubstring("\n9 & 1.0e-02 & 1.1e-02 & $\\neq$ & 2.00 & nan & -- \\\\\n"));
    CHECK_THAT(text,
               ContainsSubstring("\n27 & 4.0000e-02 & -- &  & $-$1.26 & 1.0000e-03 & -- \\\\\n"));  // log(1/4)/log(3)
    CHECK_THAT(text, ContainsSubstring("\\bottomrule\n\\end{tabular}"));
    CHECK_THAT(text, ContainsSubstring("\\end{table}"));
}

TEST_CASE("table: CSV is one record a run and quantity, quoted after RFC 4180", "[unit]") {
    auto report = sample();
    report.result.study.name = "a,\"b\"\nc";
    report.result.study.measure.quantities.push_back({"velocity", studies::Norm::l1});
    const auto records = records_of(table(report, TableFormat::csv));
    REQUIRE(records.size() == 1 + 8 * 2);
    CHECK(records[0] == Words{"study", "solver", "cells", "h", "dt", "t", "status", "reason", "quantity", "error"});
    // 1/9 and 0.01 in the shortest digits that read back
    CHECK(records[3] ==
          Words{"a,\"b\"\nc", "mpm", "9", "0.1111111111111111", "0.001", "0.5", "ok", "", "displacement.rms", "0.01"});
    CHECK(records[9] == Words{"a,\"b\"\nc", "mpm", "243", "0.00411522633744856", "0.001", "0.5", "diverged",
                              "a speed above 1e3 m/s", "displacement.rms", "nan"});
    CHECK(records[10][8] == "velocity.l1");
    CHECK(records[10][9] == "nan");
}

TEST_CASE("table: CSV tells the swept step from the step taken", "[unit]") {
    const auto records = records_of(table(samples::time_sample(), TableFormat::csv));
    REQUIRE(records.size() == 3);
    CHECK(records[0] == Words{"study", "solver", "swept_dt", "h", "dt", "t", "status", "reason", "quantity", "error"});
    CHECK(records[1][2] == "0.3");
    CHECK(records[1][4] == "0.25");
}

TEST_CASE("table: panels hold every group once, in order, none without a group", "[unit]") {
    const auto whole = table_model(sample()).tables.at(0);
    const auto widest = GENERATE(std::size_t{1}, std::size_t{1000});
    const auto parts = panels(whole, widest);
    REQUIRE(parts.size() == (widest == 1 ? 2 : 1));
    std::vector<Words> joined(whole.rows.size());
    for (const auto& part : parts) {
        CHECK_FALSE(part.groups.empty());
        for (std::size_t row = 0; row < whole.rows.size(); ++row) {
            CHECK(part.rows.at(row).place == whole.rows[row].place);
            for (const auto& text : cells_of(part, row)) joined[row].push_back(text);
        }
    }
    for (std::size_t row = 0; row < whole.rows.size(); ++row) CHECK(joined[row] == cells_of(whole, row));
}

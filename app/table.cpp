// ordo table: errors and orders of a report as text.
#include "reports/table/table.hpp"

#include <iostream>

#include "app/arguments.hpp"
#include "app/command.hpp"
#include "reports/table/rank.hpp"

namespace ordo::app {
namespace {

int print_table(const po::variables_map& options, const std::vector<std::string>& files) {
    using reports::TableFormat;
    const auto format = format_of<TableFormat>(options,
                                               {{"text", TableFormat::text},
                                                {"markdown", TableFormat::markdown},
                                                {"latex", TableFormat::latex},
                                                {"csv", TableFormat::csv}},
                                               "ordo table");
    const auto errors = errors_of(options, "rank", "ordo table");
    if (errors.empty()) {
        std::cout << reports::table(reports::read_report(one_report(files, "ordo table")), format);
        return all_hold;
    }
    if (files.empty())
        throw InputError("ordo table --rank", "names no report; usage: ordo table REPORT... --rank=ERRORS");
    std::vector<reports::Report> all;
    for (const auto& file : files) all.push_back(reports::read_report(file));
    std::cout << reports::ranking(all, errors, format);
    return all_hold;
}

}  // namespace

Command table_command() {
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("rank", po::value<std::string>()->value_name("ERRORS"),
         "rank the methods of the reports by their time to reach errors such as 1e-2,1e-4")
        ("format", po::value<std::string>()->value_name("NAME")->default_value("text"), "text, markdown, latex or csv");
    // clang-format on
    return {.name = "table",
            .about = "errors and orders of a report as a table; or who reaches an error first",
            .usage = "REPORT... [--rank ERRORS] [--format text|markdown|latex|csv]",
            .examples = {"ordo table report.json", "ordo table report.json --format latex > table.tex",
                         "ordo table a.json b.json --rank 1e-2,1e-4,1e-6,1e-8"},
            .options = options,
            .most_arguments = -1,
            .run = print_table};
}

}  // namespace ordo::app

// ordo table: errors and orders of a report as text.
#include "reports/table/table.hpp"

#include <iostream>

#include "app/arguments.hpp"
#include "app/command.hpp"

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
    std::cout << reports::table(reports::read_report(one_report(files, "ordo table")), format);
    return all_hold;
}

}  // namespace

Command table_command() {
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("format", po::value<std::string>()->value_name("NAME")->default_value("text"), "text, markdown, latex or csv");
    // clang-format on
    return {.name = "table",
            .about = "errors and orders of a report as a table",
            .usage = "REPORT [--format text|markdown|latex|csv]",
            .examples = {"ordo table report.json", "ordo table report.json --format latex > table.tex"},
            .options = options,
            .most_arguments = 1,
            .run = print_table};
}

}  // namespace ordo::app

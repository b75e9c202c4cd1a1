// ordo table and ordo plot: a report as text or as pictures.
#include <iostream>
#include <map>

#include "app/command.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/plot.hpp"
#include "reports/table.hpp"

namespace ordo::app {
namespace {

/// The format of that name; the message names the nearest.
template <class Format>
Format format_of(const po::variables_map& options, const std::map<std::string, Format>& formats, const std::string& command) {
    const auto name = options["format"].as<std::string>();
    if (const auto found = formats.find(name); found != formats.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [known, format] : formats) names.push_back(known);
    throw InputError(command + " --format", "there is no format '" + name + "'" + did_you_mean(name, names));
}

std::string one_report(const std::vector<std::string>& files, const std::string& command) {
    if (files.size() != 1) throw InputError(command, "takes one report; usage: " + command + " REPORT");
    return files.front();
}

int print_table(const po::variables_map& options, const std::vector<std::string>& files) {
    using reports::TableFormat;
    const auto format = format_of<TableFormat>(options, {{"text", TableFormat::text}, {"markdown", TableFormat::markdown},
                                                         {"latex", TableFormat::latex}, {"csv", TableFormat::csv}}, "ordo table");
    std::cout << reports::table(reports::read_report(one_report(files, "ordo table")), format);
    return all_hold;
}

int draw_plot(const po::variables_map& options, const std::vector<std::string>& files) {
    using reports::PlotFormat;
    const auto format = format_of<PlotFormat>(options, {{"svg", PlotFormat::svg}, {"pdf", PlotFormat::pdf}, {"png", PlotFormat::png}}, "ordo plot");
    const auto report = reports::read_report(one_report(files, "ordo plot"));
    const auto folder = options["out"].as<std::string>();
    reports::check_writable(folder + "/.ordo");
    for (const auto& file : reports::draw(report, folder, format)) std::cout << file << '\n';
    return all_hold;
}

}  // namespace

Command table_command() {
    po::options_description options("options");
    options.add_options()("format", po::value<std::string>()->value_name("NAME")->default_value("text"), "text, markdown, latex or csv");
    return {.name = "table",
            .about = "errors and orders of a report as a table",
            .usage = "REPORT [--format text|markdown|latex|csv]",
            .examples = {"ordo table report.json", "ordo table report.json --format latex > table.tex"},
            .options = options,
            .most_arguments = 1,
            .run = print_table};
}

Command plot_command() {
    po::options_description options("options");
    options.add_options()
        ("out,o", po::value<std::string>()->value_name("DIR")->default_value("."), "folder of the pictures")
        ("format", po::value<std::string>()->value_name("NAME")->default_value("svg"), "svg, pdf or png");
    return {.name = "plot",
            .about = "convergence plots of a report, with their gnuplot scripts",
            .usage = "REPORT [-o DIR] [--format svg|pdf|png]",
            .examples = {"ordo plot report.json -o figures --format pdf"},
            .options = options,
            .most_arguments = 1,
            .run = draw_plot};
}

}  // namespace ordo::app

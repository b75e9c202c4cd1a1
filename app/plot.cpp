// ordo plot: a report as pictures.
#include "reports/plot/plot.hpp"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <sstream>

#include "app/arguments.hpp"
#include "app/command.hpp"

namespace ordo::app {
namespace {

/// The names between the commas of --against, each known and there once.
std::vector<std::string> abscissae_of(const po::variables_map& options) {
    const std::vector<std::string> known{"h", "work", "time"};
    const std::string where = "ordo plot --against";
    std::vector<std::string> names;
    std::istringstream list(options["against"].as<std::string>() + ",");
    for (std::string name; std::getline(list, name, ',');) {
        if (std::ranges::find(known, name) == known.end())
            throw InputError(where, "nothing is drawn against '" + name + "'" + did_you_mean(name, known));
        if (std::ranges::find(names, name) != names.end()) throw InputError(where, "'" + name + "' stands twice");
        names.push_back(name);
    }
    return names;
}

std::vector<reports::Drawing> figures_against(const std::string& abscissa, const reports::Report& report,
                                              reports::PlotFormat format, const std::vector<double>& errors) {
    if (abscissa == "h") return reports::figures(report, format);
    return reports::figures(report, format, abscissa == "time" ? reports::Cost::time : reports::Cost::work, errors);
}

/// One picture for several reports: a panel each.
std::vector<reports::Drawing> boards_of(const std::vector<std::string>& files,
                                        const std::vector<std::string>& abscissae, reports::PlotFormat format) {
    std::vector<reports::Report> all;
    for (const auto& file : files) all.push_back(reports::read_report(file));
    std::vector<reports::Drawing> boards;
    for (const auto& abscissa : abscissae) {
        if (abscissa == "h")
            throw InputError("ordo plot REPORT REPORT...", "is against a cost: --against time or work");
        boards.push_back(reports::board(all, format, abscissa == "time" ? reports::Cost::time : reports::Cost::work));
    }
    return boards;
}

int draw_plot(const po::variables_map& options, const std::vector<std::string>& files) {
    using reports::PlotFormat;
    const auto format = format_of<PlotFormat>(
        options, {{"svg", PlotFormat::svg}, {"pdf", PlotFormat::pdf}, {"png", PlotFormat::png}}, "ordo plot");
    const auto abscissae = abscissae_of(options);
    const auto errors = errors_of(options, "reach", "ordo plot");
    std::vector<reports::Drawing> all;
    if (files.size() > 1) {
        if (!errors.empty()) throw InputError("ordo plot --reach", "is for one report at a time");
        all = boards_of(files, abscissae, format);
    } else {
        const auto report = reports::read_report(one_report(files, "ordo plot"));
        for (const auto& abscissa : abscissae)
            std::ranges::move(figures_against(abscissa, report, format, errors), std::back_inserter(all));
    }
    for (const auto& file : reports::draw(all, options["out"].as<std::string>(), format)) std::cout << file << '\n';
    return all_hold;
}

}  // namespace

Command plot_command() {
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("out,o", po::value<std::string>()->value_name("DIR")->default_value("."), "folder of the pictures")
        ("against", po::value<std::string>()->value_name("LIST")->default_value("h"),
         "h (the refined mesh width or time step), work (counted), time (thread time of each run), or several: "
         "h,work,time")
        ("reach", po::value<std::string>()->value_name("ERRORS"),
         "errors such as 1e-2,1e-4: lines across the pictures against time and work, and who is there first")
        ("format", po::value<std::string>()->value_name("NAME")->default_value("svg"), "svg, pdf or png");
    // clang-format on
    return {.name = "plot",
            .about =
                "convergence and error-against-cost plots of a report, with their gnuplot scripts; of several, a panel "
                "each",
            .usage = "REPORT... [-o DIR] [--against h|work|time] [--reach ERRORS] [--format svg|pdf|png]",
            .examples = {"ordo plot report.json -o figures --format pdf",
                         "ordo plot report.json -o figures --against work,time --reach 1e-2,1e-4",
                         "ordo plot a.json b.json --against time"},
            .options = options,
            .most_arguments = -1,
            .run = draw_plot};
}

}  // namespace ordo::app

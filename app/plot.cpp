// ordo plot: a report as pictures.
#include "reports/plot/plot.hpp"

#include <iostream>

#include "app/arguments.hpp"
#include "app/command.hpp"

namespace ordo::app {
namespace {

int draw_plot(const po::variables_map& options, const std::vector<std::string>& files) {
    using reports::PlotFormat;
    const auto format = format_of<PlotFormat>(
        options, {{"svg", PlotFormat::svg}, {"pdf", PlotFormat::pdf}, {"png", PlotFormat::png}}, "ordo plot");
    const auto report = reports::read_report(one_report(files, "ordo plot"));
    const auto folder = options["out"].as<std::string>();
    reports::check_writable(folder + "/.ordo");
    for (const auto& file : reports::draw(report, folder, format)) std::cout << file << '\n';
    return all_hold;
}

}  // namespace

Command plot_command() {
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("out,o", po::value<std::string>()->value_name("DIR")->default_value("."), "folder of the pictures")
        ("format", po::value<std::string>()->value_name("NAME")->default_value("svg"), "svg, pdf or png");
    // clang-format on
    return {.name = "plot",
            .about = "convergence plots of a report, with their gnuplot scripts",
            .usage = "REPORT [-o DIR] [--format svg|pdf|png]",
            .examples = {"ordo plot report.json -o figures --format pdf"},
            .options = options,
            .most_arguments = 1,
            .run = draw_plot};
}

}  // namespace ordo::app

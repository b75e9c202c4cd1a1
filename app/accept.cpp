// ordo accept: a report becomes the baseline, with the reason why.
#include <filesystem>
#include <iostream>

#include "app/arguments.hpp"
#include "app/command.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/gate.hpp"

namespace ordo::app {
namespace {

using studies::Verdict;

int accept(const po::variables_map& options, const std::vector<std::string>& files) {
    const std::string file = one_report(files, "ordo accept");
    if (!options.contains("because")) throw InputError("ordo accept", "needs a reason: --because TEXT");
    const double band = options["band"].as<double>();
    if (!(band > 0 && band < 1)) throw InputError("ordo accept --band", "must be in (0, 1)");
    const auto report = reports::read_report(file);
    if (report.result.verdict == Verdict::fail) {
        throw InputError(file, "its own gate fails, so it cannot be accepted; see ordo check " + file);
    }
    const std::string path = reports::baseline_path(options["into"].as<std::string>(), report.result.study.name);
    reports::check_writable(path);
    const reports::Baseline baseline{options["because"].as<std::string>(),
                                     report.provenance.time_utc,
                                     report.provenance.revision,
                                     report.provenance.compiler,
                                     band,
                                     report};
    std::error_code error;
    if (std::filesystem::exists(path, error)) {
        std::cout << "replaces the baseline of before; against it:\n";
        for (const auto& item : reports::checks_against(report, reports::read_baseline(path))) {
            std::cout << "  " << shown(item.verdict) << "  " << one_line(item.subject + ": " + item.found) << '\n';
        }
    }
    reports::write_whole(path, reports::to_json(baseline));
    std::cout << "accepted: " << path << '\n';
    return all_hold;
}

}  // namespace

Command accept_command() {
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("because", po::value<std::string>()->value_name("TEXT"), "the reason; kept with revision and compiler")
        ("into", po::value<std::string>()->value_name("DIR")->default_value("reports/baseline"),
         "folder of the baselines")
        ("band", po::value<double>()->value_name("X")->default_value(1e-6, "1e-6"),
         "relative difference a later report may have");
    // clang-format on
    return {.name = "accept",
            .about = "make a report the baseline",
            .usage = "REPORT --because TEXT [--into DIR] [--band X]",
            .examples = {"ordo accept report.json --because 'first reproduction of table A1'"},
            .options = options,
            .most_arguments = 1,
            .run = accept};
}

}  // namespace ordo::app

// ordo check and ordo accept: the regression gate.
#include <filesystem>
#include <iostream>

#include "app/command.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "reports/gate.hpp"
#include "reports/plot_view.hpp"

namespace ordo::app {
namespace {

using reports::one_line;
using studies::Verdict;

/// The report's own checks, and those against its baseline where a folder is named.
reports::GateResult gate(const std::string& file, const std::string& against) {
    const auto report = reports::read_report(file);
    reports::GateResult result{report.result.study.name, report.result.checks};
    if (against.empty()) return result;
    const std::string path = reports::baseline_path(against, result.study);
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        result.checks.push_back({"an accepted report", "baseline", "rule of the house", Verdict::fail,
                                 "there is no baseline " + path + "; make one: ordo accept " + file + " --because TEXT"});
        return result;
    }
    for (auto& check : reports::checks_against(report, reports::read_baseline(path))) result.checks.push_back(std::move(check));
    return result;
}

int check(const po::variables_map& options, const std::vector<std::string>& files) {
    if (files.empty()) throw InputError("ordo check", "names no report; usage: ordo check REPORT...");
    const std::string against = options.contains("against") ? options["against"].as<std::string>() : "";
    const std::string junit = options.contains("junit") ? options["junit"].as<std::string>() : "";
    std::vector<reports::GateResult> results;
    for (const auto& file : files) results.push_back(gate(file, against));
    if (!junit.empty()) reports::check_writable(junit);
    int code = all_hold;
    for (const auto& result : results) {
        std::cout << one_line(result.study) << ": " << shown(result.verdict()) << '\n';
        for (const auto& item : result.checks) {
            std::cout << "  " << shown(item.verdict) << "  " << one_line(item.subject + ": " + item.claim + "; found " + item.found) << '\n';
        }
        if (result.verdict() != Verdict::pass) code = gate_failed;
    }
    if (against.empty()) std::cout << "expectations only; a baseline is compared with --against DIR\n";
    if (!junit.empty()) reports::write_whole(junit, reports::junit(results));
    return code;
}

int accept(const po::variables_map& options, const std::vector<std::string>& files) {
    if (files.size() != 1) throw InputError("ordo accept", "takes one report; usage: ordo accept REPORT --because TEXT");
    if (!options.contains("because")) throw InputError("ordo accept", "needs a reason: --because TEXT");
    const double band = options["band"].as<double>();
    if (!(band > 0 && band < 1)) throw InputError("ordo accept --band", "must be in (0, 1)");
    const auto report = reports::read_report(files.front());
    if (report.result.verdict == Verdict::fail) {
        throw InputError(files.front(), "its own gate fails, so it cannot be accepted; see ordo check " + files.front());
    }
    const std::string path = reports::baseline_path(options["into"].as<std::string>(), report.result.study.name);
    reports::check_writable(path);
    const reports::Baseline baseline{options["because"].as<std::string>(), report.provenance.time_utc, report.provenance.revision,
                                     report.provenance.compiler, band, report};
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

Command check_command() {
    po::options_description options("options");
    options.add_options()
        ("against", po::value<std::string>()->value_name("DIR"), "also compare with the accepted reports in DIR")
        ("junit", po::value<std::string>()->value_name("FILE"), "write the checks as JUnit XML");
    return {.name = "check",
            .about = "gate reports against their expectations and the accepted baseline",
            .usage = "REPORT... [--against DIR] [--junit FILE]",
            .examples = {"ordo check report.json", "ordo check report.json --against reports/baseline --junit gate.xml"},
            .options = options,
            .most_arguments = -1,
            .run = check};
}

Command accept_command() {
    po::options_description options("options");
    options.add_options()
        ("because", po::value<std::string>()->value_name("TEXT"), "the reason; kept with revision and compiler")
        ("into", po::value<std::string>()->value_name("DIR")->default_value("reports/baseline"), "folder of the baselines")
        ("band", po::value<double>()->value_name("X")->default_value(1e-6, "1e-6"), "relative difference a later report may have");
    return {.name = "accept",
            .about = "make a report the baseline",
            .usage = "REPORT --because TEXT [--into DIR] [--band X]",
            .examples = {"ordo accept report.json --because 'first reproduction of table A1'"},
            .options = options,
            .most_arguments = 1,
            .run = accept};
}

}  // namespace ordo::app

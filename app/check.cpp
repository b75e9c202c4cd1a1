// ordo check: the regression gate.
#include <filesystem>
#include <iostream>

#include "app/command.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/gate.hpp"

namespace ordo::app {
namespace {

using studies::Verdict;

/// The report's own checks, and those against its baseline where a folder is named.
reports::GateResult gate(const std::string& file, const std::string& against) {
    const auto report = reports::read_report(file);
    reports::GateResult result{report.result.study.name, report.result.checks};
    if (against.empty()) return result;
    const std::string path = reports::baseline_path(against, result.study);
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        result.checks.push_back(
            {"an accepted report", "baseline", "rule of the house", Verdict::fail,
             "there is no baseline " + path + "; make one: ordo accept " + file + " --because TEXT"});
        return result;
    }
    for (auto& check : reports::checks_against(report, reports::read_baseline(path)))
        result.checks.push_back(std::move(check));
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
            std::cout << "  " << shown(item.verdict) << "  "
                      << one_line(item.subject + ": " + item.claim + "; found " + item.found) << '\n';
        }
        if (result.verdict() != Verdict::pass) code = gate_failed;
    }
    if (against.empty()) std::cout << "expectations only; a baseline is compared with --against DIR\n";
    if (!junit.empty()) reports::write_whole(junit, reports::junit(results));
    return code;
}

}  // namespace

Command check_command() {
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("against", po::value<std::string>()->value_name("DIR"), "also compare with the accepted reports in DIR")
        ("junit", po::value<std::string>()->value_name("FILE"), "write the checks as JUnit XML");
    // clang-format on
    return {
        .name = "check",
        .about = "gate reports against their expectations and the accepted baseline",
        .usage = "REPORT... [--against DIR] [--junit FILE]",
        .examples = {"ordo check report.json", "ordo check report.json --against reports/baseline --junit gate.xml"},
        .options = options,
        .most_arguments = -1,
        .run = check};
}

}  // namespace ordo::app

// ordo check: the regression gate.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

#include "app/command.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/gate/compare.hpp"
#include "reports/gate/outcome.hpp"

namespace ordo::app {
namespace {

using studies::Verdict;

/// What reports are held to beside their own expectations.
struct Asked {
    std::string against;          ///< folder of baselines; empty: none
    std::optional<double> times;  ///< factor that the time may be off
};

/// The report's own checks, and those against its baseline where a folder is named.
reports::GateResult gate(const std::string& file, const Asked& asked) {
    const auto report = reports::read_report(file);
    reports::GateResult result{report.result.study.name, report.result.checks};
    if (asked.against.empty()) return result;
    const std::string path = reports::baseline_path(asked.against, result.study);
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        result.checks.push_back(reports::no_baseline(path));
        return result;
    }
    const auto baseline = reports::read_baseline(path);
    for (auto& check : reports::checks_against(report, baseline)) result.checks.push_back(std::move(check));
    if (asked.times) result.checks.push_back(reports::time_check(report, baseline, *asked.times));
    return result;
}

Asked asked_by(const po::variables_map& options) {
    Asked asked;
    if (options.contains("against")) asked.against = options["against"].as<std::string>();
    if (!options.contains("times")) return asked;
    asked.times = options["times"].as<double>();
    if (!(*asked.times > 1 && std::isfinite(*asked.times)))
        throw InputError("ordo check --times",
                         "is " + shortest(*asked.times) + ", but must be a factor above 1 (nearest: 1.5)");
    if (asked.against.empty()) throw InputError("ordo check --times", "needs a baseline: --against DIR");
    return asked;
}

void print_checks(const reports::GateResult& result) {
    for (const auto& check : result.checks) {
        const std::string fault = check.verdict == Verdict::pass ? "" : " (" + reports::name_of(check) + ")";
        std::cout << "  " << shown(check.verdict) << fault << "  "
                  << one_line(check.subject + ": " + check.claim + "; found " + check.found) << '\n';
    }
}

void print(const std::vector<reports::GateResult>& results, const Asked& asked, bool verbose) {
    std::cout << reports::failures_text(results);
    for (const auto& result : results) {
        std::cout << one_line(result.study) << ": " << shown(result.verdict()) << '\n';
        if (verbose) print_checks(result);
    }
    const auto counts = reports::counts_of(results);
    std::cout << fmt::format("{} reports, {} checks pass, {} fail, {} inconclusive\n", results.size(), counts.pass,
                             counts.fail, counts.inconclusive);
    if (asked.against.empty()) std::cout << "expectations only; a baseline is compared with --against DIR\n";
}

int check(const po::variables_map& options, const std::vector<std::string>& files) {
    if (files.empty()) throw InputError("ordo check", "names no report; usage: ordo check REPORT...");
    const auto file_of = [&](const char* name) {
        return options.contains(name) ? options[name].as<std::string>() : std::string();
    };
    const Asked asked = asked_by(options);
    const std::string junit = file_of("junit");
    const std::string summary = file_of("summary");
    if (!junit.empty() && junit == summary) throw InputError("ordo check", "--junit and --summary name the same file");
    std::vector<reports::GateResult> results;
    for (const auto& file : files) results.push_back(gate(file, asked));
    for (const auto& file : {junit, summary}) {
        if (!file.empty()) reports::check_writable(file);
    }
    print(results, asked, options["verbose"].as<bool>());
    if (options["annotations"].as<bool>()) std::cout << reports::annotations(results);
    if (!junit.empty()) reports::write_whole(junit, reports::junit(results));
    if (!summary.empty()) reports::write_whole(summary, reports::summary(results));
    const auto counts = reports::counts_of(results);
    return counts.pass > 0 && counts.fail + counts.inconclusive == 0 ? all_hold : gate_failed;
}

}  // namespace

Command check_command() {
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("against", po::value<std::string>()->value_name("DIR"), "also compare with the accepted reports in DIR")
        ("times", po::value<double>()->value_name("X"),
         "also hold the time of the runs, in reference kernels, to within this factor of the accepted, up and down")
        ("verbose,v", po::bool_switch(), "show the checks that pass, too")
        ("junit", po::value<std::string>()->value_name("FILE"), "write the checks as JUnit XML")
        ("annotations", po::bool_switch(), "print what does not pass as commands for GitHub Actions")
        ("summary", po::value<std::string>()->value_name("FILE"), "write a summary in Markdown");
    // clang-format on
    return {
        .name = "check",
        .about = "gate reports against their expectations and the accepted baseline",
        .usage = "REPORT... [--against DIR] [--times X] [--verbose] [--junit FILE] [--annotations] [--summary FILE]",
        .examples = {"ordo check report.json", "ordo check report.json --against reports/baseline --junit gate.xml",
                     "ordo check report.json --against reports/baseline --times 1.5 --annotations"},
        .options = options,
        .most_arguments = -1,
        .run = check};
}

}  // namespace ordo::app

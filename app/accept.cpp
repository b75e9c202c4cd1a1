// ordo accept: a report becomes the baseline, with the reason why.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

#include "app/command.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/gate/compare.hpp"
#include "reports/gate/outcome.hpp"
#include "reports/gate/question.hpp"
#include "reports/gate/tolerance.hpp"

namespace ordo::app {
namespace {

using reports::AcceptedFigure;
using reports::Baseline;

/// The report and its twins; none whose own gate fails.
std::vector<reports::Report> reports_in(const std::vector<std::string>& files) {
    std::vector<reports::Report> found;
    for (const auto& file : files) {
        found.push_back(reports::read_report(file));
        if (found.back().result.verdict == studies::Verdict::fail)
            throw InputError(file, "its own gate fails, so it cannot be accepted; see ordo check " + file);
    }
    return found;
}

/// What is being replaced; none where there is nothing, or nothing that can be read.
std::optional<Baseline> before_at(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) return std::nullopt;
    try {
        return reports::read_baseline(path);
    } catch (const InputError& unreadable) {
        std::cout << "replaces what cannot be compared: " << one_line(unreadable.what()) << '\n';
        return std::nullopt;
    }
}

std::string value_words(const std::optional<AcceptedFigure>& accepted) {
    if (!accepted) return "-";
    return std::isnan(accepted->figure.value) ? "none" : shortest(accepted->figure.value);
}

std::string tolerance_words(const std::optional<AcceptedFigure>& accepted) {
    return accepted ? fmt::format("{:.2g}", accepted->tolerance) : "-";
}

/// The difference that a reviewer has to agree with.
void print_difference(const Baseline& before, const Baseline& now) {
    std::cout << "replaces the " << one_line(before.source()) << '\n';
    for (const auto& [member, old_value, value] : reports::differences(before.question, now.question))
        std::cout << one_line(fmt::format("  the study's {} was {}, is {}", member, old_value, value)) << '\n';
    const auto found = reports::changes(before, now);
    if (found.empty()) {
        std::cout << "  no figure left its interval, and no tolerance more than doubled\n";
        return;
    }
    std::vector<std::vector<std::string>> rows{{"figure", "old", "new", "old tolerance", "tolerance"}};
    for (const auto& [old_one, new_one] : found) {
        rows.push_back({(new_one ? new_one : old_one)->figure.name(), value_words(old_one), value_words(new_one),
                        tolerance_words(old_one), tolerance_words(new_one)});
    }
    std::cout << reports::aligned(rows);
}

void print_tolerances(const Baseline& baseline) {
    const auto measured = std::ranges::count_if(baseline.figures, [](const AcceptedFigure& accepted) {
        return accepted.tolerance > reports::least_tolerance(accepted.figure);
    });
    std::cout << fmt::format(
        "{} figures of {} runs from {} reports: {} with the tolerance of {} times their scatter, {} "
        "with {} units in the last place (counts without scatter: none)\n",
        baseline.figures.size(), baseline.runs.size(), baseline.makers.size(), measured, reports::times_spread,
        baseline.figures.size() - static_cast<std::size_t>(measured), reports::least_ulps);
    if (baseline.makers.size() == 1)
        std::cout
            << "no twin was given, so no scatter was measured: another compiler or machine may fail this baseline; "
               "ordo accept REPORT TWIN... takes reports of other builds\n";
}

int accept(const po::variables_map& options, const std::vector<std::string>& files) {
    if (files.empty()) throw InputError("ordo accept", "names no report; usage: ordo accept REPORT [TWIN...]");
    if (!options.contains("because")) throw InputError("ordo accept", "needs a reason: --because TEXT");
    const std::string because = options["because"].as<std::string>();
    if (std::ranges::all_of(because, [](char c) { return c == ' ' || c == '\t'; }))
        throw InputError("ordo accept --because", "is blank, but must say why");
    const auto reports = reports_in(files);
    const auto baseline = reports::baseline_of(reports, files, because);
    const std::string path = reports::baseline_path(options["into"].as<std::string>(), baseline.study);
    reports::check_writable(path);
    if (const auto before = before_at(path)) print_difference(*before, baseline);
    reports::write_whole(path, reports::to_json(baseline));
    print_tolerances(baseline);
    if (reports.front().result.verdict == studies::Verdict::inconclusive)
        std::cout << "its own expectations are inconclusive, and stay so under ordo check\n";
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
         "folder of the baselines");
    // clang-format on
    return {.name = "accept",
            .about = "make a report the baseline, with tolerances from the scatter among it and its twins",
            .usage = "REPORT [TWIN...] --because TEXT [--into DIR]",
            .examples = {"ordo accept report.json --because 'first reproduction of table A1'",
                         "ordo accept report.json fma.json --because 'the new volume update'"},
            .options = options,
            .most_arguments = -1,
            .run = accept};
}

}  // namespace ordo::app

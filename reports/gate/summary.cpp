#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/text.hpp"
#include "reports/gate/outcome.hpp"

namespace ordo::reports {
namespace {

/// Every character with a meaning in GitHub's Markdown gets a backslash.
std::string markdown(const std::string& text) {
    std::string safe;
    for (const char c : one_line(text)) {
        if (std::string_view("\\`*_{}[]<>|~&$#!").find(c) != std::string_view::npos) safe += '\\';
        safe += c;
    }
    return safe;
}

std::string row(std::vector<std::string> cells) {
    for (auto& cell : cells) cell = markdown(cell);
    return "| " + joined(cells, " | ") + " |\n";
}

std::string failures(const std::vector<GateResult>& results) {
    std::string text = "| study | subject | fault | expected | found |\n| --- | --- | --- | --- | --- |\n";
    for (const auto& result : results) {
        for (const auto& check : result.checks) {
            if (check.verdict != studies::Verdict::pass)
                text += row({result.study, check.subject, name_of(check), check.claim, check.found});
        }
    }
    text += "\n";
    for (const auto fault : faults_of(results))
        text += fmt::format("* **{}**: {}\n", markdown(studies::text_of(fault)), markdown(advice(fault)));
    return text + "\n";
}

}  // namespace

std::string summary(const std::vector<GateResult>& results) {
    const auto counts = counts_of(results);
    std::string text = fmt::format("## ordo check: {} studies, {} checks pass, {} fail, {} inconclusive\n\n",
                                   results.size(), counts.pass, counts.fail, counts.inconclusive);
    if (counts.fail + counts.inconclusive > 0) text += failures(results);
    text += "| study | verdict | checks |\n| --- | --- | ---: |\n";
    for (const auto& result : results)
        text += row({result.study, studies::text_of(result.verdict()), std::to_string(result.checks.size())});
    return text;
}

}  // namespace ordo::reports

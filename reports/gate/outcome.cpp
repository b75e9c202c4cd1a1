#include "reports/gate/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "reports/view.hpp"

namespace ordo::reports {

using studies::Check;
using studies::Fault;
using studies::Verdict;

Verdict GateResult::verdict() const {
    Verdict worst = Verdict::pass;
    for (const auto& check : checks) {
        if (check.verdict == Verdict::fail) return Verdict::fail;
        if (check.verdict == Verdict::inconclusive) worst = Verdict::inconclusive;
    }
    return checks.empty() ? Verdict::inconclusive : worst;
}

std::string name_of(const Check& check) {
    return check.fault == Fault::none ? studies::text_of(check.verdict) : studies::text_of(check.fault);
}

Counts counts_of(const std::vector<GateResult>& results) {
    Counts counts;
    for (const auto& result : results) {
        for (const auto& check : result.checks) {
            counts.pass += check.verdict == Verdict::pass;
            counts.fail += check.verdict == Verdict::fail;
            counts.inconclusive += check.verdict == Verdict::inconclusive;
        }
    }
    return counts;
}

std::vector<Fault> faults_of(const std::vector<GateResult>& results) {
    std::vector<Fault> faults;
    for (const auto& result : results) {
        for (const auto& check : result.checks) {
            const bool shown = check.verdict != Verdict::pass && check.fault != Fault::none;
            if (shown && std::ranges::find(faults, check.fault) == faults.end()) faults.push_back(check.fault);
        }
    }
    return faults;
}

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(one_line(row[i])));
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string cell = one_line(row[i]);
            line += "  " + cell + std::string(widths[i] - width_of(cell), ' ');
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    }
    return text;
}

std::string failures_text(const std::vector<GateResult>& results) {
    std::vector<std::vector<std::string>> rows{{"study", "subject", "fault", "expected", "found"}};
    for (const auto& result : results) {
        for (const auto& check : result.checks) {
            if (check.verdict != Verdict::pass)
                rows.push_back({result.study, check.subject, name_of(check), check.claim, check.found});
        }
    }
    if (rows.size() == 1) return "";
    std::string text = "does not pass:\n" + aligned(rows);
    const auto faults = faults_of(results);
    if (!faults.empty()) text += "what to look at next:\n";
    for (const Fault fault : faults) text += fmt::format("  {}: {}\n", studies::text_of(fault), advice(fault));
    return text + '\n';
}

}  // namespace ordo::reports

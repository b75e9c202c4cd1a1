// Workflow commands, escaped as the runner undoes it: https://github.com/actions/toolkit, packages/core/src/command.ts.
#include <fmt/format.h>

#include "reports/gate/outcome.hpp"

namespace ordo::reports {
namespace {

/// `characters` of the text as percent and two hexadecimal digits.
std::string escaped(const std::string& text, std::string_view characters) {
    std::string safe;
    for (const char c : text) {
        if (characters.find(c) == std::string_view::npos) safe += c;
        else safe += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return safe;
}

std::string message(const std::string& text) { return escaped(text, "%\r\n"); }
std::string property(const std::string& text) { return escaped(text, "%\r\n:,"); }

}  // namespace

std::string annotations(const std::vector<GateResult>& results) {
    std::string text;
    for (const auto& result : results) {
        for (const auto& check : result.checks) {
            if (check.verdict == studies::Verdict::pass) continue;
            text +=
                fmt::format("::error title={}::{}\n", property(result.study + ": " + name_of(check)),
                            message(fmt::format("{}: expected {}; found {}", check.subject, check.claim, check.found)));
        }
    }
    return text;
}

}  // namespace ordo::reports

#include <fmt/format.h>

#include <algorithm>

#include "reports/gate/outcome.hpp"
#include "studies/reader/json_input.hpp"

namespace ordo::reports {
namespace {

using studies::Check;
using studies::Json;
using studies::Verdict;

/// `text` for XML 1.0: bytes that are not UTF-8 and the characters it has no place for are replaced.
std::string escaped(const std::string& text) {
    auto utf8 = Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
    for (const char* nowhere : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
        for (auto at = utf8.find(nowhere); at != std::string::npos; at = utf8.find(nowhere)) utf8.replace(at, 3, "?");
    }
    std::string safe;
    for (const char c : utf8) {
        switch (c) {
            case '&': safe += "&amp;"; break;
            case '<': safe += "&lt;"; break;
            case '>': safe += "&gt;"; break;
            case '"': safe += "&quot;"; break;
            default: safe += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
        }
    }
    return safe;
}

std::string junit_case(const std::string& study, const Check& check) {
    const std::string open = fmt::format("    <testcase classname=\"{}\" name=\"{}\"", escaped(study),
                                         escaped(check.subject + ": " + check.claim));
    if (check.verdict == Verdict::pass) return open + "/>\n";
    const std::string message =
        escaped(studies::text_of(check.verdict) + ": expected " + check.claim + ", found " + check.found);
    return open +
           fmt::format(">\n      <failure type=\"{}\" message=\"{}\">source: {}; {}</failure>\n    </testcase>\n",
                       name_of(check), message, escaped(check.source), escaped(advice(check.fault)));
}

}  // namespace

std::string junit(const std::vector<GateResult>& results) {
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const auto& result : results) {
        const auto failed = [](const Check& check) { return check.verdict != Verdict::pass; };
        xml += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n", escaped(result.study),
                           result.checks.size(), std::count_if(result.checks.begin(), result.checks.end(), failed));
        for (const auto& check : result.checks) xml += junit_case(result.study, check);
        xml += "  </testsuite>\n";
    }
    return xml + "</testsuites>\n";
}

}  // namespace ordo::reports

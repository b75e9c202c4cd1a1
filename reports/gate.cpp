#include "reports/gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/reader/json_input.hpp"

namespace ordo::reports {
namespace {

using studies::Check;
using studies::Json;
using studies::Run;
using studies::Verdict;

constexpr const char* baseline_schema = "ordo-baseline-1";

std::string source_of(const Baseline& baseline) {
    return fmt::format("baseline of {} at {}: {}", baseline.time_utc, baseline.revision, baseline.because);
}

bool same_axes(const Run& a, const Run& b) {
    const auto equal = [](const auto& x, const auto& y) { return x.name == y.name && x.value == y.value; };
    return a.solver == b.solver && std::equal(a.axes.begin(), a.axes.end(), b.axes.begin(), b.axes.end(), equal);
}

/// Relative difference of two errors; 0 where both are absent, infinite where one is.
double difference(double now, double accepted) {
    if (std::isnan(now) && std::isnan(accepted)) return 0;
    if (now == accepted) return 0;
    const double relative = std::abs(now - accepted) / std::abs(accepted);
    return std::isfinite(relative) ? relative : std::numeric_limits<double>::infinity();
}

Check quantity_check(const Report& report, const Baseline& baseline, const std::string& key) {
    double worst = 0;
    for (const auto& accepted : baseline.report.result.runs) {
        for (const auto& run : report.result.runs) {
            if (same_axes(run, accepted)) worst = std::max(worst, difference(run.error(key), accepted.error(key)));
        }
    }
    return {fmt::format("errors as accepted within {} relative", baseline.band), key, source_of(baseline),
            worst <= baseline.band ? Verdict::pass : Verdict::fail, fmt::format("largest difference {:.3g}", worst)};
}

/// Every accepted run is there and ends as it did; no other run is.
Check runs_check(const Report& report, const Baseline& baseline) {
    const auto& now = report.result.runs;
    const auto& accepted = baseline.report.result.runs;
    const auto matches = [](const Run& run, const std::vector<Run>& others) {
        return std::any_of(others.begin(), others.end(),
                           [&](const Run& other) { return same_axes(run, other) && run.status == other.status; });
    };
    const auto missing =
        std::count_if(accepted.begin(), accepted.end(), [&](const Run& run) { return !matches(run, now); });
    const auto extra = std::count_if(now.begin(), now.end(), [&](const Run& run) { return !matches(run, accepted); });
    const bool alike = missing + extra == 0 && now.size() == accepted.size();
    return {"the accepted runs, ending alike", "all runs", source_of(baseline), alike ? Verdict::pass : Verdict::fail,
            fmt::format("{} runs, {} accepted, {} missing or ending otherwise, {} new", now.size(), accepted.size(),
                        missing, extra)};
}

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
    return open + fmt::format(">\n      <failure message=\"{}\">source: {}</failure>\n    </testcase>\n", message,
                              escaped(check.source));
}

}  // namespace

std::string baseline_path(const std::string& folder, const std::string& study) {
    return folder + "/" + safe_path(study) + ".json";
}

std::string to_json(const Baseline& baseline) {
    const Json json{{"schema", baseline_schema},
                    {"because", baseline.because},
                    {"time_utc", baseline.time_utc},
                    {"revision", baseline.revision},
                    {"compiler", baseline.compiler},
                    {"band", baseline.band},
                    {"report", Json::parse(to_json(baseline.report))}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Baseline read_baseline(const std::string& path) {
    const Json json = studies::parse_json(studies::read_text(path), path);
    const studies::Node root(json, path);
    root.only({"schema", "because", "time_utc", "revision", "compiler", "band", "report"});
    root.at("schema").one_of({baseline_schema});
    return {.because = root.at("because").text(),
            .time_utc = root.at("time_utc").text(),
            .revision = root.at("revision").text(),
            .compiler = root.at("compiler").text(),
            .band = root.at("band").number(),
            .report = report_from_json(root.at("report").json().dump(), path + ": /report")};
}

std::vector<Check> checks_against(const Report& report, const Baseline& baseline) {
    if (report.result.study.document != baseline.report.result.study.document) {
        return {{"the same study as accepted", "the study", source_of(baseline), Verdict::fail,
                 "the study differs from the accepted one; run the accepted one, or accept the new report"}};
    }
    std::vector<Check> checks{runs_check(report, baseline)};
    for (const auto& quantity : report.result.study.measure.quantities) {
        checks.push_back(quantity_check(report, baseline, quantity.key()));
    }
    return checks;
}

Verdict GateResult::verdict() const {
    Verdict worst = Verdict::pass;
    for (const auto& check : checks) {
        if (check.verdict == Verdict::fail) return Verdict::fail;
        if (check.verdict == Verdict::inconclusive) worst = Verdict::inconclusive;
    }
    return checks.empty() ? Verdict::inconclusive : worst;
}

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

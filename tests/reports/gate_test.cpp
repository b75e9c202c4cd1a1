// The regression gate: a report against an accepted one, and JUnit XML.
#include "reports/gate.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/reports/samples.hpp"

using namespace ordo;
using outside::Folder;
using reports::Baseline;
using reports::checks_against;
using reports::GateResult;
using reports::Report;
using samples::Json;
using studies::Check;
using studies::Verdict;

namespace {

Report sample() { return samples::report_of(samples::study()); }

Baseline accepted(Report report) {
    return {"a test", "2015-03-01T00:00:00Z", "abc", "GNU 12", 1e-6, std::move(report)};
}

/// The sample with other runs, against the sample.
std::vector<Check> compared(std::vector<studies::Run> runs) {
    return checks_against(samples::report_of(samples::study(), std::move(runs)), accepted(sample()));
}

bool all_pass(const std::vector<Check>& checks) {
    return !checks.empty() &&
           std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.verdict == Verdict::pass; });
}

/// The sample's runs, the error of the second one times `factor`.
std::vector<studies::Run> with_error_times(double factor) {
    auto runs = sample().result.runs;
    runs[1].errors[0].value *= factor;
    return runs;
}

/// A folder with one file, "gate.xml", as read by Python's XML parser: every tag with its attributes and text.
std::string parsed(const std::string& xml) {
    const Folder folder;
    folder.write("gate.xml", xml);
    const std::string program =
        "import sys, xml.etree.ElementTree as tree\n"
        "for node in tree.parse('gate.xml').iter():\n"
        "    print(node.tag, sorted(node.attrib.items()), (node.text or '').strip().encode('utf8'))\n";
    const auto outcome = outside::run({ORDO_PYTHON, "-c", program}, folder.here());
    INFO(outcome.err);
    CHECK(outcome.code == 0);
    return outcome.out;
}

}  // namespace

TEST_CASE("gate: the accepted report itself passes", "[unit]") {
    const auto checks = compared(sample().result.runs);
    CHECK(checks.size() == 2);
    CHECK(all_pass(checks));
    CHECK_THAT(checks.back().source, ContainsSubstring("a test") && ContainsSubstring("abc"));
}

TEST_CASE("gate: every kind of report passes against itself", "[unit]") {
    for (const auto& [kind, report] : samples::reports_of_every_kind()) {
        INFO(kind);
        CHECK(all_pass(checks_against(report, accepted(report))));
    }
}

TEST_CASE("gate: the band is relative and two-sided", "[unit]") {
    CHECK(all_pass(compared(with_error_times(1 + 1e-9))));
    CHECK(all_pass(compared(with_error_times(1 - 1e-9))));
    CHECK(all_pass(compared(with_error_times(1 + 0.9e-6))));
    CHECK_FALSE(all_pass(compared(with_error_times(1 + 1.1e-6))));
    CHECK_FALSE(all_pass(compared(with_error_times(1 + 1e-3))));
    CHECK_FALSE(all_pass(compared(with_error_times(1 - 1e-3))));
    CHECK_FALSE(all_pass(compared(with_error_times(0))));
    CHECK_FALSE(all_pass(compared(with_error_times(-1))));
}

TEST_CASE("alarm: a NaN or an infinity on one side fails, on both it is the same", "[alarm]") {
    const double bad = GENERATE(std::nan(""), HUGE_VAL, -HUGE_VAL);
    const auto with_nan = samples::report_of(samples::study(), with_error_times(bad));
    CHECK_FALSE(all_pass(checks_against(with_nan, accepted(sample()))));
    CHECK_FALSE(all_pass(checks_against(sample(), accepted(with_nan))));
    CHECK(all_pass(checks_against(with_nan, accepted(with_nan))));
}

TEST_CASE("alarm: an accepted error of zero allows none other", "[alarm]") {
    const auto with_zero = samples::report_of(samples::study(), with_error_times(0));
    CHECK(all_pass(checks_against(with_zero, accepted(with_zero))));
    CHECK_FALSE(all_pass(checks_against(sample(), accepted(with_zero))));
}

TEST_CASE("alarm: a run that is missing, new, repeated or ends otherwise fails", "[alarm]") {
    auto missing = sample().result.runs;
    missing.pop_back();
    CHECK_FALSE(all_pass(compared(missing)));
    CHECK_FALSE(all_pass(checks_against(sample(), accepted(samples::report_of(samples::study(), missing)))));

    auto repeated = sample().result.runs;
    repeated.push_back(repeated.back());
    repeated.back().id = 3;
    CHECK_FALSE(all_pass(compared(repeated)));

    auto other = sample().result.runs;
    other.push_back(other.back());
    other.back().id = 3;
    other.back().axes[0].value = 32;
    CHECK_FALSE(all_pass(compared(other)));

    auto broken = sample().result.runs;
    broken[0].status = studies::Status::diverged;
    CHECK_FALSE(all_pass(compared(broken)));
}

TEST_CASE("alarm: a different question is not compared", "[alarm]") {
    Json changed = samples::study();
    changed["expect"][0]["within"] = 0.3;
    const auto checks = checks_against(samples::report_of(changed), accepted(sample()));
    REQUIRE(checks.size() == 1);
    CHECK(checks[0].verdict == Verdict::fail);
    CHECK_THAT(checks[0].found, ContainsSubstring("study differs"));
}

TEST_CASE("gate: a baseline comes back from its file, with who vouches for it", "[unit]") {
    const Folder folder;
    Baseline baseline = accepted(sample());
    baseline.because = "reason with \"quotes\",\nlines and a byte \xff that is no UTF-8";
    baseline.band = 1e-3;
    folder.write("b.json", to_json(baseline));
    const auto back = reports::read_baseline((folder.path() / "b.json").string());
    CHECK_THAT(back.because, ContainsSubstring("reason with \"quotes\",\nlines"));
    CHECK(back.time_utc == baseline.time_utc);
    CHECK(back.revision == baseline.revision);
    CHECK(back.compiler == baseline.compiler);
    CHECK(back.band == 1e-3);
    CHECK(to_json(back.report) == to_json(baseline.report));
    CHECK(all_pass(checks_against(sample(), back)));
}

TEST_CASE("gate: what is not a baseline is refused", "[unit]") {
    const Folder folder;
    const auto path = (folder.path() / "b.json").string();
    CHECK_THROWS_AS(reports::read_baseline(path), InputError);
    Json json = Json::parse(to_json(accepted(sample())));
    const auto throws = [&](const Json& document) {
        folder.write("b.json", document.dump());
        CHECK_THROWS_AS(reports::read_baseline(path), InputError);
    };
    throws(Json::parse(to_json(sample())));
    throws(json["report"]);
    for (const auto& [member, value] : json.items()) {
        Json without = json;
        without.erase(member);
        INFO(member);
        throws(without);
    }
    json["extra"] = 1;
    throws(json);
}

TEST_CASE("gate: baselines stay in their folder", "[unit]") {
    CHECK(reports::baseline_path("base", "a/b") == "base/a/b.json");
    CHECK(reports::baseline_path("base", "../../x") == "base/_./_./x.json");
    CHECK(reports::baseline_path("base", "") == "base/_.json");
}

TEST_CASE("gate: the verdict is that of the worst check, and without checks there is none", "[unit]") {
    const Check pass{"c", "s", "", Verdict::pass, ""};
    const Check fail{"c", "s", "", Verdict::fail, ""};
    const Check unknown{"c", "s", "", Verdict::inconclusive, ""};
    CHECK(GateResult{"x", {pass, pass}}.verdict() == Verdict::pass);
    CHECK(GateResult{"x", {pass, unknown}}.verdict() == Verdict::inconclusive);
    CHECK(GateResult{"x", {unknown, fail, pass}}.verdict() == Verdict::fail);
    CHECK(GateResult{"x", {}}.verdict() == Verdict::inconclusive);
}

TEST_CASE("gate: JUnit has a suite a study and a case a check; inconclusive is a failure", "[unit]") {
    const Check pass{"order 2 +- 0.1", "mpm: u", "a paper", Verdict::pass, "1.99"};
    const Check fail{"error at most 1", "mpm: u", "another", Verdict::fail, "largest 2"};
    const Check unknown{"at least one expectation", "the study", "rule", Verdict::inconclusive, "nothing"};
    const auto tree = parsed(reports::junit({{"first", {pass, fail, unknown}}, {"second", {pass}}}));
    CHECK_THAT(tree, ContainsSubstring("testsuite [('failures', '2'), ('name', 'first'), ('tests', '3')]"));
    CHECK_THAT(tree, ContainsSubstring("testsuite [('failures', '0'), ('name', 'second'), ('tests', '1')]"));
    CHECK_THAT(tree, ContainsSubstring("testcase [('classname', 'first'), ('name', 'mpm: u: order 2 +- 0.1')]"));
    CHECK_THAT(tree, ContainsSubstring("failure [('message', 'fail: expected error at most 1, found largest 2')]"));
    CHECK_THAT(tree, ContainsSubstring("failure [('message', 'inconclusive: expected at least one expectation"));
    CHECK_THAT(tree, ContainsSubstring("b'source: another'"));
}

TEST_CASE("alarm: JUnit stays well-formed whatever a study is called", "[alarm]") {
    const std::string name = "<a b=\"c\">&amp;]]>--'\x01\x1b\n\t\x7f\xff\xc3\xa9\xef\xbf\xbf\xef\xbf\xbe\xed\xa0\x80";
    const auto tree = parsed(reports::junit({{name, {{name, name, name, Verdict::fail, name}}}}));
    CHECK_THAT(tree, ContainsSubstring("('name', '<a b=\"c\">&amp;]]>--"));
    CHECK_THAT(tree, ContainsSubstring("\xc3\xa9"));
    CHECK(std::count(tree.begin(), tree.end(), '\n') == 4);
}

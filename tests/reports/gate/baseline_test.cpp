// A baseline and its file; what is no twin.
#include "reports/gate/baseline.hpp"

#include <cmath>

#include "core/error.hpp"
#include "reports/gate/compare.hpp"
#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/reports/gate/gated.hpp"

using namespace ordo;
using namespace ordo::gated;
using outside::Folder;
using reports::Baseline;
using reports::Report;
using samples::Json;

namespace {

/// Why this report cannot stand beside the sample; "" where it can.
std::string refusal(const Report& report) {
    try {
        reports::baseline_of({sample(), report}, {"r.json", "twin.json"}, "a test");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("baseline: comes back from its file, with who vouches for it", "[unit]") {
    const Folder folder;
    Baseline baseline = accepted_with_twin();
    baseline.because = "reason with \"quotes\",\nlines and a byte \xff that is no UTF-8";
    baseline.time_ratio = 123.5;
    folder.write("b.json", to_json(baseline));
    const auto back = reports::read_baseline((folder.path() / "b.json").string());
    CHECK_THAT(back.because, ContainsSubstring("reason with \"quotes\",\nlines"));
    REQUIRE(back.makers.size() == 2);
    CHECK(back.makers[0].revision == baseline.makers[0].revision);
    CHECK(back.makers[0].compiler == baseline.makers[0].compiler);
    CHECK_THAT(back.makers[1].flags, ContainsSubstring("-ffp-contract=fast"));
    CHECK(back.time_ratio == 123.5);
    CHECK(back.study == "sample");
    CHECK(to_json(back) == to_json(baseline));
    CHECK(all_pass(checks_against(sample(), back)));
    CHECK(all_pass(checks_against(twin(), back)));
}

TEST_CASE("baseline: every kind of report comes back from its file", "[unit]") {
    const Folder folder;
    for (const auto& [kind, report] : samples::reports_of_every_kind()) {
        INFO(kind);
        folder.write("b.json", to_json(accepted(report)));
        const auto back = reports::read_baseline((folder.path() / "b.json").string());
        CHECK(to_json(back) == to_json(accepted(report)));
        CHECK(all_pass(checks_against(report, back)));
    }
}

TEST_CASE("baseline: one line a figure, so that a diff names what changed", "[unit]") {
    const auto baseline = accepted(sample());
    const auto text = to_json(baseline);
    CHECK(std::count(text.begin(), text.end(), '\n') < 20 + static_cast<std::ptrdiff_t>(baseline.figures.size()));
    CHECK_THAT(text, ContainsSubstring("{\"kind\":\"error\",\"of\":\"mpm, cells = 4"));
}

TEST_CASE("baseline: what is none is refused", "[unit]") {
    const Folder folder;
    const auto path = (folder.path() / "b.json").string();
    CHECK_THROWS_AS(reports::read_baseline(path), InputError);
    const Json json = Json::parse(to_json(accepted(sample())));
    const auto throws = [&](const Json& document) {
        folder.write("b.json", document.dump());
        CHECK_THROWS_AS(reports::read_baseline(path), InputError);
    };
    throws(Json::parse(to_json(sample())));
    throws(Json::array());
    for (const auto& [member, value] : json.items()) {
        Json without = json;
        without.erase(member);
        INFO(member);
        throws(without);
    }
    for (const char* list : {"reports", "runs", "figures"}) {
        Json empty = json;
        empty[list] = Json::array();
        throws(empty);
    }
    for (const Json& tolerance : {Json(-1), Json(nullptr), Json("1")}) {
        Json odd = json;
        odd["figures"][0]["tolerance"] = tolerance;
        throws(odd);
    }
    Json extra = json;
    extra["extra"] = 1;
    throws(extra);
}

TEST_CASE("alarm: what is no twin measures no scatter, and is refused by name", "[alarm]") {
    CHECK(refusal(twin()).empty());
    CHECK_THAT(refusal(sample()), ContainsSubstring("twin.json: is no twin: the same compiler"));

    Json changed = samples::study();
    changed["scene"]["rho"] = 2;
    CHECK_THAT(refusal(samples::report_of(changed)), ContainsSubstring("/scene/rho was 1, is 2"));

    auto fewer = twin();
    fewer.result.runs.pop_back();
    CHECK_THAT(refusal(fewer), ContainsSubstring("2 runs, not 3"));

    auto broken = twin();
    broken.result.runs[0].status = studies::Status::diverged;
    CHECK_THAT(refusal(broken), ContainsSubstring("is diverged, where ours 'mpm, cells = 4, dt = 0.005' is ok"));

    auto empty = twin();
    empty.result.runs[0].errors[0].value = std::nan("");
    CHECK_THAT(refusal(empty), ContainsSubstring("only one of both has a value of 'mpm, cells = 4"));

    auto more = twin();
    more.result.runs.back().work.push_back({"more", 1});
    CHECK_FALSE(refusal(more).empty());
}

TEST_CASE("baseline: they stay in their folder", "[unit]") {
    CHECK(reports::baseline_path("base", "a/b") == "base/a/b.json");
    CHECK(reports::baseline_path("base", "../../x") == "base/_./_./x.json");
    CHECK(reports::baseline_path("base", "") == "base/_.json");
}

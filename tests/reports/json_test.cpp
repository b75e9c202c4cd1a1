// A report survives the way to JSON and back, and is judged by its runs, whatever else it says.
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.hpp"
#include "reports/report.hpp"
#include "tests/catch.hpp"
#include "tests/reports/samples.hpp"

using namespace ordo;
using reports::Report;
using reports::report_from_json;
using reports::to_json;
using samples::Json;
using studies::Verdict;

namespace {

Json json_of(const Report& report) { return Json::parse(to_json(report)); }

Report read(const Json& json) { return report_from_json(json.dump(), "r.json"); }

/// What the reader says about this text; "" where it takes it.
std::string refusal(const std::string& text) {
    try {
        report_from_json(text, "r.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// The verdict of the check with this claim in it.
Verdict verdict_of(const Report& report, const std::string& claim) {
    for (const auto& check : report.result.checks) {
        if (check.claim.find(claim) != std::string::npos) return check.verdict;
    }
    FAIL("no check is about '" << claim << "'");
    return Verdict::inconclusive;
}

/// A sample whose finest run has this error instead of its own. (That of the middle one has no weight in the slope.)
Json with_error(const Json& value) {
    Json json = json_of(samples::report_of(samples::study()));
    json["runs"][2]["errors"]["displacement.rms"] = value;
    return json;
}

/// Numbers the runs by their places again, as somebody who edits the list would.
void renumber(Json& json) {
    int id = 0;
    for (auto& run : json["runs"]) run["run"] = id++;
}

}  // namespace

TEST_CASE("json: the samples are what they are called", "[unit]") {
    const auto all = samples::reports_of_every_kind();
    CHECK(all.at("ok").result.verdict == Verdict::pass);
    CHECK(all.at("reference").result.runs.back().status == studies::Status::reference);
    CHECK(all.at("diverged").result.runs.back().status == studies::Status::diverged);
    CHECK(std::isnan(all.at("nan").result.runs[1].error("displacement.rms")));
    CHECK(std::isinf(all.at("two points").result.fits.front().outcome.fit->low));
    CHECK(all.at("published").result.published.front().agrees);
    CHECK_FALSE(all.at("published").result.published.back().agrees);
    CHECK(all.at("nothing expected").result.verdict == Verdict::inconclusive);
    CHECK(all.at("two solvers").result.series.size() == 2);
}

TEST_CASE("json: every kind of report comes back as it went", "[unit]") {
    for (const auto& [kind, report] : samples::reports_of_every_kind()) {
        INFO(kind);
        const auto text = to_json(report);
        CHECK(to_json(report_from_json(text, "r.json")) == text);
        CHECK(report_from_json(text, "r.json").result.verdict == report.result.verdict);
    }
}

TEST_CASE("json: what is not finite is null, and every other number keeps its bits", "[unit]") {
    const auto all = samples::reports_of_every_kind();
    const auto nan = json_of(all.at("nan"));
    CHECK(nan["runs"][1]["errors"]["displacement.rms"].is_null());
    CHECK(nan["runs"][1]["drift"]["mass"].is_null());
    const auto two = json_of(all.at("two points"));
    CHECK(two["fits"][0]["low"].is_null());
    CHECK(two["fits"][0]["high"].is_null());

    auto runs = all.at("ok").result.runs;
    for (const double value : {5e-324, 0.1, 1.0 / 3, 1.7976931348623157e308}) {
        runs[0].errors[0].value = value;
        const auto back = read(json_of(samples::report_of(samples::study(), runs)));
        CHECK(back.result.runs[0].errors[0].value == value);
    }
}

TEST_CASE("json: a report says what was found, and why where nothing was", "[unit]") {
    const auto all = samples::reports_of_every_kind();
    const auto ok = json_of(all.at("ok"));
    const auto& fit = *all.at("ok").result.fits.front().outcome.fit;
    CHECK(ok["verdict"] == "pass");
    CHECK(ok["fits"][0]["order"] == fit.order);
    CHECK(ok["fits"][0]["low"] == fit.low);
    CHECK(ok["fits"][0]["high"] == fit.high);
    CHECK(ok["fits"][0]["coefficient"] == fit.coefficient);
    CHECK(ok["fits"][0]["correlation"] == fit.correlation);
    CHECK(ok["fits"][0]["neighbours"].size() == 2);
    CHECK(ok["fits"][0]["used"].size() == 3);
    CHECK(ok["fits"][0]["verdict"] == "converges");
    CHECK(ok["provenance"]["run_seconds"].size() == 3);
    CHECK_THAT(json_of(all.at("nan"))["fits"][0]["reason"].get<std::string>(), ContainsSubstring("nan"));
    const auto reference = json_of(all.at("reference"));
    CHECK(reference["fits"][0]["left_out"][0]["run"] == 3);
    CHECK(reference["fits"][0]["left_out"][0]["why"] == "it is the reference");
    const auto match = json_of(all.at("published"))["published"][0];
    CHECK(match["printed"] == "2.6865e-04");
    CHECK(match["ours_as_printed"] == "2.6865e-04");
    CHECK(match["run"] == 0);
}

TEST_CASE("json: the same report is the same text", "[unit]") {
    const auto once = json_of(samples::report_of(samples::study()));
    auto again = json_of(samples::report_of(samples::study()));
    again["provenance"]["time_utc"] = once["provenance"]["time_utc"];
    CHECK(once.dump() == again.dump());
}

TEST_CASE("alarm: an edited verdict, fit, check or match changes nothing", "[alarm]") {
    const auto report = samples::reports_of_every_kind().at("published");
    const auto text = to_json(report);
    Json json = Json::parse(text);
    REQUIRE(json["verdict"] == "fail");
    json["verdict"] = "pass";
    json["fits"][0]["order"] = 7;
    json["fits"][0]["used"] = Json::array();
    json["series"][0]["runs"] = {0};
    for (auto& check : json["checks"]) check["verdict"] = "pass";
    json["published"][1]["agrees"] = true;
    json["published"][1]["judged"] = false;
    CHECK(to_json(read(json)) == text);
    CHECK(read(json).result.verdict == Verdict::fail);
}

TEST_CASE("alarm: an edited error is judged", "[alarm]") {
    REQUIRE(read(with_error(1.7e-5)).result.verdict == Verdict::pass);
    CHECK(verdict_of(read(with_error(4e-5)), "order 2") != Verdict::pass);
    CHECK(verdict_of(read(with_error(7e-6)), "order 2") != Verdict::pass);
    CHECK(verdict_of(read(with_error(2e-3)), "error at most") == Verdict::fail);
}

TEST_CASE("alarm: an error that is null, zero or negative fails", "[alarm]") {
    const Json value = GENERATE(as<Json>{}, nullptr, 0.0, -0.0, -1.7e-5);
    const auto report = read(with_error(value));
    CHECK(report.result.verdict == Verdict::fail);
    CHECK(verdict_of(report, "order 2") == Verdict::fail);
    CHECK(verdict_of(report, "error at most") == Verdict::fail);
}

TEST_CASE("alarm: a run without its error fails", "[alarm]") {
    auto json = with_error(1.7e-5);
    json["runs"][2]["errors"] = Json::object();
    CHECK(verdict_of(read(json), "order 2") == Verdict::fail);
    CHECK(verdict_of(read(json), "error at most") == Verdict::fail);
}

TEST_CASE("alarm: a run that was removed, repeated, added or moved fails by name", "[alarm]") {
    using Edit = std::function<void(Json&)>;
    const std::vector<Edit> edits{
        [](Json& runs) { runs.erase(0); },
        [](Json& runs) { runs.erase(1); },
        [](Json& runs) { runs.erase(2); },
        [](Json& runs) { runs = Json::array(); },
        [](Json& runs) { runs.push_back(runs[0]); },
        [](Json& runs) { runs[1] = runs[0]; },
        [](Json& runs) {
            runs.push_back(runs[0]);
            runs[3]["axes"]["cells"] = 32;
        },
        [](Json& runs) { runs[1]["axes"]["cells"] = 9; },
        [](Json& runs) { runs[1]["axes"]["ppc"] = 1; },
        [](Json& runs) { runs[1]["solver"] = "rrm"; },
    };
    for (std::size_t k = 0; k < edits.size(); ++k) {
        INFO("edit " << k);
        Json json = json_of(samples::report_of(samples::study()));
        edits[k](json["runs"]);
        renumber(json);
        const auto report = read(json);
        CHECK(report.result.verdict == Verdict::fail);
        CHECK(verdict_of(report, "every planned run ends") == Verdict::fail);
    }
}

TEST_CASE("alarm: a run that broke fails, one that blew up unless it is allowed to", "[alarm]") {
    Json json = json_of(samples::report_of(samples::study()));
    for (const char* status : {"failed", "timed_out", "diverged"}) {
        json["runs"][2]["status"] = status;
        CHECK(verdict_of(read(json), "every planned run ends") == Verdict::fail);
    }
    json["study"]["allow"] = "diverged";
    CHECK(verdict_of(read(json), "every planned run ends") == Verdict::pass);
    json["runs"][2]["status"] = "failed";
    CHECK(verdict_of(read(json), "every planned run ends") == Verdict::fail);
}

TEST_CASE("alarm: what is not a report is refused on one line", "[alarm]") {
    const auto good = to_json(samples::report_of(samples::study()));
    REQUIRE(refusal(good).empty());
    std::vector<std::string> bad{"",         "{",
                                 "null",     "[]",
                                 "42",       "\"ordo-report-1\"",
                                 "{}",       samples::study().dump(),
                                 "\xff\xfe", std::string(1, '\0'),
                                 good + good};
    for (const double part : {0.01, 0.5, 0.99}) {
        bad.push_back(good.substr(0, static_cast<std::size_t>(part * static_cast<double>(good.size()))));
    }
    const std::string bomb = std::string(200'000, '[') + std::string(200'000, ']');
    bad.push_back(bomb);
    bad.push_back("{\"schema\": \"ordo-report-1\", \"study\": " + bomb + "}");
    for (const auto& text : bad) {
        INFO(text.substr(0, 60));
        const auto said = refusal(text);
        CHECK_THAT(said, ContainsSubstring("r.json"));
        CHECK(std::count(said.begin(), said.end(), '\n') == 0);
    }
    Json other = Json::parse(good);
    other["schema"] = "ordo-report-2";
    CHECK_THAT(refusal(other.dump()), ContainsSubstring("ordo-report-1"));
}

TEST_CASE("alarm: a report with a fault is refused where the fault stands", "[alarm]") {
    struct Fault {
        const char* place;
        Json value;
    };
    const std::vector<Fault> faults{
        {"/runs", Json::object()},
        {"/runs", "none"},
        {"/runs/1", 3},
        {"/runs/1/run", 0},
        {"/runs/1/run", 1.5},
        {"/runs/1/run", 1e300},
        {"/runs/1/status", "fine"},
        {"/runs/1/status", 1},
        {"/runs/1/reason", nullptr},
        {"/runs/1/h", "wide"},
        {"/runs/1/axes", {1, 2}},
        {"/runs/1/errors", nullptr},
        {"/runs/1/errors/displacement.rms", "small"},
        {"/runs/1/extra", 0},
        {"/extra", 0},
        {"/study", "sample"},
        {"/study/scene/E", -1},
        {"/study/extra", 0},
        {"/provenance", nullptr},
        {"/provenance/cores", 0.5},
        {"/provenance/jobs", -1e300},
        {"/provenance/run_seconds", 1},
        {"/provenance/host", "here"},
    };
    const Json good = json_of(samples::report_of(samples::study()));
    for (const auto& fault : faults) {
        Json json = good;
        json[Json::json_pointer(fault.place)] = fault.value;
        INFO(fault.place << " = " << fault.value.dump());
        const auto said = refusal(json.dump());
        CHECK_THAT(said, ContainsSubstring("r.json: /") || ContainsSubstring("r.json: unknown member"));
    }
    for (const char* member : {"schema", "study", "runs", "provenance"}) {
        Json json = good;
        json.erase(member);
        INFO(member);
        CHECK_FALSE(refusal(json.dump()).empty());
    }
}

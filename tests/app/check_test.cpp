// ordo check, from outside.
#include <functional>

#include "tests/app/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::make_report;
using outside::make_twin;
using outside::scale_error;
using outside::Words;
using samples::Json;

namespace {

/// Accepts the report "r.json" with its twin.
void accept(const Folder& folder) {
    make_twin(folder);
    REQUIRE(folder.ordo({"accept", "r.json", "twin.json", "--because", "x", "--into", "base"}).code == 0);
}

/// Changes the report "r.json".
void edit(const Folder& folder, const std::function<void(Json&)>& change) {
    auto report = Json::parse(folder.read("r.json"));
    change(report);
    folder.write("r.json", report.dump());
}

const Words against_base{"check", "r.json", "--against", "base"};

}  // namespace

TEST_CASE("cli: a good report passes its own gate, which says that it is the only one", "[cli]") {
    const Folder folder;
    make_report(folder);
    const auto checked = folder.ordo({"check", "r.json"});
    CHECK(checked.code == 0);
    CHECK(checked.err.empty());
    CHECK_THAT(checked.out, ContainsSubstring("sample: pass") && ContainsSubstring("expectations only"));
}

TEST_CASE("cli: a gate over several reports fails with the worst of them", "[cli]") {
    const Folder folder;
    make_report(folder, {"expect.0.order=1"});
    folder.write("bad.json", folder.read("r.json"));
    make_report(folder);
    CHECK(folder.ordo({"check", "r.json", "r.json"}).code == 0);
    CHECK(folder.ordo({"check", "r.json", "bad.json"}).code == 1);
    CHECK(folder.ordo({"check", "bad.json", "r.json"}).code == 1);
}

TEST_CASE("alarm: a report that moved away from its baseline fails, within its own expectations", "[cli]") {
    const Folder folder;
    make_report(folder);
    accept(folder);
    scale_error(folder, 1 + 1e-9);
    CHECK(folder.ordo(against_base).code == 0);
    scale_error(folder, 1 + 1e-4);
    CHECK(folder.ordo({"check", "r.json"}).code == 0);
    const auto checked = folder.ordo(against_base);
    CHECK(checked.code == 1);
    CHECK_THAT(checked.out, ContainsSubstring("sample: fail") && ContainsSubstring("error_changed") &&
                                ContainsSubstring("1 outside, the farthest of mpm, cells = 8, dt = 0.005"));
}

TEST_CASE("alarm: each fault against a baseline fails by its own name, in every output", "[cli]") {
    const std::vector<std::pair<std::string, std::function<void(Json&)>>> faults{
        {"error_is_nan", [](Json& report) { report["runs"][1]["errors"]["displacement.rms"] = nullptr; }},
        {"error_is_zero", [](Json& report) { report["runs"][1]["errors"]["displacement.rms"] = 0; }},
        {"error_is_negative", [](Json& report) { report["runs"][1]["errors"]["displacement.rms"] = -1e-4; }},
        {"point_missing", [](Json& report) { report["runs"].erase(2); }},
        {"point_repeated",
         [](Json& report) {
             report["runs"].push_back(report["runs"][2]);
             report["runs"][3]["run"] = 3;
         }},
        {"nothing_measured", [](Json& report) { report["runs"] = Json::array(); }},
        {"runs_changed", [](Json& report) { report["runs"][0]["status"] = "diverged"; }},
        {"order_changed", [](Json& report) { report["runs"][2]["errors"]["displacement.rms"] = 1e-4; }},
        {"work_changed", [](Json& report) { report["runs"][0]["work"].begin().value() = 1; }},
        {"study_differs", [](Json& report) { report["study"]["scene"]["E"] = 50; }}};
    const Folder folder;
    make_report(folder);
    accept(folder);
    const std::string good = folder.read("r.json");
    Words words = against_base;
    words.insert(words.end(), {"--junit", "gate.xml", "--summary", "gate.md", "--annotations"});
    REQUIRE(folder.ordo(words).code == 0);
    for (const auto& [name, change] : faults) {
        folder.write("r.json", good);
        edit(folder, change);
        const auto checked = folder.ordo(words);
        INFO(name << checked.out << checked.err);
        CHECK(checked.code == 1);
        CHECK_THAT(checked.out, ContainsSubstring("  " + name + "  ") && ContainsSubstring("  " + name + ": ") &&
                                    ContainsSubstring("::error title=sample%3A " + name + "::"));
        CHECK_THAT(folder.read("gate.xml"), ContainsSubstring("type=\"" + name + "\""));
        std::string escaped = name;
        for (auto at = escaped.find('_'); at != std::string::npos; at = escaped.find('_', at + 2))
            escaped.insert(at, "\\");
        CHECK_THAT(folder.read("gate.md"), ContainsSubstring("| " + escaped + " |"));
    }
}

TEST_CASE("alarm: another study, or none accepted, is no baseline", "[cli]") {
    const Folder folder;
    make_report(folder);
    const auto none = folder.ordo(against_base);
    CHECK(none.code == 1);
    CHECK_THAT(none.out, ContainsSubstring("no_baseline") && ContainsSubstring("there is no base/sample.json") &&
                             ContainsSubstring("ordo accept REPORT --because TEXT"));
    accept(folder);
    make_report(folder, {"scene.rho=2"});
    const auto other = folder.ordo(against_base);
    CHECK(other.code == 1);
    CHECK_THAT(other.out, ContainsSubstring("study: /scene/rho  study_differs  1         2"));
}

TEST_CASE("alarm: a baseline that cannot be read is a bad input, not a missing one", "[cli]") {
    const Folder folder;
    make_report(folder);
    folder.write("base/sample.json", "{");
    CHECK(folder.ordo(against_base).code == 2);
    folder.write("base/sample.json", folder.read("r.json"));
    const auto checked = folder.ordo(against_base);
    CHECK(checked.code == 2);
    CHECK_THAT(checked.err, ContainsSubstring("not a baseline"));
}

TEST_CASE("cli: passing checks are counted, and shown on request", "[cli]") {
    const Folder folder;
    make_report(folder);
    accept(folder);
    const auto quiet = folder.ordo(against_base);
    CHECK_THAT(quiet.out, ContainsSubstring("checks pass, 0 fail, 0 inconclusive"));
    CHECK(quiet.out.find("all inside") == std::string::npos);
    Words words = against_base;
    words.emplace_back("--verbose");
    CHECK_THAT(folder.ordo(words).out, ContainsSubstring("3 errors as accepted; found all inside"));
}

TEST_CASE("alarm: times are looked at on request only, up and down", "[cli]") {
    const Folder folder;
    make_report(folder);
    accept(folder);
    const Words timed{"check", "r.json", "--against", "base", "--times", "1.5"};
    CHECK(folder.ordo(timed).code == 0);
    const std::string good = folder.read("r.json");
    for (const double factor : {0.5, 2.0}) {
        folder.write("r.json", good);
        edit(folder, [&](Json& report) {
            for (auto& seconds : report["provenance"]["run_seconds"]) seconds = factor * seconds.get<double>();
        });
        CHECK(folder.ordo(against_base).code == 0);
        const auto checked = folder.ordo(timed);
        CHECK(checked.code == 1);
        CHECK_THAT(checked.out, ContainsSubstring("time_changed"));
    }
    folder.write("r.json", good);
    edit(folder, [](Json& report) { report["provenance"].erase("kernel_seconds"); });
    CHECK(folder.ordo(timed).code == 1);
    CHECK(folder.ordo(against_base).code == 0);
}

TEST_CASE("cli: options that make no sense are refused", "[cli]") {
    const Folder folder;
    make_report(folder);
    const std::vector<Words> refused{{"check"},
                                     {"check", "r.json", "--times", "1.5"},
                                     {"check", "r.json", "--against", "base", "--times", "1"},
                                     {"check", "r.json", "--against", "base", "--times", "0.5"},
                                     {"check", "r.json", "--against", "base", "--times", "nan"},
                                     {"check", "r.json", "--against", "base", "--times", "inf"},
                                     {"check", "r.json", "--against", "base", "--times", "fast"},
                                     {"check", "r.json", "--summary", "r.json/x.md"},
                                     {"check", "r.json", "--summary", "x", "--junit", "x"},
                                     {"check", "s.json"}};
    for (const auto& words : refused) {
        const auto outcome = folder.ordo(words);
        INFO(outcome.err);
        CHECK(outcome.code == 2);
        CHECK(outcome.err_lines() == 1);
        CHECK(outcome.out.empty());
    }
    CHECK(folder.names() == outside::Names{"r.json", "s.json"});
}

TEST_CASE("alarm: an empty --against is refused, not taken for none", "[cli]") {
    const Folder folder;
    make_report(folder);
    CHECK(folder.ordo({"check", "r.json", "--against", ""}).code == 2);
}

TEST_CASE("cli: the checks go to a JUnit file, which a bad input does not make", "[cli]") {
    const Folder folder;
    make_report(folder, {"expect.0.order=1"});
    CHECK(folder.ordo({"check", "r.json", "none.json", "--junit", "ci/gate.xml"}).code == 2);
    CHECK_FALSE(folder.has("ci"));
    CHECK(folder.ordo({"check", "r.json", "--junit", "ci/gate.xml"}).code == 1);
    CHECK_THAT(folder.read("ci/gate.xml"), ContainsSubstring("<testsuite name=\"sample\" tests=\"3\" failures=\"1\">"));
    CHECK(folder.ordo({"check", "r.json", "--junit", "r.json/gate.xml"}).code == 2);
}

TEST_CASE("alarm: an edited verdict does not pass the gate", "[cli]") {
    const Folder folder;
    make_report(folder, {"expect.0.order=1"});
    Json report = Json::parse(folder.read("r.json"));
    report["verdict"] = "pass";
    for (auto& check : report["checks"]) check["verdict"] = "pass";
    folder.write("r.json", report.dump());
    CHECK(folder.ordo({"check", "r.json"}).code == 1);
    CHECK(folder.ordo({"accept", "r.json", "--because", "x", "--into", "base"}).code == 2);
}

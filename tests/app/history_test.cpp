// ordo history, from outside.
#include "tests/app/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::make_report;
using outside::Words;
using samples::Json;

namespace {

/// Writes the report "r.json" as one of that revision and day, one error times `factor`.
void keep(const Folder& folder, const std::string& revision, int day, double factor) {
    auto report = Json::parse(folder.read("r.json"));
    report["provenance"]["revision"] = revision;
    report["provenance"]["time_utc"] = "2026-01-0" + std::to_string(day) + "T00:00:00Z";
    auto& error = report["runs"][1]["errors"]["displacement.rms"];
    error = error.get<double>() * factor;
    folder.write("old/" + revision + "/" + std::to_string(day) + ".json", report.dump());
}

}  // namespace

TEST_CASE("cli: history finds the revision at which an error stepped, among what is no report", "[cli]") {
    const Folder folder;
    make_report(folder);
    keep(folder, "aaa", 1, 1);
    keep(folder, "aaa", 2, 1);
    keep(folder, "bbb", 3, 1);
    keep(folder, "ccc", 4, 0.9);
    folder.write("old/s.json", folder.read("s.json"));
    folder.write("old/broken.json", "{");
    folder.write("old/notes.txt", "no JSON");
    const auto found = folder.ordo({"history", "old"});
    CHECK(found.code == 0);
    CHECK_THAT(found.out, ContainsSubstring("mpm, cells = 8, dt = 0.005: displacement.rms") &&
                              ContainsSubstring("bbb -> ccc") && ContainsSubstring("-10 %") &&
                              ContainsSubstring("4 reports of 1 studies at 3 revisions"));
    CHECK(found.err_lines() == 2);
    CHECK_THAT(found.err, ContainsSubstring("old/s.json") && ContainsSubstring("old/broken.json"));

    const auto json = Json::parse(folder.ordo({"history", "old", "--format", "json"}).out);
    CHECK(json["reports"] == 4);
    CHECK(json["steps"][0]["now"] == "ccc");
}

TEST_CASE("alarm: history of equal revisions has no step, and one that measured nothing is refused", "[cli]") {
    const Folder folder;
    make_report(folder);
    keep(folder, "aaa", 1, 1);
    keep(folder, "aaa", 2, 1.5);
    const auto quiet = folder.ordo({"history", "old"});
    CHECK(quiet.code == 0);
    CHECK_THAT(quiet.out, ContainsSubstring(": 0 steps"));
    std::filesystem::create_directory(folder.path() / "empty");
    const std::vector<Words> refused{{"history"},           {"history", "empty"},
                                     {"history", "none"},   {"history", "r.json"},
                                     {"history", "a", "b"}, {"history", "old", "--format", "jsn"}};
    for (const auto& words : refused) {
        const auto outcome = folder.ordo(words);
        INFO(outcome.err);
        CHECK(outcome.code == 2);
        CHECK(outcome.err_lines() == 1);
        CHECK(outcome.out.empty());
    }
}

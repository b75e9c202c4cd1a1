// ordo run with a cache, from outside: the same bytes, why a run was made, damaged files, several studies.
#include <algorithm>
#include <filesystem>

#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/reports/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::Outcome;
using outside::Words;
using samples::Json;

namespace {

/// Runs the command with a cache of its own beside the studies.
Outcome cached_ordo(const Folder& folder, const Words& words, const std::string& cache = "kept") {
    auto setting = folder.here();
    setting.environment.emplace_back("ORDO_CACHE", cache);
    return outside::run(outside::command(words), setting);
}

std::string without_provenance(const std::string& report) {
    Json json = Json::parse(report);
    json.erase("provenance");
    return json.dump();
}

Json provenance(const Folder& folder, const std::string& report) {
    return Json::parse(folder.read(report))["provenance"];
}

std::size_t kept(const Folder& folder) {
    const auto names = folder.names();
    return static_cast<std::size_t>(
        std::ranges::count_if(names, [](const std::string& name) { return name.starts_with("kept/"); }));
}

}  // namespace

TEST_CASE("cli: a repeated run gives the same bytes from the cache, and says so", "[cli]") {
    const Folder folder;
    Json study = samples::study();
    study["allow"] = {"diverged"};
    study["sweep"]["cells"] = {4, 8, 16, 4000};  // blows up at 4000 cells
    folder.write("s.json", study.dump());
    const auto fresh = cached_ordo(folder, {"run", "s.json", "-o", "a.json", "--jobs", "1"});
    CHECK_THAT(fresh.out, !ContainsSubstring("from the cache"));
    CHECK(kept(folder) == 4);
    const auto again = cached_ordo(folder, {"run", "s.json", "-o", "b.json", "--jobs", "4"});
    CHECK(again.code == fresh.code);
    CHECK_THAT(again.out, ContainsSubstring("runs: 0 made, 4 from the cache\n"));
    CHECK_THAT(again.err, ContainsSubstring(": ok (cached)"));
    CHECK(without_provenance(folder.read("a.json")) == without_provenance(folder.read("b.json")));
    CHECK(provenance(folder, "a.json")["cached"] == Json::array());
    CHECK(provenance(folder, "b.json")["cached"] == Json({0, 1, 2, 3}));
    CHECK(provenance(folder, "a.json")["run_seconds"] == provenance(folder, "b.json")["run_seconds"]);
    CHECK(provenance(folder, "b.json")["kernel_seconds"].is_null());
    // What is shown and gated is made from the report, as ever.
    CHECK(folder.ordo({"table", "a.json"}).out == folder.ordo({"table", "b.json"}).out);
    CHECK(folder.ordo({"check", "b.json"}).code == fresh.code);
}

TEST_CASE("cli: without the cache every run is made, and none is kept", "[cli]") {
    const Folder folder;
    folder.write("s.json", samples::study().dump());
    CHECK(cached_ordo(folder, {"run", "s.json", "-o", "a.json", "--no-cache"}).code == 0);
    CHECK(kept(folder) == 0);
    cached_ordo(folder, {"run", "s.json", "-o", "a.json"});
    CHECK(kept(folder) == 3);
    cached_ordo(folder, {"run", "s.json", "-o", "a.json", "--no-cache"});
    CHECK(provenance(folder, "a.json")["cached"] == Json::array());
    cached_ordo(folder, {"run", "s.json", "-o", "a.json"}, "off");
    CHECK(provenance(folder, "a.json")["cached"] == Json::array());
    CHECK_FALSE(folder.has("off"));
}

TEST_CASE("cli: --why-not-cached names what differs, one line a run", "[cli]") {
    const Folder folder;
    folder.write("s.json", samples::study().dump());
    const Words why{"run", "s.json", "-o", "a.json", "--why-not-cached"};
    const auto first = cached_ordo(folder, why);
    CHECK_THAT(first.err, ContainsSubstring("ordo: not cached: mpm on ") && ContainsSubstring("no such run is kept"));
    CHECK(cached_ordo(folder, why).err_lines() == 3);  // its progress
    Words changed = why;
    changed.insert(changed.end(), {"--set", "solvers.0.stress_update=usl"});
    const auto other = cached_ordo(folder, changed);
    CHECK(other.err_lines() == 6);
    CHECK_THAT(other.err,
               ContainsSubstring("/run/solver/values/stress_update was \"") && ContainsSubstring("is \"usl\""));
}

TEST_CASE("cli: a damaged entry is made again, and said with -v", "[cli]") {
    const Folder folder;
    folder.write("s.json", samples::study().dump());
    cached_ordo(folder, {"run", "s.json", "-o", "a.json"});
    const auto names = folder.names();
    const auto entry = *std::ranges::find_if(names, [](const std::string& name) { return name.starts_with("kept/"); });
    folder.write(entry, "{\"schema\": \"ordo-run-1\"");
    const auto ran = cached_ordo(folder, {"run", "s.json", "-o", "b.json", "-v"});
    CHECK(ran.code == 0);
    CHECK_THAT(ran.out, ContainsSubstring("runs: 1 made, 2 from the cache"));
    CHECK_THAT(ran.err, ContainsSubstring("ordo: cache: " + entry));
    CHECK(without_provenance(folder.read("a.json")) == without_provenance(folder.read("b.json")));
}

TEST_CASE("cli: equal runs of several studies in one call are made once, with and without the cache", "[cli]") {
    const Folder folder;
    Json study = samples::study();
    for (const char* name : {"a", "b"}) {
        study["study"] = name;
        folder.write(std::string(name) + ".json", study.dump());
    }
    const Words both{"run", "a.json", "b.json", "-o", "out/", "--no-cache"};
    const auto ran = cached_ordo(folder, both);
    CHECK_THAT(ran.out, ContainsSubstring("runs: 0 made, 3 equal to others\n"));
    CHECK(ran.err_lines() == 6);
    CHECK(provenance(folder, "out/b.json")["shared"] == Json({0, 1, 2}));
    CHECK(Json::parse(folder.read("out/a.json"))["runs"] == Json::parse(folder.read("out/b.json"))["runs"]);
}

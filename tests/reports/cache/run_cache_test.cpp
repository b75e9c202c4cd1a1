// Finished runs on disk: the same bits, damaged and foreign files, two writers, bounds, and why a run is not there.
#include "reports/cache/run_cache.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <thread>

#include "reports/cache/build.hpp"
#include "reports/cache/kept_run.hpp"
#include "studies/engine/description.hpp"
#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/studies/sample_study.hpp"

using namespace ordo;
using namespace ordo::reports;
using ordo::outside::Folder;
using studies::Run;

namespace {

const std::string build = R"({"flags":"-O3","sources":{"solvers":"12ab"}})";

std::string description(const std::string& place = "/study", const std::string& value = "\"sample\"") {
    return studies::description_of(studies::specs_of(tests::study_of(tests::with(place, value))).front());
}

/// Numbers that a careless format loses.
Run awkward() {
    Run run;
    run.errors = {{"displacement.rms", 0.1 + 0.2}, {"displacement.l2", std::nan("")}};
    run.drift = {{"mass", -0.0}, {"energy", -std::numeric_limits<double>::infinity()}};
    run.work = {{"steps", 1e300}, {"particle_steps", std::numeric_limits<double>::denorm_min()}};
    run.skipped = {{"quiet cells", 1.0 / 3}};
    run.status = studies::Status::diverged;
    run.reason = "particle 3 left the grid at \"t\" = 0.5";
    run.seconds = 1.0 / 7;
    return run;
}

bool same_bits(const std::vector<studies::RunFigure>& a, const std::vector<studies::RunFigure>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const bool both_nan = std::isnan(a[i].value) && std::isnan(b[i].value);
        if (a[i].name != b[i].name) return false;
        if (!both_nan && std::memcmp(&a[i].value, &b[i].value, sizeof(double)) != 0) return false;
    }
    return true;
}

std::filesystem::path only_file(const std::filesystem::path& folder) {
    return std::filesystem::directory_iterator(folder)->path();
}

}  // namespace

TEST_CASE("a kept run is found again with the same bits, by another cache of the folder", "[unit]") {
    const Folder folder;
    RunCache(folder.path(), build).keep(description(), awkward());
    RunCache cache(folder.path(), build);
    const auto found = cache.find(description());
    REQUIRE(found);
    const Run made = awkward();
    CHECK(same_bits(found->errors, made.errors));
    CHECK(same_bits(found->drift, made.drift));
    CHECK(same_bits(found->work, made.work));
    CHECK(same_bits(found->skipped, made.skipped));
    CHECK(found->status == made.status);
    CHECK(found->reason == made.reason);
    CHECK(found->seconds == made.seconds);
    CHECK(found->origin == studies::Origin::cached);
    CHECK(cache.missed().empty());
}

TEST_CASE("a run of another scene, solver, resolution, end, measure or build is not found", "[alarm]") {
    const Folder folder;
    RunCache(folder.path(), build).keep(description(), awkward());
    RunCache cache(folder.path(), build);
    const std::vector<std::pair<std::string, std::string>> others{
        {"/scene/E", "50.000000000000007"},     {"/solvers/0/stress_update", "\"usl\""}, {"/sweep/cells", "[5]"},
        {"/sweep/dt", "0.0099999999999999985"}, {"/measure/at", "0.20000000000000004"},  {"/measure/norms", "[\"l2\"]"},
        {"/measure/fields", "[\"velocity\"]"},  {"/measure/over", "\"maximum\""}};
    for (const auto& [place, value] : others) {
        INFO(place);
        CHECK_FALSE(cache.find(description(place, value)));
    }
    CHECK(cache.missed().size() == others.size());
    CHECK_FALSE(RunCache(folder.path(), R"({"flags":"-O2"})").find(description()));
    // Names and time limits change no figure.
    CHECK(cache.find(description("/study", "\"other\"")));
    CHECK(cache.find(description("/timeout_s", "5")));
}

TEST_CASE("damaged and foreign files are ignored, said, and written over", "[alarm]") {
    const Folder folder;
    RunCache(folder.path(), build).keep(description(), awkward());
    const std::string name = only_file(folder.path()).filename();
    const std::string good = folder.read(name);
    RunCache(folder.path(), build).keep(description("/scene/E", "7"), awkward());
    std::string foreign = good;
    foreign.replace(foreign.find("-O3"), 3, "-O9");
    for (const std::string& bad :
         {std::string(), good.substr(0, good.size() / 2), std::string("[]"), std::string(1000, '\0'), foreign}) {
        folder.write(name, bad);
        RunCache cache(folder.path(), build);
        CHECK_FALSE(cache.find(description()));
        const auto complaints = cache.complaints();
        REQUIRE(complaints.size() == 1);
        CHECK_THAT(complaints.front(), ContainsSubstring(name) && ContainsSubstring("made again"));
        cache.keep(description(), awkward());
        CHECK(folder.read(name) == good);
    }
}

TEST_CASE("a folder that cannot be written is no fault of the study", "[alarm]") {
    const Folder folder;
    folder.write("file", "");
    RunCache cache((folder.path() / "file").string(), build);
    cache.keep(description(), awkward());
    cache.keep(description("/scene/E", "7"), awkward());
    CHECK(cache.complaints().size() == 1);
    CHECK(cache.find(description())->origin == studies::Origin::shared);  // still known here
}

TEST_CASE("two programs may write and read the same entries at once", "[alarm]") {
    const Folder folder;
    const auto texts = {description(), description("/scene/E", "7")};
    const auto writes_and_reads = [&] {
        for (int k = 0; k < 50; ++k) {
            RunCache cache(folder.path(), build);
            for (const auto& text : texts) {
                static_cast<void>(cache.find(text));
                CHECK(cache.complaints().empty());
                cache.keep(text, awkward());
            }
        }
    };
    const auto child = fork();
    if (child == 0) {
        for (int k = 0; k < 50; ++k) {
            for (const auto& text : texts) RunCache(folder.path(), build).keep(text, awkward());
        }
        _exit(0);
    }
    writes_and_reads();
    waitpid(child, nullptr, 0);
    CHECK(folder.names().size() == 2);
}

TEST_CASE("why a run is not there: the members in which the nearest entry differs", "[unit]") {
    const Folder folder;
    RunCache(folder.path(), build).keep(description(), awkward());
    RunCache(folder.path(), build).keep(description("/sweep/cells", "[8]"), awkward());
    const auto why = [&](const std::string& other_build, const std::string& text) {
        RunCache cache(folder.path(), other_build);
        cache.read_entries();
        return cache.why_not(text);
    };
    CHECK_THAT(why(build, description("/scene/rho", "7")),
               ContainsSubstring("mpm on bar_vibration at cells = 4.0, dt = 0.01") &&
                   ContainsSubstring("/run/scene/values/rho was 1, is 7"));
    CHECK_THAT(why(R"({"flags":"-O3","sources":{"solvers":"34cd"}})", description()),
               ContainsSubstring("/build/sources/solvers was \"12ab\", is \"34cd\""));
    CHECK_THAT(why(build, description("/sweep/cells", "[5]")), ContainsSubstring("no such run is kept"));
}

TEST_CASE("the oldest entries go where there are more than may be kept, and nothing else", "[unit]") {
    const Folder folder;
    folder.write("precious.json", "{}");
    RunCache cache(folder.path(), build);
    std::vector<std::string> texts;
    for (int k = 0; k < 8; ++k) {
        texts.push_back(description("/scene/E", std::to_string(100 + k)));
        cache.keep(texts.back(), awkward());
        for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
            if (file.path().filename() != "precious.json")
                std::filesystem::last_write_time(file, file.last_write_time() - std::chrono::seconds(10));
        }
    }
    cache.trim(8);
    CHECK(folder.names().size() == 9);
    cache.trim(7);
    CHECK(folder.names().size() == 7);  // 7 - 7/4 entries and the file of somebody else
    RunCache after(folder.path(), build);
    CHECK_FALSE(after.find(texts[0]));
    CHECK_FALSE(after.find(texts[1]));
    CHECK(after.find(texts[2]));
    CHECK(after.find(texts[7]));
}

TEST_CASE("what figures follow from names the sources of every room that computes them", "[unit]") {
    const auto facts = studies::Json::parse(build_of_figures());
    for (const char* room : {"build", "core", "solvers", "oracles", "engine", "scenes", "amplification"})
        CHECK(facts.at("sources").at(room).get<std::string>().size() == 16);
    CHECK(facts.at("sources").at("core") != facts.at("sources").at("solvers"));
    for (const char* fact : {"compiler", "flags", "c_library", "processor"})
        CHECK_FALSE(facts.at(fact).get<std::string>().empty());
}

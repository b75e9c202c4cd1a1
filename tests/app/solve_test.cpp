// ordo solve, from outside.
#include <algorithm>
#include <csignal>
#include <sstream>

#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/reports/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::Names;
using outside::Words;
using samples::Json;

namespace {

/// A short run of the bar, with further words behind it.
Words solve(const Words& more = {}) {
    Words words{"solve", "bar_vibration",      "--solver", "mpm",
                "--set", "resolution.cells=8", "--set",    "resolution.dt=1e-3"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

}  // namespace

TEST_CASE("cli: a run's particles as columns", "[cli]") {
    const Folder folder;
    const auto outcome = folder.ordo(solve({"--t", "0.1"}));
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
    std::istringstream lines(outcome.out);
    std::string line;
    std::getline(lines, line);
    CHECK(line == "X,x,volume,displacement,velocity,stress,strain");
    int rows = 0;
    for (; std::getline(lines, line); ++rows) CHECK(std::count(line.begin(), line.end(), ',') == 6);
    CHECK(rows == 8);
    CHECK(folder.names().empty());
}

TEST_CASE("cli: a run's particles in a file, and as JSON", "[cli]") {
    const Folder folder;
    const auto outcome = folder.ordo(solve({"--t", "0.1", "-o", "out/run.json", "--format", "json"}));
    CHECK(outcome.code == 0);
    CHECK(outcome.out.empty());
    CHECK(folder.names() == Names{"out", "out/run.json"});
    const auto rows = Json::parse(folder.read("out/run.json"));
    CHECK(rows.size() == 8);
    double volume = 0;
    for (const auto& row : rows) {
        CHECK(row["x"].get<double>() - row["X"].get<double>() ==
              Approx(row["displacement"].get<double>()).margin(1e-14));
        volume += row["volume"].get<double>();
    }
    CHECK(volume == Approx(25).epsilon(0.01));  // the strain is below 1 %
}

TEST_CASE("cli: what cannot be solved is refused", "[cli]") {
    const std::vector<std::pair<Words, std::string>> wrong{
        {{}, "--t"},
        {{"--t", "0"}, "> 0"},
        {{"--t", "-1"}, "> 0"},
        {{"--t", "nan"}, "> 0"},
        {{"--t", "1e999"}, "--t"},
        {{"--t", "1e300"}, "steps"},
        {{"--t", "1", "--set", "scen.E=5"}, "nearest: 'scene'"},
        {{"--t", "1", "--set", "E=5"}, "scene., solver. or resolution."},
        {{"--t", "1", "--set", "scene.E"}, "path=value"},
        {{"--t", "1", "--set", "scene.Emodul=5"}, "'Emodul'"},
        {{"--t", "1", "--set", "solver.stress_update=mus"}, "nearest: 'musl'"},
        {{"--t", "1", "--set", "resolution.cell=5"}, "nearest: 'cells'"},
        {{"--t", "1", "--set", "resolution.ppc=4,8"}, "must be a number"},
        {{"--t", "1", "--set", "resolution.cells=4"}, "set twice"},
        {{"--t", "1", "--set", "resolution.courant=0.5"}, "exactly one of"},
        {{"--t", "1", "--format", "jsn"}, "nearest: 'json'"},
        {{"--t", "1", "--solver", "rrm"}, "--solver"},
    };
    const Folder folder;
    for (const auto& [words, part] : wrong) {
        const auto outcome = folder.ordo(solve(words));
        INFO(outcome.err);
        CHECK(outcome.code == 2);
        CHECK(outcome.err_lines() == 1);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, ContainsSubstring(part));
    }
    CHECK_THAT(folder.ordo({"solve", "bar", "--solver", "mpm", "--t", "1"}).err,
               ContainsSubstring("there is no scene 'bar'"));
    CHECK_THAT(folder.ordo({"solve", "bar_vibration", "--solver", "mmm", "--t", "1"}).err, ContainsSubstring("'mmm'"));
    CHECK_THAT(folder.ordo({"solve", "bar_vibration", "--t", "1"}).err, ContainsSubstring("--solver NAME"));
    CHECK(folder.names().empty());
}

TEST_CASE("cli: a run that blows up gives 1 and no columns", "[cli]") {
    const Folder folder;
    const auto outcome = folder.ordo({"solve", "bar_vibration", "--solver", "mpm", "--t", "5000", "--set",
                                      "resolution.cells=16", "--set", "resolution.dt=5", "-o", "run.csv"});
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, ContainsSubstring("diverged"));
    CHECK(outcome.err_lines() == 1);
    CHECK(folder.names().empty());
}

TEST_CASE("cli: a signal ends a run with nothing written", "[cli]") {
    const Folder folder;
    const int signal = GENERATE(SIGINT, SIGTERM);
    outside::Process process(
        outside::command({"solve", "bar_vibration", "--solver", "mpm", "--t", "5", "--set", "resolution.cells=4000",
                          "--set", "resolution.dt=1e-5", "-o", "out/run.csv"}),
        folder.here());
    // The folder is made right before the run begins, which takes a minute.
    REQUIRE(process.until([&] { return folder.has("out"); }));
    process.send(signal);
    CHECK(process.wait().code == 130);
    CHECK(folder.names() == Names{"out"});
}

// ordo run, from outside.
#include <algorithm>
#include <csignal>

#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/reports/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::Names;
using samples::Json;

namespace {

/// The sample with some members replaced: {"/sweep/dt", 5}.
std::string study(const std::vector<std::pair<std::string, Json>>& edits = {}) {
    Json json = samples::study();
    for (const auto& [place, value] : edits) json[Json::json_pointer(place)] = value;
    return json.dump();
}

/// A step far beyond the stability limit, for as long as it takes to blow up.
const std::vector<std::pair<std::string, Json>> unstable{{"/sweep/dt", 5}, {"/measure/at", 5000}};

/// One run that ends at once and one of a minute or more, so that a signal meets a study under way.
std::string long_study() { return study({{"/sweep/cells", {4, 4000}}, {"/sweep/dt", 1e-5}, {"/measure/at", 5}}); }

Json without_provenance(const std::string& report) {
    Json json = Json::parse(report);
    json.erase("provenance");
    return json;
}

}  // namespace

TEST_CASE("cli: a good study gives its report, its table, and a line a run", "[cli]") {
    const Folder folder;
    folder.write("s.json", study());
    const auto ran = folder.ordo({"run", "s.json", "-o", "r.json"});
    CHECK(ran.code == 0);
    CHECK(folder.names() == Names{"r.json", "s.json"});
    CHECK(Json::parse(folder.read("r.json"))["verdict"] == "pass");
    CHECK_THAT(ran.out, ContainsSubstring("cells") && ContainsSubstring("verdict: pass"));
    CHECK_THAT(ran.out, ContainsSubstring("report: r.json"));
    CHECK(ran.err_lines() == 3);
    for (const char* line : {"[1/3] mpm cells=", "[2/3] mpm cells=", "[3/3] mpm cells=", ": ok displacement.rms "}) {
        CHECK_THAT(ran.err, ContainsSubstring(line));
    }
}

TEST_CASE("cli: without -o the report goes to a folder by the study's name", "[cli]") {
    const Folder folder;
    folder.write("s.json", study({{"/study", "paper/table 1"}}));
    CHECK(folder.ordo({"run", "s.json"}).code == 0);
    CHECK(folder.has("ordo-reports/paper/table_1.json"));
}

TEST_CASE("cli: any number of jobs gives the same report but for its provenance", "[cli]") {
    const Folder folder;
    folder.write("s.json", study({{"/sweep/cells", {4, 8, 16, 32}}, {"/sweep/ppc", {1, 2, 3}}}));
    for (const char* jobs : {"1", "4"}) {
        CHECK(folder.ordo({"run", "s.json", "--jobs", jobs, "-o", std::string(jobs) + ".json"}).code == 0);
    }
    const auto alone = without_provenance(folder.read("1.json"));
    CHECK(alone["runs"].size() == 12);
    CHECK(alone.dump() == without_provenance(folder.read("4.json")).dump());
}

TEST_CASE("cli: --set changes the study, and the report holds the changed one", "[cli]") {
    const Folder folder;
    folder.write("s.json", study());
    const auto ran = folder.ordo({"run", "s.json", "-o", "r.json", "--set", "sweep.cells=4,8,16,32", "--set",
                                  "scene.E=50", "--set", "solvers.0.stress_update=usl"});
    CHECK(ran.code == 0);
    const auto report = Json::parse(folder.read("r.json"));
    CHECK(report["runs"].size() == 4);
    CHECK(report["study"]["scene"]["E"] == 50);
    CHECK(report["study"]["solvers"][0]["stress_update"] == "usl");
}

TEST_CASE("cli: a study whose gate fails gives 1, and its report all the same", "[cli]") {
    const Folder folder;
    folder.write("s.json", study());
    const auto order = GENERATE(as<std::string>{}, "1", "3");
    const auto ran = folder.ordo({"run", "s.json", "-o", "r.json", "--set", "expect.0.order=" + order});
    CHECK(ran.code == 1);
    CHECK_THAT(ran.out, ContainsSubstring("verdict: fail"));
    CHECK(Json::parse(folder.read("r.json"))["verdict"] == "fail");
    CHECK(folder.ordo({"check", "r.json"}).code == 1);
}

TEST_CASE("cli: a study that expects nothing runs, but its gate is inconclusive", "[cli]") {
    const Folder folder;
    folder.write("s.json", study({{"/expect", Json::array()}}));
    CHECK(folder.ordo({"run", "s.json", "-o", "r.json"}).code == 0);
    const auto checked = folder.ordo({"check", "r.json"});
    CHECK(checked.code == 1);
    CHECK_THAT(checked.out, ContainsSubstring("inconclusive"));
}

TEST_CASE("cli: a run that blows up has a row with the reason, and fails unless it is allowed to", "[cli]") {
    const Folder folder;
    folder.write("s.json", study(unstable));
    const auto ran = folder.ordo({"run", "s.json", "-o", "r.json"});
    CHECK(ran.code == 1);
    CHECK_THAT(ran.out, ContainsSubstring("diverged"));
    CHECK_THAT(ran.err, ContainsSubstring("diverged ("));
    const auto report = Json::parse(folder.read("r.json"));
    CHECK(report["runs"][2]["status"] == "diverged");
    CHECK_FALSE(report["runs"][2]["reason"].get<std::string>().empty());

    auto allowed = unstable;
    allowed.insert(allowed.end(), {{"/allow", {"diverged"}}, {"/expect", Json::array()}});
    folder.write("s.json", study(allowed));
    CHECK(folder.ordo({"run", "s.json", "-o", "r.json"}).code == 0);
    CHECK(Json::parse(folder.read("r.json"))["runs"][2]["status"] == "diverged");
}

TEST_CASE("cli: a run that passes its time limit gives 3, and the report says so", "[cli]") {
    const Folder folder;
    folder.write("s.json", study({{"/timeout_s", 1e-9}}));
    const auto ran = folder.ordo({"run", "s.json", "-o", "r.json"});
    CHECK(ran.code == 3);
    CHECK(Json::parse(folder.read("r.json"))["runs"][0]["status"] == "timed_out");
    CHECK(folder.ordo({"check", "r.json"}).code == 1);
}

TEST_CASE("cli: several studies go to a folder, each to its own report", "[cli]") {
    const Folder folder;
    folder.write("a.json", study({{"/study", "a"}}));
    folder.write("b.json", study({{"/study", "b"}, {"/expect/0/order", 1}}));
    CHECK(folder.ordo({"run", "a.json", "b.json", "-o", "out/"}).code == 1);  // that of the worst
    CHECK(folder.ordo({"run", "b.json", "a.json", "-o", "out/"}).code == 1);
    CHECK(folder.names() == Names{"a.json", "b.json", "out", "out/a.json", "out/b.json"});
}

TEST_CASE("cli: two studies with one output are refused before anything runs", "[cli]") {
    const Folder folder;
    folder.write("a.json", study({{"/study", "a"}}));
    folder.write("b.json", study({{"/study", "b"}}));
    const Names before = folder.names();
    for (const outside::Words& words :
         {outside::Words{"run", "a.json", "b.json", "-o", "r.json"},
          outside::Words{"run", "a.json", "a.json", "-o", "out/"}, outside::Words{"run", "a.json", "a.json"}}) {
        const auto ran = folder.ordo(words);
        CHECK(ran.code == 2);
        CHECK(ran.err_lines() == 1);
        CHECK(folder.names() == before);
    }
}

TEST_CASE("cli: a report does not overwrite its study", "[cli]") {
    const Folder folder;
    folder.write("s.json", study());
    const auto ran = folder.ordo({"run", "s.json", "-o", "./s.json"});
    CHECK(ran.code == 2);
    CHECK(folder.read("s.json") == study());
}

TEST_CASE("cli: a signal ends a study at once, with nothing written", "[cli]") {
    const Folder folder;
    folder.write("s.json", long_study());
    const int signal = GENERATE(SIGINT, SIGTERM);
    outside::Process process(outside::command({"run", "s.json", "-o", "out/r.json", "--jobs", "2"}), folder.here());
    REQUIRE(process.until([&] { return process.err().find("[1/2]") != std::string::npos; }));
    process.send(signal);
    const auto ended = process.wait();
    CHECK(ended.code == 130);
    CHECK(ended.out.empty());
    CHECK_THAT(ended.err, ContainsSubstring("interrupted"));
    CHECK(folder.names() == Names{"out", "s.json"});
}

TEST_CASE("cli: a study's name is a name only, in run, table, check, accept and plot", "[cli]") {
    const Folder folder;
    const auto name =
        GENERATE(as<std::string>{}, "../../escaped", "$(touch escaped)", "`touch escaped`",
                 "a'; system('touch escaped'); '", "\"; touch escaped; \"", "x\ny\x1b[31mz", "-o escaped");
    folder.write("work/s.json", study({{"/study", name}, {"/about", name}}));
    const outside::Setting inside{folder.path() / "work"};
    const auto fine = [&](const outside::Words& words) {
        const auto outcome = outside::run(outside::command(words), inside);
        INFO(words.front() << ": " << outcome.err);
        CHECK(outcome.code == 0);
        CHECK((outcome.out + outcome.err).find('\x1b') == std::string::npos);
    };
    fine({"run", "s.json"});
    fine({"run", "s.json", "-o", "r.json"});
    fine({"table", "r.json", "--format", "latex"});
    fine({"check", "r.json", "--junit", "gate.xml"});
    fine({"accept", "r.json", "--because", name, "--into", "base"});
    fine({"check", "r.json", "--against", "base"});
    fine({"plot", "r.json", "-o", "figures"});
    for (const auto& path : folder.names()) {
        INFO(path);
        CHECK((path == "work" || path.rfind("work/", 0) == 0));
        CHECK(path.substr(path.rfind('/') + 1) != "escaped");
    }
    CHECK_FALSE(std::filesystem::exists(folder.path().parent_path() / "escaped"));
}

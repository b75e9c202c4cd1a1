// Bad input, from outside: exit code 2, one line that names the fault and the nearest valid choice, nothing made.
#include <sys/stat.h>

#include <map>

#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/reports/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::Names;
using outside::Outcome;
using outside::Words;

namespace {

/// Refuses, says so on one line that holds all of `parts`, and leaves the folder as it was.
void check_refused(const Folder& folder, const Words& words, const Names& parts) {
    const Names before = folder.names();
    const Outcome outcome = folder.ordo(words);
    INFO("said: " << outcome.err.substr(0, 300));
    CHECK(outcome.code == 2);
    CHECK(outcome.err_lines() == 1);
    CHECK(outcome.out.empty());
    for (const auto& part : parts) CHECK_THAT(outcome.err, ContainsSubstring(part));
    CHECK(folder.names() == before);
}

/// The sample study with `from`, which it has once, replaced by `to`.
std::string changed(const std::string& from, const std::string& to) {
    std::string text = samples::study().dump();
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    REQUIRE(text.find(from, at + 1) == std::string::npos);
    return text.replace(at, from.size(), to);
}

struct Fault {
    std::string from, to;
    Names parts;  ///< of the message
};

void check_faults(const std::vector<Fault>& faults) {
    const Folder folder;
    for (const auto& [from, to, parts] : faults) {
        INFO(from << " -> " << to);
        folder.write("s.json", changed(from, to));
        check_refused(folder, {"run", "s.json", "-o", "out/r.json"}, parts);
    }
}

}  // namespace

TEST_CASE("cli: what a study may not say is refused with its place", "[cli]") {
    check_faults({
        {R"("about":)", R"("abuot":)", {"s.json", "abuot", "nearest: 'about'"}},
        {R"("about":)", R"("two\nlines":)", {"s.json", "two lines"}},
        {R"("sweep":{)", R"("sweep":{"cell":4,)", {"/sweep/cell", "nearest: 'cells'"}},
        {R"("study":"sample")", R"("study":3)", {"/study", "must be a string"}},
        {R"("study":"sample")", R"("study":"")", {"/study", "empty"}},
        {R"("cells":[4,8,16])", R"("cells":"4")", {"/sweep/cells", "must be a number"}},
        {R"("cells":[4,8,16])", R"("cells":[4,-8])", {"/sweep/cells/1", "-8", "[1, 1"}},
        {R"("cells":[4,8,16])", R"("cells":[4,8.5])", {"/sweep/cells/1", "8.5", "whole number"}},
        {R"("cells":[4,8,16])", R"("cells":[])", {"/sweep/cells", "empty list"}},
        {R"("cells":[4,8,16])", R"("cells":[4,8,4])", {"/sweep/cells/2", "repeated"}},
        {R"("dt":0.005)", R"("dt":-0.005)", {"/sweep/dt", "-0.005", "> 0"}},
        {R"("dt":0.005)", R"("dt":0)", {"/sweep/dt", "> 0"}},
        {R"("dt":0.005)", R"("dt":1e-300)", {"steps"}},
        {R"("dt":0.005,)", "", {"exactly one of 'dt' and 'courant'"}},
        {R"("at":0.1)", R"("at":-1)", {"/measure/at", "> 0"}},
        {R"("displacement")", R"("displacment")", {"/measure/fields", "nearest: 'displacement'"}},
        {R"("order":2)", R"("ordre":2)", {"/expect/0", "nearest: 'order'"}},
        {R"("within":0.2)", R"("within":0)", {"/expect/0/within", "> 0"}},
        {R"("within":0.2)", R"("within":0.2,"where":"cels < 9")", {"/expect/0/where", "nearest: 'cells'"}},
        {R"("within":0.2)", R"("within":0.2,"where":"cells < many")", {"/expect/0/where", "many"}},
        {R"("within":0.2)", R"("within":0.2,"of":"displacement.rsm")", {"/expect/0/of", "nearest: 'displacement.rms'"}},
        {R"("sweep":{)", R"("allow":"failed","sweep":{)", {"/allow", "diverged"}},
        {R"("sweep":{)", R"("timeout_s":0,"sweep":{)", {"/timeout_s", "> 0"}},
        {R"("sweep":{)",
         R"("published":{"file":"none.json","compare":"digits"},"sweep":{)",
         {"none.json", "no such file"}},
    });
}

TEST_CASE("cli: a word that does not exist is refused with the nearest", "[cli]") {
    check_faults({
        {R"("bar_vibration")", R"("bar_vibrations")", {"/scene/name", "nearest: 'bar_vibration'"}},
        {R"("bar_vibration")", R"("bar_vibration","rhoo":1)", {"/scene", "'rhoo'", "nearest: 'rho'"}},
        {R"("bar_vibration")", R"("bar_vibration","E":-1)", {"/scene", "'E' is -1", "> 0"}},
        {R"("bar_vibration")", R"("bar_vibration","E":"stiff")", {"/scene", "'E'", "a number"}},
        {R"("bar_vibration")", R"("bar_vibration","ends":"fixed_fre")", {"/scene", "nearest: 'fixed_free'"}},
        {R"("mpm")", R"("mpmm")", {"/solvers/0/name", "nearest: 'mpm'"}},
        {R"("mpm")", R"("mpm","stress_updat":"usl")", {"/solvers/0", "nearest: 'stress_update'"}},
        {R"("mpm")", R"("mpm","stress_update":"mus")", {"/solvers/0", "nearest: 'musl'"}},
        {R"("mpm")", R"("mpm","stress_update":[])", {"/solvers/0/stress_update", "empty list"}},
        {R"("space")", R"("spce")", {"/sweep/path", "nearest: 'space'"}},
    });
}

TEST_CASE("cli: what is not JSON, or no number, is refused", "[cli]") {
    check_faults({
        {R"("dt":0.005)", R"("dt":NaN)", {"s.json", "not valid JSON"}},
        {R"("dt":0.005)", R"("dt":Infinity)", {"s.json", "not valid JSON"}},
        {R"("dt":0.005)", R"("dt":1e999)", {"s.json", "not valid JSON"}},
        {R"("dt":0.005)", R"("dt":0.005,"dt":0.01)", {"s.json", "'dt' stands twice"}},
        {R"("dt":0.005)", R"("dt":0.005,)", {"s.json", "not valid JSON"}},
        {R"("study":"sample")", "\"study\":\"sam\xff\"", {"s.json", "not valid JSON"}},
        {R"("study":"sample")", "\"study\":\"sam\nple\"", {"s.json", "not valid JSON"}},
        {samples::study().dump(), "", {"s.json", "not valid JSON"}},
        {samples::study().dump(), "[]", {"s.json", "must be an object"}},
        {samples::study().dump(), "3", {"s.json", "must be an object"}},
    });
}

TEST_CASE("cli: a nest 200,000 deep is refused at once", "[cli]") {
    const Folder folder;
    const auto begin = GENERATE(as<std::string>{}, "[", "{\"a\":");
    std::string text;
    for (int k = 0; k < 200'000; ++k) text += begin;
    folder.write("s.json", text);
    check_refused(folder, {"run", "s.json", "-o", "r.json"}, {"s.json", "64 levels"});
    check_refused(folder, {"check", "s.json"}, {"s.json", "64 levels"});
}

TEST_CASE("cli: what is no file is refused as study and as report", "[cli]") {
    const Folder folder;
    folder.write("folder/empty.json", "");
    const auto command = GENERATE(as<std::string>{}, "run", "check", "table", "plot", "accept");
    Words words{command, "none.json"};
    if (command == "accept") words.insert(words.end(), {"--because", "x"});
    check_refused(folder, words, {"none.json", "no such file"});
    words[1] = "folder";
    check_refused(folder, words, {"folder", "not a file"});
    words[1] = "/dev/zero";
    check_refused(folder, words, {"/dev/zero", "not a file"});
    words[1] = "folder/empty.json";
    check_refused(folder, words, {"folder/empty.json", "not valid JSON"});
    words.erase(words.begin() + 1);
    check_refused(folder, words, {"usage: ordo " + command});
}

TEST_CASE("cli: an output that cannot be written is refused before anything runs", "[cli]") {
    const Folder folder;
    folder.write("s.json", samples::study().dump());
    folder.write("file", "kept");
    folder.write("folder/inside", "kept");
    REQUIRE(mkfifo((folder.path() / "pipe").c_str(), 0600) ==
            0);  // stands for a device: a file over it would replace it
    const auto out = GENERATE(as<std::string>{}, "file/r.json", "file/deep/r.json", "folder", "/proc/r.json",
                              "/proc/none/r.json", "pipe", "");
    check_refused(folder, {"run", "s.json", "-o", out}, {});
    check_refused(folder,
                  {"solve", "bar_vibration", "--solver", "mpm", "--t", "0.1", "--set", "resolution.cells=4", "--set",
                   "resolution.dt=0.01", "-o", out},
                  {});
    CHECK(folder.read("file") == "kept");
}

TEST_CASE("cli: words that mean nothing are refused", "[cli]") {
    const Folder folder;
    folder.write("s.json", samples::study().dump());
    check_refused(folder, {}, {"names no command", "ordo --help"});
    check_refused(folder, {""}, {"no command"});
    check_refused(folder, {"runn"}, {"'runn'", "nearest: 'run'"});
    check_refused(folder, {"--verbose"}, {"--verbose"});
    check_refused(folder, {"run", "s.json", "--job", "2"}, {"'--job'", "nearest: '--jobs'"});
    check_refused(folder, {"run", "s.json", "--ou=r.json"}, {"--ou", "nearest: '--out'"});
    check_refused(folder, {"run", "s.json", "-q"}, {"-q"});
    check_refused(folder, {"run", "s.json", "--jobs"}, {"--jobs"});
    check_refused(folder, {"run", "s.json", "--jobs", "two"}, {"--jobs", "two"});
    check_refused(folder, {"run", "s.json", "--jobs", "0"}, {"--jobs", "[1, 1024]"});
    check_refused(folder, {"run", "s.json", "--jobs", "-1"}, {"--jobs"});
    check_refused(folder, {"run", "s.json", "-o", "a.json", "-o", "b.json"}, {"--out"});
    check_refused(folder, {"completion", "fish"}, {"too many words"});
    check_refused(folder, {"list", "scenes", "bar_vibration", "more"}, {"too many words"});
    check_refused(folder, {"list", "scnes"}, {"'scnes'", "nearest: 'scenes'"});
    check_refused(folder, {"list", "solvers", "mppm"}, {"'mppm'", "nearest: 'mpm'"});
    check_refused(folder, {"list", "norms", "rms"}, {"rms"});
    check_refused(folder, {"list", "studies", "nowhere"}, {"nowhere"});
}

TEST_CASE("cli: a setting that means nothing is refused", "[cli]") {
    const Folder folder;
    folder.write("s.json", samples::study().dump());
    const std::map<std::string, Names> settings{
        {"", {"--set"}},
        {"sweep.dt", {"path=value"}},
        {"=3", {"path=value"}},
        {"sweep.cells=", {"/sweep/cells"}},
        {"sweep.cells=four", {"/sweep/cells", "four"}},
        {"sweep.cels=4", {"/sweep/cels", "nearest: 'cells'"}},
        {"swep.cells=4", {"swep"}},
        {"timeout=4", {"timeout", "nearest: 'timeout_s'"}},
        {"solvers.7.mass=lumped", {"solvers.7"}},
        {"sweep.cells.0=4", {"sweep.cells.0"}},
        {"scene.E=nan", {"/scene", "'E'"}},
        {"scene.E=1e999", {"/scene", "'E'"}},
    };
    for (const auto& [setting, parts] : settings) {
        INFO(setting);
        check_refused(folder, {"run", "s.json", "-o", "r.json", "--set", setting}, parts);
    }
}

// Help, version and exit codes, from outside: what help shows works.
#include <algorithm>
#include <sstream>

#include "tests/app/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::link_studies;
using outside::Words;

namespace {

const Words sub_commands{"list", "run",    "check", "accept", "history",   "table",
                         "plot", "oracle", "solve", "basis",  "completion"};

/// The lines behind "examples:", each cut at its blanks.
std::vector<Words> examples_in(const std::string& help) {
    std::istringstream lines(help.substr(help.find("examples:\n") + 10));
    std::vector<Words> examples;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        examples.emplace_back();
        for (std::string word; words >> word;) examples.back().push_back(word);
    }
    return examples;
}

}  // namespace

TEST_CASE("cli: help names every sub-command, and each has its own with examples", "[cli]") {
    const Folder folder;
    const auto overview = folder.ordo({"--help"});
    CHECK(overview.code == 0);
    for (const auto& name : sub_commands) {
        CHECK_THAT(overview.out, ContainsSubstring("\n  " + name + " "));
        for (const char* option : {"--help", "-h"}) {
            const auto help = folder.ordo({name, option});
            INFO(name);
            CHECK(help.code == 0);
            CHECK(help.err.empty());
            CHECK_THAT(help.out, ContainsSubstring("usage: ordo " + name));
            CHECK_FALSE(examples_in(help.out).empty());
        }
    }
    CHECK(folder.names().empty());
}

TEST_CASE("cli: every example in the help works from the source folder", "[cli]") {
    for (const char* name : {"", "list", "run", "oracle", "solve", "basis"}) {
        const Folder folder;
        link_studies(folder);
        const std::string command(name);
        const auto help = folder.ordo(command.empty() ? Words{"--help"} : Words{command, "--help"});
        for (Words example : examples_in(help.out)) {
            REQUIRE(example.at(0) == "ordo");
            const auto outcome = folder.ordo(Words(example.begin() + 1, example.end()));
            INFO(command << " " << example.back() << ": " << outcome.err);
            CHECK(outcome.code == 0);
            CHECK_FALSE(outcome.out.empty());
        }
    }
}

TEST_CASE("cli: the version says what was built", "[cli]") {
    const auto version = Folder().ordo({"--version"});
    CHECK(version.code == 0);
    CHECK(version.out.rfind("ordo ", 0) == 0);
    CHECK(std::count(version.out.begin(), version.out.end(), '\n') == 1);
}

TEST_CASE("cli: a full standard output gives 4", "[cli]") {
    const Folder folder;
    const auto outcome =
        outside::run(outside::command({"list", "schema"}), {.folder = folder.path(), .out = "/dev/full"});
    CHECK(outcome.code == 4);
    CHECK(outcome.err_lines() == 1);
}

// Who may include whom, and which library stands in which room.
#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "tests/architecture/house.hpp"
#include "tests/catch.hpp"

using namespace ordo::house;

namespace {

/// Rooms that a file of each room may include: its own and those to its right. Tests and benchmarks may include all.
const std::map<std::string, std::set<std::string>> may_include{
    {"core", {"core"}},
    {"solvers", {"solvers", "core"}},
    {"oracles", {"oracles", "core"}},
    {"studies", {"studies", "solvers", "oracles", "core"}},
    {"reports", {"reports", "studies", "solvers", "oracles", "core"}},
    {"app", {"app", "reports", "studies", "solvers", "oracles", "core"}},
    {"bench", {"bench", "app", "reports", "studies", "solvers", "oracles", "core"}},
    {"tests", {"tests", "bench", "app", "reports", "studies", "solvers", "oracles", "core"}},
};

/// Libraries of each room by the beginning of their headers. "POSIX" stands for headers of the system that end in .h;
/// immintrin.h and emmintrin.h are the compiler's own names of vector instructions.
const std::map<std::string, std::vector<std::string>> may_use{
    {"core", {}},
    {"solvers", {"Eigen/", "immintrin.h", "emmintrin.h"}},
    {"oracles", {"boost/math/", "gsl/"}},
    {"studies", {"nlohmann/", "fmt/", "boost/math/", "boost/asio/", "Eigen/", "unsupported/Eigen/"}},
    {"reports", {"nlohmann/", "fmt/", "boost/math/", "xxhash.h", "POSIX"}},
    {"app", {"boost/program_options", "nlohmann/", "fmt/", "POSIX"}},
};

/// Written by the build for the reports' provenance; it lies in no room.
bool generated(const File& file, const Include& include) {
    return file.room() == "reports" && include.target == "build_facts.hpp";
}

/// A quoted include names its target from the project's folder on, and that target's room is one that may be included.
Faults arrow_faults(const File& file) {
    Faults faults;
    for (const auto& include : includes_of(file)) {
        if (!include.quoted || generated(file, include)) continue;
        const std::string room = include.target.substr(0, include.target.find('/'));
        if (may_include.at(file.room()).contains(room)) continue;
        faults.push_back(fault(file, include.line, file.room() + " may not include \"" + include.target + "\""));
    }
    return faults;
}

bool standard(const std::string& header) {
    return std::all_of(header.begin(), header.end(),
                       [](char c) { return (c >= 'a' && c <= 'z') || c == '_' || (c >= '0' && c <= '9'); });
}

bool of_library(const std::string& header, const std::string& library) {
    static const std::regex posix(R"((sys/)?[a-z]+\.h)");
    return library == "POSIX" ? std::regex_match(header, posix) : header.starts_with(library);
}

/// Only the room's own libraries beside the standard one.
Faults library_faults(const File& file) {
    Faults faults;
    const auto libraries = may_use.find(file.room());
    if (libraries == may_use.end()) return faults;
    for (const auto& include : includes_of(file)) {
        const auto gives = [&](const std::string& library) { return of_library(include.target, library); };
        if (include.quoted || standard(include.target)) continue;
        if (std::any_of(libraries->second.begin(), libraries->second.end(), gives)) continue;
        faults.push_back(fault(file, include.line, file.room() + " may not use <" + include.target + ">"));
    }
    return faults;
}

/// Solver and truth meet in a scene, in the type that a scene fills in (and who asks for scenes), and where the engine
/// compares the two.
bool meeting_place(const File& file) {
    const auto asks_for_scenes = [](const Include& include) {
        return include.target == "studies/engine/scene_entry.hpp";
    };
    const auto includes = includes_of(file);
    return file.path.starts_with("studies/scenes/") || file.path == "studies/engine/scene_entry.hpp" ||
           file.path.starts_with("studies/engine/measure.") ||
           std::any_of(includes.begin(), includes.end(), asks_for_scenes);
}

Faults meeting_faults(const File& file) {
    if (file.room() != "studies" || meeting_place(file)) return {};
    bool solver = false;
    for (const auto& include : includes_of(file)) solver = solver || include.target.starts_with("solvers/");
    for (const auto& include : includes_of(file)) {
        if (!solver || !include.target.starts_with("oracles/")) continue;
        return {fault(file, include.line, "solver and truth meet outside studies/scenes")};
    }
    return {};
}

File seeded(const std::string& path, const std::string& include) {
    return {path, "#pragma once\n#include " + include + "\n"};
}

}  // namespace

TEST_CASE("architecture: no room is empty, so that the rules below speak of something", "[architecture]") {
    std::map<std::string, int> count;
    for (const auto& file : sources()) ++count[file.room()];
    for (const auto& room : rooms()) {
        INFO(room);
        CHECK(count[room] > 0);
    }
}

TEST_CASE("architecture: includes follow the arrows", "[architecture]") {
    CHECK(faults_in(sources(), arrow_faults) == Faults{});
}

TEST_CASE("architecture: each room uses its own libraries only", "[architecture]") {
    CHECK(faults_in(sources(), library_faults) == Faults{});
}

TEST_CASE("architecture: solver and truth meet in scenes and in the comparison only", "[architecture]") {
    CHECK(faults_in(sources(), meeting_faults) == Faults{});
}

TEST_CASE("alarm: a forbidden arrow is found", "[alarm]") {
    const auto [path, include] = GENERATE(table<std::string, std::string>({
        {"core/text.cpp", "\"solvers/solver.hpp\""},
        {"solvers/mpm/mpm.hpp", "\"oracles/oracle.hpp\""},
        {"oracles/bar_vibration.cpp", "\"solvers/scene.hpp\""},
        {"solvers/solver.hpp", "\"studies/engine/study.hpp\""},
        {"studies/engine/run.cpp", "\"reports/report.hpp\""},
        {"reports/json.cpp", "\"app/run.hpp\""},
        {"app/main.cpp", "\"tests/catch.hpp\""},
        {"solvers/mpm/mpm.hpp", "\"../oracles/oracle.hpp\""},
        {"solvers/mpm/mpm.hpp", "\"grid.hpp\""},
        {"studies/engine/run.cpp", "\"build_facts.hpp\""},
    }));
    CAPTURE(path, include);
    const auto found = arrow_faults(seeded(path, include));
    REQUIRE(found.size() == 1);
    CHECK_THAT(found.front(), ContainsSubstring(path + ":2: "));
}

TEST_CASE("alarm: an allowed arrow is not", "[alarm]") {
    const auto [path, include] = GENERATE(table<std::string, std::string>({
        {"core/text.cpp", "\"core/text.hpp\""},
        {"solvers/mpm/mpm.hpp", "\"core/error.hpp\""},
        {"studies/scenes/bar_vibration.cpp", "\"oracles/bar_vibration.hpp\""},
        {"app/main.cpp", "\"oracles/oracle.hpp\""},
        {"reports/provenance.cpp", "\"build_facts.hpp\""},
        {"tests/solvers/solver_test.cpp", "\"app/run.hpp\""},
        {"core/text.cpp", "<vector>"},
    }));
    CAPTURE(path, include);
    CHECK(arrow_faults(seeded(path, include)) == Faults{});
    CHECK(library_faults(seeded(path, include)) == Faults{});
}

TEST_CASE("alarm: a library in the wrong room is found", "[alarm]") {
    const auto [path, include] = GENERATE(table<std::string, std::string>({
        {"core/field.hpp", "<Eigen/Core>"},
        {"core/text.cpp", "<fmt/format.h>"},
        {"solvers/solver.cpp", "<boost/math/constants/constants.hpp>"},
        {"solvers/solver.cpp", "<nlohmann/json.hpp>"},
        {"oracles/oracle.hpp", "<Eigen/Core>"},
        {"oracles/oracle.hpp", "<boost/program_options.hpp>"},
        {"studies/engine/run.cpp", "<boost/program_options.hpp>"},
        {"reports/table.cpp", "<boost/program_options/options_description.hpp>"},
        {"reports/table.cpp", "<gsl/gsl_fit.h>"},
        {"solvers/solver.cpp", "<unistd.h>"},
        {"solvers/solver.cpp", "<oracles/oracle.hpp>"},
    }));
    CAPTURE(path, include);
    REQUIRE(library_faults(seeded(path, include)).size() == 1);
}

TEST_CASE("alarm: solver and truth that meet in the wrong place are found", "[alarm]") {
    const std::string both = "#include \"solvers/solver.hpp\"\n#include \"oracles/oracle.hpp\"\n";
    const std::string scenes = "#include \"studies/engine/scene_entry.hpp\"\n";
    CHECK(meeting_faults({"studies/engine/judge.cpp", both}) ==
          Faults{"studies/engine/judge.cpp:2: solver and truth meet outside studies/scenes"});
    CHECK(meeting_faults({"studies/engine/judge.cpp", "#include \"oracles/oracle.hpp\"\n"}) == Faults{});
    CHECK(meeting_faults({"studies/engine/judge.cpp", both + scenes}) == Faults{});
    CHECK(meeting_faults({"studies/scenes/bar_vibration.cpp", both}) == Faults{});
    CHECK(meeting_faults({"reports/listing.cpp", both}) == Faults{});
}

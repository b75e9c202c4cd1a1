// Length, form and left-overs of the files.
#include <algorithm>
#include <regex>

#include "tests/architecture/house.hpp"
#include "tests/catch.hpp"

using namespace ordo::house;

namespace {

constexpr std::size_t longest_source = 300;
constexpr std::size_t longest_readme = 40;

Faults length_faults(const File& file, std::size_t longest) {
    const std::size_t count = file.lines().size();
    if (count <= longest) return {};
    return {file.path + ": " + std::to_string(count) + " lines, at most " + std::to_string(longest)};
}

Faults source_length_faults(const File& file) { return length_faults(file, longest_source); }
Faults readme_length_faults(const File& file) { return length_faults(file, longest_readme); }

/// A header begins with #pragma once.
Faults guard_faults(const File& file) {
    if (!file.ends_with(".hpp") || file.text.starts_with("#pragma once\n")) return {};
    return {fault(file, 1, "a header begins with #pragma once")};
}

Faults lines_with(const File& file, const std::regex& form, const std::string& what) {
    Faults faults;
    const auto lines = file.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (std::regex_search(lines[i], form)) faults.push_back(fault(file, i + 1, what));
    }
    return faults;
}

/// No macros of ours in the product; tests have the one that Catch2 asks for.
Faults macro_faults(const File& file) {
    static const std::regex form(R"(^\s*#\s*(define|undef)\b)");
    const bool product = std::find(rooms().begin(), rooms().end(), file.room()) != rooms().end();
    return product ? lines_with(file, form, "a macro") : Faults{};
}

/// Marks of unfinished work. The words are put together here so that this file does not hold them.
Faults leftover_faults(const File& file) {
    static const std::regex form(std::string("\\b(TO") + "DO|FIX" + "ME|XX" + "X|HA" + "CK)\\b");
    return lines_with(file, form, "unfinished work");
}

/// Absolute paths into somebody's machine, where a path may begin: after a blank, a quote or a bracket.
Faults machine_path_faults(const File& file) {
    static const std::regex form(R"((^|[\s"'`(=<])/(home|Users|root|tmp|mnt|srv|work|opt)/)");
    return lines_with(file, form, "a path of one machine");
}

std::vector<File> texts() {
    return files({".hpp", ".cpp", ".json", ".md", ".sh", ".cmake", ".txt", ".bib", ".cff", ".ci/run", ".bash"});
}

File of_lines(const std::string& path, int count) {
    File file{path, ""};
    for (int i = 0; i < count; ++i) file.text += "int x;\n";
    return file;
}

}  // namespace

TEST_CASE("architecture: no source is longer than 300 lines", "[architecture]") {
    CHECK(faults_in(sources(), source_length_faults) == Faults{});
}

TEST_CASE("architecture: each room has a README of at most 40 lines", "[architecture]") {
    auto folders = rooms();
    folders.emplace_back("tests");
    for (const auto& folder : folders) {
        INFO(folder);
        const auto readmes = files({"/" + folder + "/README.md"});
        CHECK(readmes.size() == 1);
        CHECK(faults_in(readmes, readme_length_faults) == Faults{});
    }
}

TEST_CASE("architecture: every header is guarded", "[architecture]") {
    CHECK(faults_in(sources(), guard_faults) == Faults{});
}

TEST_CASE("architecture: the product has no macros of its own", "[architecture]") {
    CHECK(faults_in(sources(), macro_faults) == Faults{});
}

TEST_CASE("architecture: no unfinished work and no path of one machine", "[architecture]") {
    const auto all = texts();
    REQUIRE(all.size() > sources().size());
    CHECK(faults_in(all, leftover_faults) == Faults{});
    CHECK(faults_in(all, machine_path_faults) == Faults{});
}

TEST_CASE("alarm: a file one line too long is found", "[alarm]") {
    CHECK(source_length_faults(of_lines("core/x.cpp", 300)) == Faults{});
    CHECK(source_length_faults(of_lines("core/x.cpp", 301)) == Faults{"core/x.cpp: 301 lines, at most 300"});
    CHECK(readme_length_faults(of_lines("core/README.md", 40)) == Faults{});
    CHECK(readme_length_faults(of_lines("core/README.md", 41)) == Faults{"core/README.md: 41 lines, at most 40"});
    const File last_line_without_end{"core/x.cpp", of_lines("", 300).text + "int x;"};
    CHECK(source_length_faults(last_line_without_end).size() == 1);
}

TEST_CASE("alarm: an unguarded header, a macro, unfinished work and a machine's path are found", "[alarm]") {
    CHECK(guard_faults({"core/x.hpp", "// About.\n#pragma once\n"}).size() == 1);
    CHECK(guard_faults({"core/x.hpp", "#pragma once\n// About.\n"}) == Faults{});
    CHECK(guard_faults({"core/x.cpp", "int x;\n"}) == Faults{});

    CHECK(macro_faults({"core/x.hpp", "#pragma once\n  # define SQUARE(x) x * x\n"}) ==
          Faults{"core/x.hpp:2: a macro"});
    CHECK(macro_faults({"core/x.hpp", "#pragma once\n// We do not #define macros.\n"}) == Faults{});
    CHECK(macro_faults({"tests/main.cpp", "#define CATCH_CONFIG_MAIN\n"}) == Faults{});

    CHECK(leftover_faults({"core/x.cpp", std::string("int x;  // TO") + "DO: y\n"}).size() == 1);
    CHECK(leftover_faults({"core/x.cpp", std::string("int MASTO") + "DON;\n"}) == Faults{});

    const auto path = GENERATE(as<std::string>{}, "home", "Users", "tmp", "root");
    CHECK(machine_path_faults({"core/x.cpp", "open(\"/" + path + "/me/x.json\");\n"}).size() == 1);
    CHECK(machine_path_faults({"core/x.cpp", "#include \"core/" + path + "/x.hpp\"  // a/" + path + "/b\n"}) ==
          Faults{});
}

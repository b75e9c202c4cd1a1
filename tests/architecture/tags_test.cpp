// Every test case has exactly one kind: CTest registers by kind, so that a test without one would never run.
#include <algorithm>
#include <regex>

#include "tests/architecture/house.hpp"
#include "tests/catch.hpp"

using namespace ordo::house;

namespace {

const std::vector<std::string> kinds{"unit",      "gate",  "property",     "convergence",
                                     "published", "alarm", "architecture", "cli"};

/// The second string of each TEST_CASE or TEMPLATE_TEST_CASE that begins a line.
std::vector<std::string> tags_of(const File& file) {
    static const std::regex begin(R"(^(TEMPLATE_|)TEST_CASE\w*\()");
    static const std::regex tags(R"re(\(\s*"(?:[^"\\]|\\.)*"\s*,\s*"([^"]*)")re");
    std::vector<std::string> found;
    const auto lines = file.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!std::regex_search(lines[i], begin)) continue;
        std::string head = lines[i];
        for (std::size_t k = i + 1; k < std::min(i + 4, lines.size()); ++k) head += "\n" + lines[k];
        std::smatch match;
        found.push_back(std::regex_search(head, match, tags) ? match[1].str() : "");
    }
    return found;
}

/// Exactly one kind, and nothing that hides the case or lets it fail.
Faults tag_faults(const File& file) {
    Faults faults;
    for (const auto& tags : tags_of(file)) {
        const auto is_tag = [&](const std::string& kind) { return tags.find("[" + kind + "]") != std::string::npos; };
        const bool hidden = tags.find("[.") != std::string::npos || tags.find("[!") != std::string::npos;
        if (std::count_if(kinds.begin(), kinds.end(), is_tag) == 1 && !hidden) continue;
        faults.push_back(file.path + ": a test case has the tags '" + tags + "'");
    }
    return faults;
}

}  // namespace

TEST_CASE("architecture: every test case has exactly one kind", "[architecture]") {
    const auto tests = files({"_test.cpp"});
    std::size_t cases = 0;
    for (const auto& file : tests) cases += tags_of(file).size();
    REQUIRE(cases > tests.size());
    CHECK(faults_in(tests, tag_faults) == Faults{});
}

TEST_CASE("alarm: a test case without a kind, with two, or hidden is found", "[alarm]") {
    const auto faults = [](const std::string& text) { return tag_faults({"tests/x_test.cpp", text}).size(); };
    CHECK(faults("TEST_CASE(\"a, \\\"b\\\"\", \"[unit]\") {\n") == 0);
    CHECK(faults("TEST_CASE(\"a\",\n          \"[unit][mpm]\") {\n") == 0);
    CHECK(faults("TEMPLATE_TEST_CASE(\"a\", \"[gate]\", int, double) {\n") == 0);
    CHECK(faults("TEST_CASE(\"a\") {\n") == 1);
    CHECK(faults("TEST_CASE(\"a\", \"[slow]\") {\n") == 1);
    CHECK(faults("TEST_CASE(\"a\", \"[unit][gate]\") {\n") == 1);
    CHECK(faults("TEST_CASE(\"a\", \"[unit][.]\") {\n") == 1);
    CHECK(faults("TEST_CASE(\"a\", \"[unit][!mayfail]\") {\n") == 1);
    CHECK(faults("TEMPLATE_TEST_CASE(\"a\", \"\", int) {\n") == 1);
}

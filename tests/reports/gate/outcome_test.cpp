// What a gate found, as people and continuous integration read it.
#include "reports/gate/outcome.hpp"

#include <algorithm>
#include <cstdlib>

#include "tests/app/process.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using outside::Folder;
using reports::GateResult;
using studies::Check;
using studies::Fault;
using studies::Verdict;

namespace {

const Check pass{"order 2 +- 0.1", "mpm: u", "a paper", Verdict::pass, "1.99"};
const Check fail{"error at most 1", "mpm: u", "another", Verdict::fail, "largest 2", Fault::error_too_large};
const Check unsure{"order 2 +- 0.1", "mpm: v", "rule", Verdict::inconclusive, "1.9 [1.5, 2.3]", Fault::order_uncertain};
const std::vector<GateResult> mixed{{"first", {pass, fail, unsure}}, {"second", {pass}}};
const std::vector<GateResult> good{{"second", {pass}}};

/// A folder with one file, "gate.xml", as read by Python's XML parser: every tag with its attributes and text.
std::string parsed(const std::string& xml) {
    const Folder folder;
    folder.write("gate.xml", xml);
    const std::string program =
        "import sys, xml.etree.ElementTree as tree\n"
        "for node in tree.parse('gate.xml').iter():\n"
        "    print(node.tag, sorted(node.attrib.items()), (node.text or '').strip().encode('utf8'))\n";
    const auto outcome = outside::run({ORDO_PYTHON, "-c", program}, folder.here());
    INFO(outcome.err);
    CHECK(outcome.code == 0);
    return outcome.out;
}

/// What the runner of GitHub Actions makes of an escaped text: the order of its replacements, the percent last.
std::string unescaped(std::string text) {
    for (const auto& [code, character] : std::vector<std::pair<std::string, std::string>>{
             {"%0D", "\r"}, {"%0A", "\n"}, {"%3A", ":"}, {"%2C", ","}, {"%25", "%"}}) {
        for (auto at = text.find(code); at != std::string::npos; at = text.find(code, at + 1))
            text.replace(at, code.size(), character);
    }
    return text;
}

}  // namespace

TEST_CASE("outcome: the verdict is that of the worst check, and without checks there is none", "[unit]") {
    CHECK(GateResult{"x", {pass, pass}}.verdict() == Verdict::pass);
    CHECK(GateResult{"x", {pass, unsure}}.verdict() == Verdict::inconclusive);
    CHECK(GateResult{"x", {unsure, fail, pass}}.verdict() == Verdict::fail);
    CHECK(GateResult{"x", {}}.verdict() == Verdict::inconclusive);
}

TEST_CASE("outcome: every fault has a name of its own and a sentence on what to look at next", "[unit]") {
    std::vector<std::string> names, sentences;
    for (int i = 1; i <= static_cast<int>(Fault::time_changed); ++i) {
        names.push_back(studies::text_of(static_cast<Fault>(i)));
        sentences.push_back(reports::advice(static_cast<Fault>(i)));
        INFO(names.back());
        CHECK(names.back().size() > 5);
        CHECK(sentences.back().size() > 20);
        CHECK(sentences.back().find('\n') == std::string::npos);
    }
    for (auto* words : {&names, &sentences}) {
        std::ranges::sort(*words);
        CHECK(std::ranges::adjacent_find(*words) == words->end());
    }
    CHECK(reports::advice(Fault::none).empty());
}

TEST_CASE("outcome: a check without a fault shows its verdict instead", "[unit]") {
    CHECK(reports::name_of(fail) == "error_too_large");
    CHECK(reports::name_of({"c", "s", "", Verdict::inconclusive, ""}) == "inconclusive");
}

TEST_CASE("outcome: the text names study, subject, fault, expected and found, and what to look at next", "[unit]") {
    const auto text = reports::failures_text(mixed);
    CHECK_THAT(text, ContainsSubstring("  first  mpm: u   error_too_large  error at most 1  largest 2\n"));
    CHECK_THAT(text, ContainsSubstring("  first  mpm: v   order_uncertain  order 2 +- 0.1   1.9 [1.5, 2.3]\n"));
    CHECK_THAT(text, ContainsSubstring("what to look at next:\n  error_too_large: "));
    CHECK(text.find("second") == std::string::npos);
    CHECK(reports::failures_text(good).empty());
}

TEST_CASE("outcome: a name with line ends stays in its line of the table", "[unit]") {
    const auto text = reports::failures_text({{"a\nb\x1b[31m", {fail}}});
    CHECK_THAT(text, ContainsSubstring("  a b [31m  mpm: u"));
}

TEST_CASE("outcome: JUnit has a suite a study and a case a check; inconclusive is a failure", "[unit]") {
    const auto tree = parsed(reports::junit(mixed));
    CHECK_THAT(tree, ContainsSubstring("testsuite [('failures', '2'), ('name', 'first'), ('tests', '3')]"));
    CHECK_THAT(tree, ContainsSubstring("testsuite [('failures', '0'), ('name', 'second'), ('tests', '1')]"));
    CHECK_THAT(tree, ContainsSubstring("testcase [('classname', 'first'), ('name', 'mpm: u: order 2 +- 0.1')]"));
    CHECK_THAT(tree, ContainsSubstring("failure [('message', 'fail: expected error at most 1, found largest 2'), "
                                       "('type', 'error_too_large')]"));
    CHECK_THAT(tree, ContainsSubstring("('type', 'order_uncertain')"));
    CHECK_THAT(tree, ContainsSubstring("source: another; "));
}

TEST_CASE("alarm: JUnit stays well-formed whatever a study is called", "[alarm]") {
    const std::string name = "<a b=\"c\">&amp;]]>--'\x01\x1b\n\t\x7f\xff\xc3\xa9\xef\xbf\xbf\xef\xbf\xbe\xed\xa0\x80";
    const auto tree = parsed(reports::junit({{name, {{name, name, name, Verdict::fail, name}}}}));
    CHECK_THAT(tree, ContainsSubstring("('name', '<a b=\"c\">&amp;]]>--"));
    CHECK_THAT(tree, ContainsSubstring("\xc3\xa9"));
    CHECK(std::count(tree.begin(), tree.end(), '\n') == 4);
}

TEST_CASE("outcome: an annotation for each check that does not pass", "[unit]") {
    CHECK(reports::annotations(good).empty());
    CHECK(reports::annotations(mixed) ==
          "::error title=first%3A error_too_large::mpm: u: expected error at most 1; found largest 2\n"
          "::error title=first%3A order_uncertain::mpm: v: expected order 2 +- 0.1; found 1.9 [1.5, 2.3]\n");
}

TEST_CASE("alarm: no name breaks out of an annotation, and the runner reads it back", "[alarm]") {
    const std::string name = "100 %0A,b:c::error title=x::\r\n::set-output name=y::z%";
    const auto text = reports::annotations({{name, {{"claim", name, "", Verdict::fail, "found", Fault::at_floor}}}});
    REQUIRE(std::count(text.begin(), text.end(), '\n') == 1);
    CHECK(text.find('\r') == std::string::npos);
    const auto title_at = text.find("title=") + 6;
    const auto end = text.find("::", title_at);
    const auto title = text.substr(title_at, end - title_at);
    CHECK(title.find_first_of(":,") == std::string::npos);
    CHECK(unescaped(title) == name + ": at_floor");
    CHECK(unescaped(text.substr(end + 2)) == name + ": expected claim; found found\n");
}

TEST_CASE("outcome: the summary counts, lists what does not pass, and then every study", "[unit]") {
    const auto page = reports::summary(mixed);
    CHECK_THAT(page, ContainsSubstring("## ordo check: 2 studies, 2 checks pass, 1 fail, 1 inconclusive\n"));
    CHECK_THAT(page, ContainsSubstring("| first | mpm: u | error\\_too\\_large | error at most 1 | largest 2 |\n"));
    CHECK_THAT(page, ContainsSubstring("* **error\\_too\\_large**: "));
    CHECK_THAT(page, ContainsSubstring("| first | fail | 3 |\n| second | pass | 1 |\n"));
    const auto quiet = reports::summary(good);
    CHECK(quiet.find("fault") == std::string::npos);
    CHECK_THAT(quiet, ContainsSubstring("| second | pass | 1 |\n"));
}

TEST_CASE("alarm: no name breaks out of a row of the summary", "[alarm]") {
    const auto page = reports::summary({{"a|b\n| c <script> `d` [e](f)", {fail}}});
    CHECK_THAT(page, ContainsSubstring("| a\\|b \\| c \\<script\\> \\`d\\` \\[e\\](f) | fail | 1 |\n"));
}

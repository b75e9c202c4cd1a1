// The page that lists the faults lists these and no others.
#include <set>

#include "studies/reader/json_input.hpp"
#include "tests/catch.hpp"
#include "tests/mutations/mutation.hpp"

namespace ordo::tests {
namespace {

std::string row_of(const std::string& kind, const Mutation& mutation) {
    std::string names;
    for (const auto fault : mutation.caught_by) names += (names.empty() ? "`" : ", `") + studies::text_of(fault) + "`";
    return "| " + kind + " | " + mutation.what + " | `" + mutation.study.name + "` | " + names + " |\n";
}

/// The rows of the page's table with that head.
std::string rows_below(const std::string& head) {
    std::string page = studies::read_text(std::string(ORDO_SOURCE_DIR) + "/docs/mutations.md") + "\n";
    const auto begin = page.find(head);
    REQUIRE(begin != std::string::npos);
    page.erase(0, page.find("|\n", page.find("|---", begin)) + 2);
    return page.substr(0, page.find("\n\n") + 1);
}

}  // namespace

TEST_CASE("mutations: the page lists every fault of the suite, and no other", "[alarm]") {
    std::string rows;
    for (const auto& [kind, mutations] : all_mutations()) {
        for (const auto& mutation : mutations) rows += row_of(kind, mutation);
    }
    CHECK(rows_below("| Class | Fault | Study | Caught by |") == rows);
    std::string unseen;
    for (const auto& [what, study, fault, why] : blind_spots())
        unseen += "| " + what + " | `" + study.name + "` | " + why + " |\n";
    CHECK(rows_below("| Fault | Study | Why |") == unseen);
}

TEST_CASE("mutations: at least three faults in each class, and no name twice", "[alarm]") {
    std::set<std::string> names;
    std::size_t count = 0;
    for (const auto& [kind, mutations] : all_mutations()) {
        INFO(kind);
        CHECK(mutations.size() >= 3);
        for (const auto& mutation : mutations) {
            INFO(mutation.what);
            CHECK_FALSE(mutation.caught_by.empty());
            names.insert(mutation.what + mutation.study.name);
            ++count;
        }
    }
    CHECK(count >= 25);
    CHECK(names.size() == count);
}

}  // namespace ordo::tests

// ordo table, from outside.
#include "tests/app/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::make_report;

TEST_CASE("cli: a table in each of its four formats", "[cli]") {
    const Folder folder;
    make_report(folder);
    const std::vector<std::pair<std::string, std::string>> marks{
        {"text", "verdict: pass"}, {"markdown", "|"}, {"latex", "\\begin{tabular}"}, {"csv", ","}};
    for (const auto& [format, mark] : marks) {
        const auto table = folder.ordo({"table", "r.json", "--format", format});
        INFO(format);
        CHECK(table.code == 0);
        CHECK(table.err.empty());
        CHECK_THAT(table.out, ContainsSubstring(mark));
        CHECK_THAT(table.out, ContainsSubstring("16"));
    }
    CHECK(folder.ordo({"table", "r.json"}).out == folder.ordo({"table", "r.json", "--format", "text"}).out);
    const auto wrong = folder.ordo({"table", "r.json", "--format", "latx"});
    CHECK(wrong.code == 2);
    CHECK_THAT(wrong.err, ContainsSubstring("nearest: 'latex'"));
}

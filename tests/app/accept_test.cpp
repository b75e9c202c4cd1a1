// ordo accept, from outside.
#include "tests/app/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::make_report;
using outside::Names;
using outside::scale_error;
using outside::Words;
using samples::Json;

namespace {

const Words against_base{"check", "r.json", "--against", "base"};

}  // namespace

TEST_CASE("cli: accept makes a baseline that the report then passes against", "[cli]") {
    const Folder folder;
    make_report(folder);
    const auto accepted = folder.ordo({"accept", "r.json", "--because", "first time", "--into", "base"});
    CHECK(accepted.code == 0);
    CHECK_THAT(accepted.out, ContainsSubstring("base/sample.json"));
    CHECK(folder.names() == Names{"base", "base/sample.json", "r.json", "s.json"});
    const auto baseline = Json::parse(folder.read("base/sample.json"));
    CHECK(baseline["because"] == "first time");
    CHECK_FALSE(baseline["compiler"].get<std::string>().empty());

    const auto checked = folder.ordo(against_base);
    CHECK(checked.code == 0);
    CHECK_THAT(checked.out, ContainsSubstring("errors as accepted within 1e-06 relative"));
}

TEST_CASE("cli: accepting again says how far the new one is from the old, and takes a wider band", "[cli]") {
    const Folder folder;
    make_report(folder);
    REQUIRE(folder.ordo({"accept", "r.json", "--because", "x", "--into", "base"}).code == 0);
    scale_error(folder, 1.01);
    const auto again = folder.ordo({"accept", "r.json", "--because", "y", "--into", "base", "--band", "0.1"});
    CHECK(again.code == 0);
    CHECK_THAT(again.out, ContainsSubstring("replaces") && ContainsSubstring("largest difference 0.01"));
    scale_error(folder, 1.005);  // more would scatter its three points beyond its own gate
    CHECK(folder.ordo(against_base).code == 0);
}

TEST_CASE("cli: accept refuses what has no reason, fails, or has a band that is none", "[cli]") {
    const Folder folder;
    make_report(folder, {"expect.0.order=1"});
    folder.write("bad.json", folder.read("r.json"));
    make_report(folder);
    const Names before = folder.names();
    const std::vector<Words> refused{{"accept", "r.json", "--into", "base"},
                                     {"accept", "r.json", "--into", "base", "--because", ""},
                                     {"accept", "bad.json", "--into", "base", "--because", "x"},
                                     {"accept", "r.json", "r.json", "--into", "base", "--because", "x"},
                                     {"accept", "r.json", "--into", "base", "--because", "x", "--band", "0"},
                                     {"accept", "r.json", "--into", "base", "--because", "x", "--band", "1"},
                                     {"accept", "r.json", "--into", "base", "--because", "x", "--band", "nan"},
                                     {"accept", "r.json", "--into", "s.json", "--because", "x"},
                                     {"accept", "r.json", "--into", "", "--because", "x"}};
    for (const auto& words : refused) {
        const auto outcome = folder.ordo(words);
        INFO(outcome.err);
        CHECK(outcome.code == 2);
        CHECK(outcome.err_lines() == 1);
        CHECK(outcome.out.empty());
        CHECK(folder.names() == before);
    }
}

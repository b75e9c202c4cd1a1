// ordo accept, from outside.
#include "tests/app/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::make_report;
using outside::make_twin;
using outside::Names;
using outside::scale_error;
using outside::Words;
using samples::Json;

namespace {

const Words against_base{"check", "r.json", "--against", "base"};
const Words accept{"accept", "r.json", "--into", "base", "--because", "first time"};

}  // namespace

TEST_CASE("cli: accept makes a baseline that the report then passes against", "[cli]") {
    const Folder folder;
    make_report(folder);
    const auto accepted = folder.ordo(accept);
    CHECK(accepted.code == 0);
    CHECK_THAT(accepted.out, ContainsSubstring("base/sample.json") && ContainsSubstring("no twin was given"));
    CHECK(folder.names() == Names{"base", "base/sample.json", "r.json", "s.json"});
    const auto baseline = Json::parse(folder.read("base/sample.json"));
    CHECK(baseline["because"] == "first time");
    REQUIRE(baseline["reports"].size() == 1);
    CHECK_FALSE(baseline["reports"][0]["compiler"].get<std::string>().empty());
    CHECK(baseline["time_ratio"].get<double>() > 0);
    CHECK(folder.ordo(against_base).code == 0);
}

TEST_CASE("cli: a twin widens the tolerances to what was measured, and is kept by name", "[cli]") {
    const Folder folder;
    make_report(folder);
    make_twin(folder);
    REQUIRE(folder.ordo(accept).code == 0);
    const Words twin_against_base{"check", "twin.json", "--against", "base"};
    CHECK(folder.ordo(twin_against_base).code == 1);
    const auto again = folder.ordo({"accept", "r.json", "twin.json", "--into", "base", "--because", "two builds"});
    CHECK(again.code == 0);
    CHECK_THAT(again.out, ContainsSubstring("from 2 reports") && ContainsSubstring("old tolerance"));
    CHECK(again.out.find("no twin was given") == std::string::npos);
    CHECK(folder.ordo(twin_against_base).code == 0);
    CHECK(folder.ordo(against_base).code == 0);
    const auto baseline = Json::parse(folder.read("base/sample.json"));
    CHECK(baseline["reports"][1]["flags"] == "-O3 -march=x86-64-v3 -ffp-contract=fast");
}

TEST_CASE("cli: accepting again shows what changed: figure, old, new, tolerances", "[cli]") {
    const Folder folder;
    make_report(folder);
    REQUIRE(folder.ordo(accept).code == 0);
    const auto same = folder.ordo(accept);
    CHECK_THAT(same.out, ContainsSubstring("replaces the baseline of") && ContainsSubstring("first time") &&
                             ContainsSubstring("no figure left its interval"));
    scale_error(folder, 1.01);
    const auto again = folder.ordo(accept);
    CHECK(again.code == 0);
    CHECK_THAT(again.out, ContainsSubstring("figure") && ContainsSubstring("old tolerance") &&
                              ContainsSubstring("mpm, cells = 8, dt = 0.005: displacement.rms"));
    CHECK(again.out.find("cells = 16, dt = 0.005: displacement.rms") == std::string::npos);
}

TEST_CASE("cli: accepting another question says which member changed", "[cli]") {
    const Folder folder;
    make_report(folder);
    REQUIRE(folder.ordo(accept).code == 0);
    make_report(folder, {"scene.rho=1.1"});
    const auto again = folder.ordo(accept);
    CHECK(again.code == 0);
    CHECK_THAT(again.out, ContainsSubstring("the study's /scene/rho was 1, is 1.1"));
}

TEST_CASE("cli: what lies in the baseline's place and is none is replaced, and said so", "[cli]") {
    const Folder folder;
    make_report(folder);
    folder.write("base/sample.json", "{\"schema\": \"ordo-baseline-1\"}");
    const auto accepted = folder.ordo(accept);
    CHECK(accepted.code == 0);
    CHECK_THAT(accepted.out, ContainsSubstring("replaces what cannot be compared"));
    CHECK(folder.ordo(against_base).code == 0);
}

TEST_CASE("cli: accept refuses what has no reason, fails, or is no twin, and writes nothing", "[cli]") {
    const Folder folder;
    make_report(folder, {"scene.E=50"});
    folder.write("other.json", folder.read("r.json"));
    make_report(folder, {"expect.0.order=1"});
    folder.write("bad.json", folder.read("r.json"));
    make_report(folder);
    make_twin(folder);
    const Names before = folder.names();
    const std::vector<Words> refused{{"accept", "--into", "base", "--because", "x"},
                                     {"accept", "r.json", "--into", "base"},
                                     {"accept", "r.json", "--into", "base", "--because", ""},
                                     {"accept", "none.json", "--into", "base", "--because", "x"},
                                     {"accept", "s.json", "--into", "base", "--because", "x"},
                                     {"accept", "bad.json", "--into", "base", "--because", "x"},
                                     {"accept", "r.json", "bad.json", "--into", "base", "--because", "x"},
                                     {"accept", "r.json", "r.json", "--into", "base", "--because", "x"},
                                     {"accept", "r.json", "other.json", "--into", "base", "--because", "x"},
                                     {"accept", "r.json", "twin.json", "twin.json", "none", "--because", "x"},
                                     {"accept", "r.json", "--into", "base", "--because", "x", "--band", "0.1"},
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

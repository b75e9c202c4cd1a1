// Run time against error, from outside: ordo run --time, table --rank, plot --reach and boards.
#include "tests/app/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::make_report;
using samples::Json;

namespace {

void make_timed_report(const Folder& folder) {
    folder.write("s.json", samples::study().dump());
    CHECK(folder.ordo({"run", "s.json", "--time", "-o", "r.json"}).code == 0);
    REQUIRE(folder.has("r.json"));
}

}  // namespace

TEST_CASE("cli: timed runs bring median, spread and repetitions, and the same answer but for provenance", "[cli]") {
    const Folder folder;
    make_timed_report(folder);
    auto timed = Json::parse(folder.read("r.json"));
    const auto provenance = timed["provenance"];
    REQUIRE(provenance["run_repetitions"].size() == 3);
    REQUIRE(provenance["run_spreads"].size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(provenance["run_seconds"][i] > 0);
        CHECK(provenance["run_repetitions"][i] >= 5);
        CHECK(provenance["run_repetitions"][i] <= 25);
        CHECK(provenance["run_spreads"][i] >= 0);
    }
    make_report(folder);
    auto once = Json::parse(folder.read("r.json"));
    CHECK_FALSE(once["provenance"].contains("run_spreads"));
    timed.erase("provenance");
    once.erase("provenance");
    CHECK(timed == once);
}

TEST_CASE("cli: timing takes one run at a time, and refuses several", "[cli]") {
    const Folder folder;
    folder.write("s.json", samples::study().dump());
    const auto ran = folder.ordo({"run", "s.json", "--time", "--jobs", "2", "-o", "r.json"});
    CHECK(ran.code == 2);
    CHECK(ran.err_lines() == 1);
    CHECK_THAT(ran.err, ContainsSubstring("--time") && ContainsSubstring("one at a time"));
    CHECK_FALSE(folder.has("r.json"));
}

TEST_CASE("cli: methods are ranked at errors, and a list that is none is refused", "[cli]") {
    const Folder folder;
    make_timed_report(folder);
    const auto table = folder.ordo({"table", "r.json", "r.json", "--rank", "1e-4,1e-9"});
    CHECK(table.code == 0);
    CHECK_THAT(table.out, ContainsSubstring("error 1e-04") && ContainsSubstring("not in"));
    CHECK(folder.ordo({"table", "r.json", "r.json"}).code == 2);
    CHECK(folder.ordo({"table", "--rank", "1e-4"}).code == 2);
    for (const char* wrong : {"0", "-1", "x", "1e-4,", "1e-4,1e-4", "1e-4 1e-5", "inf", "nan"}) {
        INFO(wrong);
        const auto refused = folder.ordo({"table", "r.json", "--rank", wrong});
        CHECK(refused.code == 2);
        CHECK(refused.err_lines() == 1);
        CHECK_THAT(refused.err, ContainsSubstring("--rank"));
    }
}

TEST_CASE("cli: errors asked for are drawn, and several reports make one picture", "[cli]") {
    const Folder folder;
    make_timed_report(folder);
    CHECK(folder.ordo({"plot", "r.json", "-o", "p", "--against", "time", "--reach", "1e-3"}).code == 0);
    CHECK(folder.ordo({"plot", "r.json", "r.json", "-o", "b", "--against", "time,work"}).code == 0);
    CHECK(folder.names() == outside::Names{"b", "b/board-time.gp", "b/board-time.svg", "b/board-work.gp",
                                           "b/board-work.svg", "p", "p/sample-displacement.rms-time.gp",
                                           "p/sample-displacement.rms-time.svg", "r.json", "s.json"});
    CHECK(folder.ordo({"plot", "r.json", "r.json", "-o", "c"}).code == 2);
    CHECK(folder.ordo({"plot", "r.json", "r.json", "-o", "c", "--against", "time", "--reach", "1e-3"}).code == 2);
    CHECK_FALSE(folder.has("c"));
}

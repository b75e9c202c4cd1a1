// ordo check, from outside.
#include "tests/app/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::make_report;
using outside::scale_error;
using outside::Words;
using samples::Json;

namespace {

const Words against_base{"check", "r.json", "--against", "base"};

}  // namespace

TEST_CASE("cli: a good report passes its own gate, which says that it is the only one", "[cli]") {
    const Folder folder;
    make_report(folder);
    const auto checked = folder.ordo({"check", "r.json"});
    CHECK(checked.code == 0);
    CHECK(checked.err.empty());
    CHECK_THAT(checked.out, ContainsSubstring("sample: pass") && ContainsSubstring("expectations only"));
}

TEST_CASE("cli: a gate over several reports fails with the worst of them", "[cli]") {
    const Folder folder;
    make_report(folder, {"expect.0.order=1"});
    folder.write("bad.json", folder.read("r.json"));
    make_report(folder);
    CHECK(folder.ordo({"check", "r.json", "r.json"}).code == 0);
    CHECK(folder.ordo({"check", "r.json", "bad.json"}).code == 1);
    CHECK(folder.ordo({"check", "bad.json", "r.json"}).code == 1);
}

TEST_CASE("alarm: a report that moved away from its baseline fails, within its own expectations", "[cli]") {
    const Folder folder;
    make_report(folder);
    REQUIRE(folder.ordo({"accept", "r.json", "--because", "x", "--into", "base"}).code == 0);
    scale_error(folder, 1 + 1e-9);
    CHECK(folder.ordo(against_base).code == 0);
    scale_error(folder, 1 + 1e-4);
    CHECK(folder.ordo({"check", "r.json"}).code == 0);
    const auto checked = folder.ordo(against_base);
    CHECK(checked.code == 1);
    CHECK_THAT(checked.out, ContainsSubstring("sample: fail") && ContainsSubstring("largest difference 0.0001"));
}

TEST_CASE("alarm: another study, or none accepted, is no baseline", "[cli]") {
    const Folder folder;
    make_report(folder);
    const auto none = folder.ordo(against_base);
    CHECK(none.code == 1);
    CHECK_THAT(none.out, ContainsSubstring("there is no baseline base/sample.json"));
    REQUIRE(folder.ordo({"accept", "r.json", "--because", "x", "--into", "base"}).code == 0);
    make_report(folder, {"scene.E=50"});
    const auto other = folder.ordo(against_base);
    CHECK(other.code == 1);
    CHECK_THAT(other.out, ContainsSubstring("the study differs"));
}

TEST_CASE("alarm: an empty --against is refused, not taken for none", "[cli]") {
    const Folder folder;
    make_report(folder);
    CHECK(folder.ordo({"check", "r.json", "--against", ""}).code == 2);
}

TEST_CASE("cli: the checks go to a JUnit file, which a bad input does not make", "[cli]") {
    const Folder folder;
    make_report(folder, {"expect.0.order=1"});
    CHECK(folder.ordo({"check", "r.json", "none.json", "--junit", "ci/gate.xml"}).code == 2);
    CHECK_FALSE(folder.has("ci"));
    CHECK(folder.ordo({"check", "r.json", "--junit", "ci/gate.xml"}).code == 1);
    CHECK_THAT(folder.read("ci/gate.xml"), ContainsSubstring("<testsuite name=\"sample\" tests=\"3\" failures=\"1\">"));
    CHECK(folder.ordo({"check", "r.json", "--junit", "r.json/gate.xml"}).code == 2);
}

TEST_CASE("alarm: an edited verdict does not pass the gate", "[cli]") {
    const Folder folder;
    make_report(folder, {"expect.0.order=1"});
    Json report = Json::parse(folder.read("r.json"));
    report["verdict"] = "pass";
    for (auto& check : report["checks"]) check["verdict"] = "pass";
    folder.write("r.json", report.dump());
    CHECK(folder.ordo({"check", "r.json"}).code == 1);
    CHECK(folder.ordo({"accept", "r.json", "--because", "x", "--into", "base"}).code == 2);
}

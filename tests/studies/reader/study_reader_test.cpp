// The strict reader: what is not understood is refused with place, rule and nearest choice.
#include "studies/reader/study_reader.hpp"

#include <filesystem>
#include <fstream>
#include <map>

#include "core/error.hpp"
#include "studies/engine/run.hpp"
#include "tests/catch.hpp"
#include "tests/studies/sample_study.hpp"

using namespace ordo;
using namespace ordo::studies;
using ordo::tests::sample_document;
using ordo::tests::study_of;
using ordo::tests::with;

namespace {

/// The message with which a changed sample is refused; "" when it is accepted.
std::string refusal(const std::string& pointer, const std::string& value) {
    try {
        study_of(with(pointer, value));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::string refusal_of_text(const std::string& text) {
    try {
        study_from_text(text, "sample.json", "");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a study file becomes a study with every default filled in", "[unit]") {
    const Study study = study_of(sample_document());
    CHECK(study.name == "sample");
    CHECK(study.scene.values.number("L") == 25);
    CHECK(study.scene.values.word("law") == "E(F-1)");
    REQUIRE(study.solvers.size() == 1);
    CHECK(study.solvers[0].label == "mpm");
    CHECK(study.solvers[0].options.word("stress_update") == "musl");
    CHECK(study.sweep.path == Path::space);
    REQUIRE(study.sweep.axes.size() == 3);
    CHECK(study.sweep.axes[0].values == std::vector<double>{4, 8, 16});
    REQUIRE(study.measure.quantities.size() == 1);
    CHECK(study.measure.quantities[0].key() == "displacement.rms");
    CHECK(study.measure.until == Until::exact);
}

TEST_CASE("a list in an option stands for one solver each, labelled by what differs", "[unit]") {
    const Study study =
        study_of(with("/solvers/0", R"({"name": "mpm", "stress_update": ["usl", "musl"], "margin": [0.1, 0.5]})"));
    REQUIRE(study.solvers.size() == 4);
    CHECK(study.solvers[0].label == "mpm, margin = 0.1 usl");
    CHECK(study.solvers[3].label == "mpm, margin = 0.5 musl");
    CHECK(study_of(with("/solvers", R"("all")")).solvers.size() == 2);  // mpm and fem
}

TEST_CASE("a solver may have a label; its variants are told apart behind it", "[unit]") {
    const Study study = study_of(with("/solvers", R"([{"name": "mpm", "label": "theirs"},
        {"name": "mpm", "label": "ours", "stress_update": ["usl", "musl"]}, {"name": "fem"}])"));
    REQUIRE(study.solvers.size() == 4);
    CHECK(study.solvers[0].label == "theirs");
    CHECK(study.solvers[1].label == "ours usl");
    CHECK(study.solvers[2].label == "ours musl");
    CHECK(study.solvers[3].label == "fem");
}

TEST_CASE("an axis that a solver does not know leaves it alone", "[unit]") {
    auto document = with("/solvers", R"("all")");
    document["sweep"]["ppc"] = {1, 2};
    std::map<std::string, int> runs;
    for (const auto& spec : specs_of(study_of(document))) {
        ++runs[spec.solver.name];
        CHECK(spec.axes.size() == (spec.solver.name == "mpm" ? 3 : 2));
    }
    CHECK(runs == std::map<std::string, int>{{"mpm", 6}, {"fem", 3}});
    CHECK_THROWS_WITH(study_of(with("/sweep/dx", "0.1")), ContainsSubstring("is not a resolution of solver mpm"));
}

TEST_CASE("the document of a study reads back as the same study", "[unit]") {
    const Study study =
        study_of(with("/published", R"({"compare": "band", "band": 0.1, "table": {"id": "T", "title": "t",
        "source": "WobbesTielen2015", "quantity": "displacement.rms", "rows": [{"cells": 4, "value": "1.0e-03"}]}})"));
    const Study again = study_from_text(study.document, "again", "");
    CHECK(again.document == study.document);
    REQUIRE(again.published.size() == 1);
    CHECK(again.published[0].values[0].printed == "1.0e-03");
}

TEST_CASE("a bad member is refused by place, rule and nearest choice", "[alarm]") {
    const auto [pointer, value, says] = GENERATE(table<std::string, std::string, std::string>({
        {"/scene/EE", "100", "/scene: 'EE' is not a parameter of scene bar_vibration (nearest: 'E')"},
        {"/scene/E", "\"hard\"", "'E' is 'hard', but must be a number, > 0"},
        {"/scene/E", "-1", "'E' is -1, but must be > 0"},
        {"/scene/mode", "1.5", "a whole number in [1, 1000]"},
        {"/scene/name", "\"bar_vibratoin\"", "there is no scene 'bar_vibratoin' (nearest: 'bar_vibration')"},
        {"/scene", "3", "/scene: must be an object"},
        {"/solvers/0/name", "\"mmp\"", "there is no solver 'mmp' (valid: mpm, fem, "},
        {"/solvers/0/stress_update", "\"mulsl\"", "(nearest: 'musl')"},
        {"/solvers/0/stress_update", "[]", "/solvers/0/stress_update: is an empty list"},
        {"/solvers/0/conservative", "1", "must be true or false"},
        {"/solvers", "[]", "no solver takes part"},
        {"/solvers", "[{\"name\": \"mpm\"}, {\"name\": \"mpm\"}]", "is listed twice"},
        {"/solvers", "\"al\"", "must be one of: all"},
        {"/sweep/cells", "[]", "/sweep/cells: is an empty list"},
        {"/sweep/cells", "[4, -8]", "/sweep/cells/1: 'cells' is -8"},
        {"/sweep/cells", "[4, 4]", "the value 4 is repeated"},
        {"/sweep/cells", "[4, \"8\"]", "/sweep/cells/1: is '8', but must be a number"},
        {"/sweep/dx", "0.1", "is not a resolution of solver mpm"},
        {"/sweep/dt", "-1e-3", "'dt' is -0.001, but must be > 0"},
        {"/sweep/path", "\"spcae\"", "(nearest: 'space')"},
        {"/sweep/path", "\"joint\"", "path 'joint' needs 'courant'"},
        {"/sweep/path", "\"grid\"", "path 'grid' needs several values"},
        {"/sweep/courant", "0.5", "path 'space' keeps dt fixed"},
        {"/sweep", "{\"cells\": [4, 8], \"dt\": 0.1, \"courant\": 0.1, \"path\": \"joint\"}",
         "has both 'dt' and 'courant'"},
        {"/measure/at", "0", "/measure/at: is 0, but must be > 0"},
        {"/measure/until", "\"step\"", "(nearest: 'steps')"},
        {"/measure/until", "\"steps\"", "a whole number of steps"},
        {"/measure/fields", "[\"displacment\"]", "(nearest: 'displacement')"},
        {"/measure/fields", "[]", "is an empty list"},
        {"/measure/norms", "\"max\"", "but must be one of: rms, l1, l2, linf"},
        {"/measure/against", "\"finest\"", "only where the sweep's path is 'time'"},
        {"/measure/norms", "\"shock\"", "/measure/norms: 'shock' needs a scene on a line"},
        {"/measure/norms", "[\"rms\", \"l1_fans\"]", "'l1_fans' needs a scene on a line"},
        {"/measure/norms", "\"fan_edges\"", "(nearest: 'fan_edge')"},
        {"/sweep/coupling", R"({"dt": 1, "power": 2})", "/sweep/coupling: belongs to path 'joint' only"},
        {"/sweep/coupling", R"({"dt": 1})", "'power' is missing"},
        {"/sweep/coupling", R"({"dt": 0, "power": 1})", "must be > 0"},
        {"/sweep/coupling", R"({"dt": 1, "powr": 1})", "(nearest: 'power')"},
        {"/measure/orders_against", "\"dt\"",
         "must be h (the sweep's path), a swept axis, or one over an axis or a counter"},
        {"/measure/orders_against", "\"1/\"", "must be h"},
        {"/measure/orders_against", "\"steps\"", "must be h"},
        {"/measure/orders_against", "[]", "is an empty list"},
        {"/measure/orders_against", "[\"h\", \"h\"]", "/measure/orders_against/1: repeats 'h'"},
        {"/measure/orders_against", "\"1/steps\"", "/expect/0: must say 'against' what its order is: 1/steps"},
        {"/expect/0/against", "\"1/steps\"", "/expect/0/against: is '1/steps', but must be one of: h"},
        {"/expect", "[{\"error_at_most\": 1, \"against\": \"h\", \"source\": \"test\"}]", "belongs to 'order' only"},
        {"/expect/0/within", "0", "must be > 0"},
        {"/expect/0/order", "\"two\"", "/expect/0/order: is 'two', but must be a number or 'expected'"},
        {"/expect/0/may_exceed", "\"\"", "/expect/0/may_exceed: is empty, but must say why"},
        {"/expect/0/levels", "1", "/expect/0/levels: is 1, but must be a whole number from 2"},
        {"/expect/0/levels", "2.5", "must be a whole number"},
        {"/expect", "[{\"error_at_most\": 1, \"levels\": 3, \"source\": \"test\"}]",
         "/levels: belongs to 'order' only"},
        {"/expect", "[{\"error_at_most\": 1, \"may_exceed\": \"a\", \"source\": \"test\"}]", "belongs to 'order' only"},
        {"/measure/near", "1", "/measure/near: belongs to the norms l1_near and l1_away only"},
        {"/measure/norms", "\"l1_near\"", "the member 'near' is missing"},
        {"/expect/0/error_at_most", "1", "exactly one of: order, error_at_most, exact_within"},
        {"/expect/0/where", "\"cels <= 8\"", "'cels' is not an axis of the sweep (nearest: 'cells')"},
        {"/expect/0/where", "\"cells ~ 8\"", "but must be: axis op number"},
        {"/expect/0/where", "\"cells <= many\"", "'many' is not a number"},
        {"/expect/0/of", "\"displacement.l2\"", "must be one of: displacement.rms"},
        {"/expect/0/solver", "\"mpm usl\"", "must be one of: mpm"},
        {"/expcet", "[]", "unknown member 'expcet' (nearest: 'expect')"},
        {"/timeout_s", "0", "must be > 0"},
        {"/allow", "\"failed\"", "must be one of: diverged"},
        {"/published", "{\"file\": \"none.json\", \"compare\": \"digits\"}", "there is no such file"},
        {"/published", "{\"compare\": \"digits\"}", "the member 'table' is missing"},
        {"/scene/x~1E", "5", "'x/E' is not a parameter of scene bar_vibration"},
        {"/study", "\"\"", "/study: is empty"},
        {"/study", "7", "/study: is 7, but must be a string"},
    }));
    CAPTURE(pointer, value);
    CHECK_THAT(refusal(pointer, value), ContainsSubstring(says));
}

TEST_CASE("an expectation without its source is refused", "[alarm]") {
    auto document = sample_document();
    document["expect"][0].erase("source");
    CHECK_THAT(refusal_of_text(document.dump()), ContainsSubstring("/expect/0: the member 'source' is missing"));
}

TEST_CASE("text that is no acceptable JSON is refused by place", "[alarm]") {
    CHECK_THAT(refusal_of_text("{\"study\": NaN}"), ContainsSubstring("line 1, column 11"));
    CHECK_THAT(refusal_of_text("{\"study\": \"a\", \"study\": \"b\"}"), ContainsSubstring("'study' stands twice"));
    CHECK_THAT(refusal_of_text("{\"study\": 1e999}"), ContainsSubstring("number overflow"));
    CHECK_THAT(refusal_of_text(std::string(200'000, '[')), ContainsSubstring("nested deeper than 64"));
    CHECK_THAT(refusal_of_text("[]"), ContainsSubstring("must be an object"));
    CHECK_THAT(refusal_of_text(""), ContainsSubstring("not valid JSON"));
}

TEST_CASE("comments are allowed, in lines and in blocks", "[unit]") {
    const std::string text = "// head\n" + sample_document().dump() + " /* tail */";
    CHECK(study_from_text(text, "sample.json", "").name == "sample");
}

TEST_CASE("settings replace, add and list values; a place that is not there is refused", "[unit]") {
    const auto folder = std::filesystem::temp_directory_path() / "ordo_study_reader_test";
    std::filesystem::create_directories(folder);
    const auto path = (folder / "sample.json").string();
    std::ofstream(path) << sample_document().dump();
    const Study study = read_study(path, {setting_from("sweep.cells=8,16"), setting_from("scene.E=50"),
                                          setting_from("solvers.0.stress_update=usl")});
    CHECK(study.sweep.axes[0].values == std::vector<double>{8, 16});
    CHECK(study.scene.values.number("E") == 50);
    CHECK(study.solvers[0].options.word("stress_update") == "usl");
    CHECK_THROWS_AS(setting_from("sweep.cells"), InputError);
    CHECK_THROWS_AS(read_study(path, {setting_from("swep.cells=4")}), InputError);
    CHECK_THROWS_AS(read_study(path, {setting_from("sweep.clls=4")}), InputError);
    CHECK_THROWS_AS(read_study(path, {setting_from("solvers.x.basis=linear")}), InputError);
    std::filesystem::remove_all(folder);
}

namespace {

/// Sod's tube on fixed and on replaced cells, each with a width of its own.
Json tube() {
    return Json::parse(R"json({
        "study": "tube", "scene": { "name": "gas_riemann" },
        "solvers": [ { "name": "rrm" }, { "name": "godunov" } ],
        "sweep": { "cells": [10, 20], "delta": [1e-2, 1e-3, 1e-4], "path": "space" },
        "measure": { "at": 1, "fields": ["density"], "norms": ["l1", "shock", "contact", "fan_edge", "l1_fans"] }
    })json");
}

std::string refusal_of_tube(const std::string& pointer, const std::string& value) {
    auto document = tube();
    document[Json::json_pointer(pointer)] = Json::parse(value);
    return refusal_of_text(document.dump());
}

}  // namespace

TEST_CASE("each solver is refined by its own width axis, in one sweep", "[unit]") {
    std::map<std::string, std::vector<double>> widths;
    for (const auto& spec : specs_of(study_of(tube()))) {
        REQUIRE(spec.axes.size() == 1);
        CHECK(spec.axes[0].name == (spec.solver.name == "rrm" ? "delta" : "cells"));
        widths[spec.solver.name].push_back(spec.axes[0].value);
    }
    CHECK(widths == std::map<std::string, std::vector<double>>{{"rrm", {1e-2, 1e-3, 1e-4}}, {"godunov", {10, 20}}});
    auto document = tube();
    document["sweep"]["courant"] = 0.4;
    document["sweep"]["path"] = "joint";
    CHECK(specs_of(study_of(document)).size() == 5);
}

TEST_CASE("a path is checked against the width axis of each solver", "[alarm]") {
    auto document = sample_document();
    document["scene"] = {{"name", "scalar_root"}};
    document["solvers"] = {{{"name", "root_finding"}}};
    document["sweep"] = {{"iterations", {1, 2}}, {"path", "grid"}};
    CHECK_THAT(refusal_of_text(document.dump()), ContainsSubstring("several values of 'iterations' and of 'dt'"));
}

TEST_CASE("norms about waves are refused where there is nothing to measure", "[alarm]") {
    CHECK(study_of(tube()).measure.quantities.size() == 5);
    CHECK_THAT(refusal_of_tube("/measure/fields", R"("pressure")"),
               ContainsSubstring("'contact' has nothing to measure: the field 'pressure' is the same on both sides"));
    CHECK_THAT(refusal_of_tube("/scene/p_L", "0.1"), ContainsSubstring("no shock at t = 1"));
    CHECK_THAT(refusal_of_tube("/measure/over", R"("maximum")"), ContainsSubstring("needs 'over' to be 'final'"));
}

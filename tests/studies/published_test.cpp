// Published tables, through the whole engine: every printed digit.
#include <sstream>

#include "reports/gate/compare.hpp"
#include "reports/table/table.hpp"
#include "studies/engine/engine.hpp"
#include "studies/engine/judge.hpp"
#include "studies/reader/json_input.hpp"
#include "studies/reader/study_reader.hpp"
#include "tests/catch.hpp"

using namespace ordo::studies;

namespace {

const std::string folder = std::string(ORDO_SOURCE_DIR) + "/studies/wobbes_tielen_2015/";

Result run_study(const std::string& file, const std::vector<Setting>& settings = {}) {
    const Study study = read_study(folder + file, settings);
    return judged(study, run_all(study, {.jobs = 2, .progress = {}}));
}

int agreeing(const Result& result) {
    int count = 0;
    for (const auto& match : result.published) count += match.agrees;
    return count;
}

double work(const Run& run, const std::string& name) {
    for (const auto& figure : run.work) {
        if (figure.name == name) return figure.value;
    }
    return -1;
}

}  // namespace

TEST_CASE("table A1: 30 values to every printed digit", "[published]") {
    const Result result = run_study("vibrating_bar.json");
    CHECK(result.published.size() == 30);
    CHECK(agreeing(result) == 30);
    CHECK(result.verdict == Verdict::pass);
}

TEST_CASE("the table in the README is the one that the study gives", "[published]") {
    const ordo::reports::Report report{run_study("vibrating_bar.json"), {}};
    const std::string readme = read_text(std::string(ORDO_SOURCE_DIR) + "/README.md");
    std::istringstream table(ordo::reports::table(report, ordo::reports::TableFormat::markdown));
    int rows = 0;
    for (std::string line; std::getline(table, line);) {
        if (line.rfind("| ", 0) != 0) continue;
        ++rows;
        CHECK_THAT(readme, ContainsSubstring(line));
    }
    CHECK(rows == 10);  // head, rule and eight meshes
}

TEST_CASE("table B1: 15 values to every printed digit", "[published]") {
    const Result result = run_study("vibrating_bar_fixed.json");
    CHECK(result.published.size() == 15);
    CHECK(agreeing(result) == 15);
    CHECK(result.verdict == Verdict::pass);
    // Crossings as counted independently: none up to 64 cells with 4 and 6 particles a cell, 15 with 8.
    for (const auto& run : result.runs) {
        const bool last = run.axis("cells") == 64 && run.axis("ppc") == 8;
        CHECK(work(run, "cell_crossings") == (last ? 15 : 0));
    }
}

TEST_CASE("the digits of table A1 hang on every choice that the study names", "[alarm]") {
    const auto [setting, least_lost] = GENERATE(table<std::string, int>({
        {"scene.law=E(F-1)", 20},                            // another law
        {"solvers.0.stress_update=usl", 20},                 // without re-mapping
        {"solvers.0.position_update=accelerated", 20},       // particles follow the velocity before re-mapping
        {"solvers.0.placement=cell_centred", 20},            // all but 1 ppc, where both placements are the same
        {"solvers.0.strain_increment=undeformed_mesh", 20},  // strain from the mesh before its move
        {"solvers.0.volume=fixed", 20},
        {"solvers.0.beyond_grid=extend", 5},  // only where particles pass the end of their grid
        {"measure.at=500", 28},               // the announced time
    }));
    CAPTURE(setting);
    const Result result = run_study("vibrating_bar.json", {setting_from(setting)});
    CHECK(30 - agreeing(result) >= least_lost);
    CHECK(result.verdict == Verdict::fail);
}

TEST_CASE("the bar in dt: second order against the finest step where a(0) = 0", "[convergence]") {
    CHECK(run_study("vibrating_bar_dt.json").verdict == Verdict::pass);
    CHECK(run_study("vibrating_bar_dt_small.json").verdict == Verdict::pass);
}

TEST_CASE("the flagship study is as accepted", "[published]") {
    const ordo::reports::Report report{run_study("vibrating_bar.json"), {}};
    const std::string path =
        ordo::reports::baseline_path(std::string(ORDO_SOURCE_DIR) + "/reports/baseline", report.result.study.name);
    const auto checks = ordo::reports::checks_against(report, ordo::reports::read_baseline(path));
    CHECK(checks.size() >= 2);
    for (const auto& check : checks) {
        CAPTURE(check.found);
        CHECK(check.verdict == Verdict::pass);
    }
}

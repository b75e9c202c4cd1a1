// What compares methods in the figures against cost: bars, front, crossovers, errors asked for; and the board.
#include <cmath>

#include "core/error.hpp"
#include "reports/plot/board.hpp"
#include "reports/plot/plot.hpp"
#include "tests/catch.hpp"
#include "tests/reports/cost/race.hpp"
#include "tests/reports/plot/blocks.hpp"

using namespace ordo;
using namespace ordo::reports;
using samples::block_of;
using samples::numbers_of;
using samples::race;

namespace {

std::string script_of(const Report& report, Cost cost, const std::vector<double>& errors = {}) {
    return figures(report, PlotFormat::svg, cost, errors).at(0).script;
}

}  // namespace

TEST_CASE("cost plot: repeated times have bars of their spread, and the heading says how often", "[unit]") {
    auto report = race();
    CHECK(block_of(script_of(report, Cost::time), "bars0").empty());
    for (auto& run : report.result.runs) run.repeats = studies::Repeats{run.id == 2 ? 9 : 5, 0.25};
    report.result.runs[1].repeats = studies::Repeats{};  // once: no spread
    const std::string script = script_of(report, Cost::time);
    const auto bars = numbers_of(block_of(script, "bars0"));
    REQUIRE(bars.size() == 3);
    CHECK(bars[0][0] == 0.002);
    CHECK(bars[0][2] == Approx(0.0015));
    CHECK(bars[0][3] == Approx(0.0025));
    CHECK_THAT(script, ContainsSubstring("$bars0 using 1:2:3:4 with xerrorbars") &&
                           ContainsSubstring("medians of 1 to 9 samples (bars: spread)"));
    CHECK(block_of(script_of(report, Cost::work), "bars0").empty());
}

TEST_CASE("cost plot: the front, the ring where the lead changes, and the exponents", "[unit]") {
    const std::string script = script_of(race(), Cost::time);
    const auto front = numbers_of(block_of(script, "front"));
    REQUIRE(front.size() == 4);
    CHECK(front[1][0] == 0.008);
    CHECK(front[1][1] == Approx(1.25));
    CHECK(front[2][1] == Approx(1e-4 / 0.032 / 0.032));
    const auto ring = numbers_of(block_of(script, "crossovers"));
    REQUIRE(ring.size() == 1);
    CHECK(ring[0][0] == Approx(0.01));
    CHECK(ring[0][1] == Approx(1));
    CHECK_THAT(script, ContainsSubstring("ring at 0.01 s, error 1: up to there mpm a, from there mpm b"));
    CHECK_THAT(script, ContainsSubstring("title 'mpm a: error ~ 1/time^1.000 [") &&
                           ContainsSubstring("title 'mpm b: error ~ 1/time^2.000 ["));
    CHECK_THAT(script_of(race(), Cost::work), ContainsSubstring("ring at 5e+02, error 1:"));
}

TEST_CASE("cost plot: errors asked for are lines, met between runs and never beyond", "[unit]") {
    const std::string script = script_of(race(), Cost::time, {0.5, 1e-9});
    CHECK(numbers_of(block_of(script, "level0")).at(0).at(1) == 0.5);
    CHECK(block_of(script, "level1").empty());  // below the picture
    const auto reached = numbers_of(block_of(script, "reached"));
    REQUIRE(reached.size() == 2);
    CHECK(reached[0][0] == Approx(0.02));
    CHECK(reached[1][0] == Approx(std::sqrt(2e-4)));
    CHECK_THAT(script, ContainsSubstring("error 0.5 (2 of 2 reach it): mpm b 0.014 s, mpm a 0.02 s") &&
                           ContainsSubstring("error 1e-09 (0 of 2 reach it)'"));
}

TEST_CASE("cost plot: counts of different things are not compared", "[unit]") {
    auto report = race();
    for (auto& run : report.result.runs) {
        if (run.solver == "mpm b") run.work = {{"element_steps", 3}};
    }
    const std::string script = script_of(report, Cost::work, {0.5});
    CHECK(block_of(script, "front").empty());
    CHECK(block_of(script, "crossovers").empty());
    CHECK(script.find("ring at") == std::string::npos);
}

TEST_CASE("board: a panel a report, one style a label, one legend", "[unit]") {
    auto other = race();
    other.result.study.name = "folder/other";
    const Board board = board_of({race(), other}, Cost::time);
    CHECK(board.labels == std::vector<std::string>{"mpm a", "mpm b"});
    REQUIRE(board.panels.size() == 2);
    CHECK(board.panels[1].heading == "other: displacement.rms");
    CHECK(board.panels[1].styles == board.panels[0].styles);
    const std::string script = reports::board({race(), other}, PlotFormat::svg, Cost::time).script;
    CHECK(numbers_of(block_of(script, "points1_0")).size() == 4);
    CHECK(numbers_of(block_of(script, "front0")).size() == 4);
    CHECK(script.find("below: ") == std::string::npos);
    for (auto& run : other.result.runs) run.errors[0].value *= run.solver == "mpm b" ? 1e-13 : 1;
    CHECK_THAT(reports::board({race(), other}, PlotFormat::svg, Cost::time).script,
               ContainsSubstring("set label 3 'below: mpm b from 2e-03'"));
    auto without = race();
    for (auto& run : without.result.runs) run.seconds = 0;
    CHECK_THROWS_AS(reports::board({race(), without}, PlotFormat::svg, Cost::time), InputError);
}

#include "reports/plot/cost.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "reports/plot/plot.hpp"
#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/reports/plot/blocks.hpp"
#include "tests/reports/sample.hpp"

using namespace ordo;
using namespace ordo::reports;
using samples::block_of;
using samples::numbers_of;
using Rows = std::vector<std::vector<double>>;

namespace {

/// The sample with costs by hand: run i takes 2^-i s; mpm counts 100 (i + 1) particle steps and fem 10 element steps.
Report costly() {
    auto report = samples::sample();
    double seconds = 1;
    for (auto& run : report.result.runs) {
        run.seconds = seconds;
        seconds /= 2;
        const double count = 100.0 * (run.id + 1);
        if (run.solver == "mpm") run.work = {{"steps", 7}, {"particle_steps", count}, {"cell_crossings", 3}};
        else run.work = {{"steps", 7}, {"element_steps", 10}};
    }
    report.provenance.jobs = 2;
    report.provenance.cpu = "abacus";
    return report;
}

std::string script_of(const Report& report, Cost cost) { return figures(report, PlotFormat::svg, cost).at(0).script; }

studies::Run counting(std::vector<studies::RunFigure> work) {
    studies::Run run;
    run.work = std::move(work);
    return run;
}

}  // namespace

TEST_CASE("cost plot: the points are thread time and error, coarse to fine; who has no error has no point", "[unit]") {
    const std::string script = script_of(costly(), Cost::time);
    CHECK(numbers_of(block_of(script, "points0")) ==
          Rows{{1, 0.09, 1}, {0.5, 0.01, 1}, {0.25, 0.01 / 9, 1}, {0.125, 5e-4, 1}, {}});
    CHECK(numbers_of(block_of(script, "points1")) == Rows{{1.0 / 32, 0.027, 1}, {}, {1.0 / 128, 1e-3, 1}});
    CHECK_THAT(script, ContainsSubstring("$points0 using 1:2 with lines linewidth 1 dashtype 1 "));  // solid
    CHECK(block_of(script, "fit0_0").empty());  // an order is in h, not in seconds
    CHECK(script.find("triangle") == std::string::npos);
}

TEST_CASE("cost plot: work is what the solver counts", "[unit]") {
    const std::string script = script_of(costly(), Cost::work);
    CHECK(numbers_of(block_of(script, "points0")) ==
          Rows{{100, 0.09, 1}, {200, 0.01, 1}, {300, 0.01 / 9, 1}, {400, 5e-4, 1}, {}});
    CHECK(numbers_of(block_of(script, "points1")) == Rows{{10, 0.027, 1}, {}, {10, 1e-3, 1}});
    CHECK(counted_in(counting({{"steps", 1}, {"particle_steps", 2}, {"iterations", 3}})) == "particle_steps");
    CHECK(counted_in(counting({{"steps", 1}, {"iterations", 3}})) == "iterations");
    CHECK(counted_in(counting({{"cell_crossings", 1}, {"steps", 2}})) == "steps");
    CHECK(counted_in(counting({{"steps", 2}, {"cell_updates", 200}})) == "cell_updates");
    CHECK(counted_in(counting({{"unions", 2}, {"chop_outs", 3}})) == "chop_outs");
    CHECK(counted_in(counting({{"cell_crossings", 1}})).empty());
    CHECK(std::isnan(cost_of(counting({{"cell_crossings", 1}}), Cost::work)));
}

TEST_CASE("cost plot: axes and legend say what the cost is, and whose", "[unit]") {
    auto report = costly();
    const std::string time = script_of(report, Cost::time);
    CHECK_THAT(time, ContainsSubstring("set xlabel 'thread time [s], one machine, this run' noenhanced\n"));
    CHECK_THAT(time, ContainsSubstring("set ylabel 'RMS error of displacement [m]' noenhanced\n"));
    CHECK_THAT(time,
               ContainsSubstring("title 'each run once, set-up included, measuring of errors not; 2 jobs; abacus'"));
    CHECK_THAT(time, ContainsSubstring(" title 'mpm: 1 run diverged'"));
    CHECK_THAT(time, ContainsSubstring(" title 'fem: 1 error zero or not finite'"));
    const std::string mixed = script_of(report, Cost::work);
    CHECK_THAT(mixed,
               ContainsSubstring("set xlabel 'counted work, not the same for all: see the legend' noenhanced\n"));
    CHECK_THAT(mixed, ContainsSubstring(" title 'mpm [particle steps]: error ~ 1/work^") &&
                          ContainsSubstring("]; 1 run diverged'"));
    CHECK_THAT(mixed, ContainsSubstring(" title 'fem [element steps]: 1 error zero or not finite'"));
    for (auto& run : report.result.runs) run.work = {{"particle_steps", 5.0}};
    const std::string alike = script_of(report, Cost::work);
    CHECK_THAT(alike, ContainsSubstring("set xlabel 'counted work [particle steps]' noenhanced\n"));
    CHECK_THAT(alike, ContainsSubstring(" title 'mpm: 1 run diverged'"));
}

TEST_CASE("cost plot: a run that diverged does not make the units differ", "[unit]") {
    auto report = costly();
    for (auto& run : report.result.runs) run.work = {{"particle_steps", 5.0}};
    report.result.runs[4].work = {{"steps", 5.0}};  // it has no point
    CHECK_THAT(script_of(report, Cost::work), ContainsSubstring("set xlabel 'counted work [particle steps]'"));
}

TEST_CASE("cost plot: all series of a quantity share one figure, whatever they refine", "[unit]") {
    auto report = costly();
    report.result.series[1].abscissa = report.result.series[1].shown = "dt";
    CHECK(figures(report, PlotFormat::svg).size() == 2);
    for (const Cost cost : {Cost::time, Cost::work}) {
        const auto all = figures(report, PlotFormat::svg, cost);
        REQUIRE(all.size() == 1);
        CHECK(all[0].name == "sample_bar-displacement.rms-" + std::string(cost == Cost::time ? "time" : "work"));
        CHECK(numbers_of(block_of(all[0].script, "points1")).size() == 3);
    }
}

TEST_CASE("cost plot: a time that is zero, negative or not finite is left out and named", "[alarm]") {
    const double bad =
        GENERATE(0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
    auto report = costly();
    report.result.runs[1].seconds = bad;
    std::string script = script_of(report, Cost::time);
    CHECK(numbers_of(block_of(script, "points0")).at(1).empty());
    CHECK_THAT(script, ContainsSubstring("title 'mpm: 1 run diverged; 1 run without a time above zero: cells = 9'"));
    report.result.runs[3].seconds = bad;
    report.result.runs[4].seconds = bad;  // it diverged, which is told already
    script = script_of(report, Cost::time);
    CHECK_THAT(script, ContainsSubstring("; 2 runs without a time above zero: cells = 9, 81'"));
    CHECK_THAT(script_of(report, Cost::work), !ContainsSubstring("without"));
}

TEST_CASE("cost plot: a run that counts nothing, or zero, is left out and named", "[alarm]") {
    auto report = costly();
    SECTION("nothing") { report.result.runs[0].work.clear(); }
    SECTION("nothing known") { report.result.runs[0].work = {{"cell_crossings", 3}}; }
    SECTION("zero") { report.result.runs[0].work = {{"particle_steps", 0}}; }
    const std::string script = script_of(report, Cost::work);
    CHECK(numbers_of(block_of(script, "points0")).at(0).empty());
    CHECK_THAT(script,
               ContainsSubstring("'mpm [particle steps]: 1 run diverged; 1 run without counted work: cells = 3'"));
}

TEST_CASE("cost plot: a report without a single cost is refused", "[alarm]") {
    auto report = costly();
    for (auto& run : report.result.runs) run.seconds = run.status == studies::Status::diverged ? 1 : 0;
    CHECK_THROWS_AS(figures(report, PlotFormat::svg, Cost::time), InputError);
    CHECK_THROWS_WITH(figures(report, PlotFormat::svg, Cost::time),
                      ContainsSubstring("sample/bar: ") && ContainsSubstring("time above zero"));
    CHECK_NOTHROW(figures(report, PlotFormat::svg, Cost::work));
    for (auto& run : report.result.runs) run.work = {{"cell_crossings", 3}};
    CHECK_THROWS_WITH(figures(report, PlotFormat::svg, Cost::work), ContainsSubstring("counts steps or iterations"));
    report.result.runs[0].seconds = 1;
    CHECK_NOTHROW(figures(report, PlotFormat::svg, Cost::time));
}

TEST_CASE("cost plot: where every run stopped there is an empty figure that says so", "[unit]") {
    auto report = costly();
    for (auto& run : report.result.runs) run.status = studies::Status::timed_out;
    CHECK_THAT(script_of(report, Cost::time),
               ContainsSubstring("set label 'no run has a finite, positive error and a time above zero'"));
    CHECK_THAT(script_of(report, Cost::work),
               ContainsSubstring("set label 'no run has a finite, positive error and counted work'"));
}

TEST_CASE("cost plot: hostile names of figures, axes and processors are drawn and not obeyed", "[cli]") {
    const outside::Folder folder;
    const std::string hostile = "`touch seen` 'q\" $(touch seen) \nEOD\nsystem('touch seen') . '";
    auto report = costly();
    report.provenance.cpu = hostile;
    for (auto& run : report.result.runs) {
        run.work = {{hostile + run.solver + "_steps", 4.0 * (run.id + 1)}};
        run.axes[0].name = hostile;
    }
    report.result.runs[0].seconds = 0;
    report.result.runs[0].work[0].value = 0;
    for (auto& series : report.result.series) series.shown = hostile;
    const Cost cost = GENERATE(Cost::time, Cost::work);
    const std::string script = script_of(report, cost);
    folder.write("hostile.gp", script);
    const auto outcome = outside::run({"gnuplot", "-e", "output = 'hostile.svg'", "hostile.gp"}, folder.here());
    CHECK(outcome.code == 0);
    CHECK(outcome.err == "");
    CHECK(folder.names() == std::vector<std::string>{"hostile.gp", "hostile.svg"});
    CHECK_THAT(folder.read("hostile.svg"), ContainsSubstring("$(touch seen)"));
    CHECK(block_of(script, "points0").find_first_not_of("0123456789.e- \n") == std::string::npos);
}

// Lines of refinement, against h, against counted work, and where solvers refine widths of different names.
#include <cmath>

#include "studies/engine/judge.hpp"
#include "tests/catch.hpp"
#include "tests/studies/planned_runs.hpp"
#include "tests/studies/sample_study.hpp"

using namespace ordo;
using namespace ordo::studies;
using ordo::tests::planned_runs;
using ordo::tests::second_order;
using ordo::tests::study_of;
using ordo::tests::with;

namespace {

Verdict verdict_of(const Study& study, const std::vector<Run>& runs) { return judged(study, runs).verdict; }

/// The sample with orders against h and against counted steps, of which each run takes 2 / h.
Study counting_study(const std::string& against) {
    auto document = with("/measure/orders_against", R"(["h", "1/steps"])");
    document["expect"][0]["against"] = against;
    return study_of(document);
}

std::vector<Run> counting_runs(const Study& study) {
    auto runs = planned_runs(study, second_order);
    for (auto& run : runs) run.work = {{"steps", 2 / (run.h * run.h)}};
    return runs;
}

}  // namespace

TEST_CASE("an order against counted work is fitted against one over it", "[unit]") {
    const Study study = counting_study("h");
    const Result result = judged(study, counting_runs(study));
    REQUIRE(result.series.size() == 2);
    CHECK(result.series[1].abscissa == "1/steps");
    CHECK(result.series[1].shown == "steps");
    CHECK(result.series[1].runs == result.series[0].runs);
    REQUIRE(result.fits.size() == 2);
    CHECK(result.fits[0].outcome.fit->order == Approx(2).epsilon(1e-12));
    CHECK(result.fits[1].abscissa == "1/steps");
    CHECK(result.fits[1].outcome.fit->order == Approx(1).epsilon(1e-12));  // steps grow as 1 / h^2
    CHECK(result.verdict == Verdict::pass);
    REQUIRE(result.checks.size() == 2);  // all runs end; the order against h, and no other
}

TEST_CASE("a counter that no run has is no abscissa", "[alarm]") {
    const Study study = counting_study("h");
    auto runs = counting_runs(study);
    for (auto& run : runs) run.work = {{"step", 1}};
    const Result result = judged(study, runs);
    CHECK(result.verdict == Verdict::fail);
    CHECK(result.checks[1].claim == "orders against 1/steps");
    CHECK_THAT(result.checks[1].found, ContainsSubstring("counted are 1/step"));
}

TEST_CASE("an expectation speaks of the abscissa that it names", "[alarm]") {
    const Study study = counting_study("1/steps");
    auto runs = counting_runs(study);
    CHECK(verdict_of(study, runs) == Verdict::fail);  // order 1, not 2
    for (auto& run : runs) run.work = {{"steps", 2 / run.h}};
    CHECK(verdict_of(study, runs) == Verdict::pass);
    CHECK_THAT(judged(study, runs).checks[1].claim, ContainsSubstring("order 2 +- 0.1 against 1/steps"));
    runs[1].work.clear();  // two points are left, which prove nothing
    CHECK(verdict_of(study, runs) == Verdict::inconclusive);
    CHECK(judged(study, runs).fits[1].left_out.at(0).why == "it counts no 'steps'");
    for (auto& run : runs) run.work = {{"chop_outs", 1}};
    CHECK(verdict_of(study, runs) == Verdict::fail);
    for (auto& run : runs) run.work = {{"steps", 0}};
    CHECK(verdict_of(study, runs) == Verdict::fail);
}

TEST_CASE("an order that no series shows fails", "[alarm]") {
    Study study = counting_study("h");
    study.expect[0].against = "1/chop_outs";
    const Result result = judged(study, counting_runs(study));
    CHECK(result.verdict == Verdict::fail);
    CHECK(result.checks[1].found == "no series");
}

TEST_CASE("a bound is checked once, whatever orders are against", "[unit]") {
    auto document = with("/measure/orders_against", R"(["h", "1/steps"])");
    document["expect"] = {{{"error_at_most", 1}, {"source", "test"}}};
    const Study study = study_of(document);
    CHECK(judged(study, counting_runs(study)).checks.size() == 2);
}

TEST_CASE("solvers that refine widths of different names have a line each, by their own", "[unit]") {
    Study study = study_of(with("/expect", "[]"));
    study.solvers = {{"mpm", {}, "mpm"}, {"root_finding", {}, "iterated"}};
    study.sweep.axes = {{"cells", {4, 8}}, {"iterations", {1, 2, 3}}};
    std::vector<Run> runs;
    const auto add = [&](const std::string& solver, const std::string& axis, double value) {
        Run run;
        run.id = static_cast<int>(runs.size());
        run.solver = solver;
        run.axes = {{axis, value}};
        run.h = 1 / value;
        runs.push_back(run);
    };
    for (const double cells : {4, 8}) add("mpm", "cells", cells);
    for (const double iterations : {3, 1, 2}) add("iterated", "iterations", iterations);
    const auto lines = series_of(study, runs);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].label == "mpm");
    CHECK(lines[0].shown == "cells");
    CHECK(lines[0].runs == std::vector<int>{0, 1});
    CHECK(lines[1].label == "iterated");
    CHECK(lines[1].shown == "iterations");
    CHECK(lines[1].runs == std::vector<int>{3, 4, 2});
}

TEST_CASE("an order against a swept axis refines that axis alone", "[unit]") {
    auto document = with("/measure/orders_against", R"(["h", "1/ppc", "ppc"])");
    document["sweep"]["ppc"] = {1, 2, 4};
    document["expect"] = {{{"order", 3}, {"within", 0.1}, {"against", "1/ppc"}, {"source", "made by hand"}}};
    const Study study = study_of(document);
    auto runs = planned_runs(study, second_order);
    for (auto& run : runs) run.errors[0].value = run.h / std::pow(run.axis("ppc"), 3);
    const Result result = judged(study, runs);
    REQUIRE(result.series.size() == 9);  // three lines along h, three along ppc, twice
    CHECK(result.series[3].label == "cells = 4");
    CHECK(result.series[3].abscissa == "1/ppc");
    CHECK(result.series[3].shown == "ppc");
    CHECK(result.fits[0].outcome.fit->order == Approx(1).epsilon(1e-12));
    CHECK(result.fits[3].outcome.fit->order == Approx(3).epsilon(1e-12));
    CHECK(result.fits[6].outcome.fit->order == Approx(-3).epsilon(1e-12));
    CHECK(result.verdict == Verdict::pass);  // the claim speaks of 1/ppc alone
    for (auto& run : runs) run.errors[0].value = run.h / run.axis("ppc");
    CHECK(verdict_of(study, runs) == Verdict::fail);
}

TEST_CASE("a coupling takes dt from the real h of each mesh", "[unit]") {
    auto document = with("/sweep", R"({"cells": [4, 8, 16], "coupling": {"dt": 1e-3, "power": 2}, "path": "joint"})");
    const Study study = study_of(document);
    const auto runs = planned_runs(study, second_order);
    REQUIRE(runs.size() == 3);
    for (const auto& run : runs) {
        REQUIRE(run.axes.back().name == "dt");  // as planned; the step taken ends exactly at t
        CHECK(run.axes.back().value == Approx(1e-3 * run.h * run.h).epsilon(1e-14));
    }
    CHECK(runs[0].h == 25.0 / 4);
    CHECK(judged(study, runs).verdict == Verdict::pass);
    document["sweep"]["dt"] = {0.1, 0.2, 0.3};
    CHECK_THROWS_WITH(study_of(document), ContainsSubstring("/sweep/coupling: gives the step"));
}

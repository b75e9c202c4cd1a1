#pragma once
// A small report made by hand, to be read beside the tests. Cells are refined by three.
//
//   cells      3      9          27         81       243        fitted
//   mpm     9.0e-02 1.0e-02  1.1111e-03    5e-04   diverged    3, 9, 27: 0.81 h^2
//   fem     2.7e-02   NaN      1e-03          (not run)        refused
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "reports/report.hpp"

namespace ordo::samples {

using namespace ordo::studies;

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline const std::string rms = "displacement.rms";

inline Run run_on(double cells, const std::string& solver, double error) {
    Run run;
    run.solver = solver;
    run.axes = {{"cells", cells}};
    run.h = 1 / cells;
    run.dt = 1e-3;
    run.t = 0.5;
    run.errors = {{rms, error}};
    return run;
}

inline std::vector<Run> sample_runs() {
    std::vector<Run> runs{run_on(3, "mpm", 0.09),  run_on(9, "mpm", 0.01),  run_on(27, "mpm", 0.01 / 9),
                          run_on(81, "mpm", 5e-4), run_on(243, "mpm", nan), run_on(3, "fem", 0.027),
                          run_on(9, "fem", nan),   run_on(27, "fem", 1e-3)};
    for (std::size_t i = 0; i < runs.size(); ++i) runs[i].id = static_cast<int>(i);
    runs[4].status = Status::diverged;
    runs[4].reason = "a speed above 1e3 m/s";
    return runs;
}

inline Study sample_study() {
    Study study;
    study.name = "sample/bar";
    study.about = "Made by hand.";
    study.sweep.axes = {{"cells", {3, 9, 27, 81, 243}}};
    study.measure.at = 0.5;
    study.measure.fields = {"displacement"};
    study.measure.quantities = {Quantity{"displacement"}};
    Expectation order;
    order.value = 2;
    order.within = 0.1;
    order.where = {{"cells", "<=", 27}};
    order.solvers = {"mpm"};
    study.expect = {order};
    Published table;
    table.id = "T1";
    table.solver = "mpm";
    table.quantity = rms;
    study.published = {table};
    return study;
}

inline studies::FitOutcome converged(OrderFit fit) {
    return {.fit = std::move(fit), .verdict = studies::Convergence::converges, .reason = "power law", .left_out = {}};
}

inline studies::FitOutcome refused(const std::string& why, studies::Refusal refusal) {
    return {.fit = {}, .reason = why, .refusal = refusal, .left_out = {}};
}

inline reports::Report sample() {
    Result result;
    result.study = sample_study();
    result.runs = sample_runs();
    result.series = {{"mpm", "h", "cells", {0, 1, 2, 3, 4}}, {"fem", "h", "cells", {5, 6, 7}}};
    const auto fit =
        converged({.order = 2, .low = 1.98, .high = 2.02, .coefficient = 0.81, .correlation = 1, .neighbours = {2, 2}});
    result.fits = {{"mpm", rms, "cells <= 27", {0, 1, 2}, {{3, "outside"}, {4, "outside"}}, fit},
                   {"fem", rms, "", {5, 6, 7}, {}, refused("the error is nan", studies::Refusal::is_nan)}};
    result.published = {{"T1", 0, "9.0e-02", 0.09, "9.0e-02", true, true},
                        {"T1", 1, "1.1e-02", 0.01, "1.0e-02", false, true},
                        {"T1", -1, "7e-07", nan, "", false, true}};
    result.checks = {{"order 2 +- 0.1", "mpm", "", Verdict::pass, "2.000"}};
    result.verdict = Verdict::fail;
    return {result, {}};
}

/// The time step instead of the mesh is refined; the steps taken are not the steps asked for.
inline reports::Report time_sample() {
    reports::Report report = sample();
    Result& result = report.result;
    result.study.sweep = {{{"dt", {0.3, 0.1}}}, Path::time};
    result.study.measure.quantities = {Quantity{"velocity", Norm::l2}};
    result.runs = {run_on(4, "mpm", 0), run_on(4, "mpm", 0)};
    const std::vector<std::pair<double, double>> steps{{0.3, 0.25}, {0.1, 0.0625}};  // asked, taken
    for (std::size_t i = 0; i < steps.size(); ++i) {
        Run& run = result.runs[i];
        run.id = static_cast<int>(i);
        run.axes = {{"dt", steps[i].first}};
        run.dt = steps[i].second;
        run.errors = {{"velocity.l2", 3 * std::pow(run.dt, 1.5)}};
    }
    result.series = {{"mpm", "dt", "dt", {0, 1}}};
    result.fits.clear();
    result.published.clear();
    return report;
}

/// The sample with orders against h and counted replacements too; fem counts none, and neither does what diverged.
inline reports::Report counting_sample() {
    reports::Report report = sample();
    Result& result = report.result;
    for (auto& run : result.runs) {
        if (run.solver == "mpm" && run.status == Status::ok) run.work = {{"chop_outs", 10 / run.h}};
    }
    const auto own = result.series;
    for (const auto& series : own) result.series.push_back({series.label, "1/chop_outs", "chop_outs", series.runs});
    const auto fit =
        converged({.order = 1, .low = 0.9, .high = 1.1, .coefficient = 0.5, .correlation = 1, .neighbours = {1, 1}});
    result.fits.push_back({"mpm", rms, "", {0, 1, 2, 3}, {{4, "diverged: "}}, fit, "1/chop_outs"});
    const LeftOut none{5, "it counts no 'chop_outs'"};
    result.fits.push_back(
        {"fem", rms, "", {}, {none}, refused("fewer than two points", studies::Refusal::too_few), "1/chop_outs"});
    return report;
}

/// Two solvers that refine widths of different names: one counts cells, the other iterations.
inline reports::Report mixed_sample() {
    reports::Report report = sample();
    Result& result = report.result;
    result.study.solvers = {{"mpm", {}, "mpm"}, {"root_finding", {}, "fem"}};
    for (auto& run : result.runs) {
        if (run.solver == "fem") run.axes[0].name = "iterations";
    }
    result.series[1].shown = "iterations";
    return report;
}

}  // namespace ordo::samples

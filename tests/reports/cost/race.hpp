#pragma once
// A report of two methods on power laws: what each costs and reaches is known by hand.
#include <cmath>

#include "tests/reports/samples.hpp"

namespace ordo::samples {

/// "mpm a" and "mpm b" at 4, 8, 16, 32 cells, which cost 2 ms, 8, 32, 128 of thread time and 100, 400, ... particle
/// steps; the error of the first is 1e-2 s / t, of the second 1e-4 s^2 / t^2. Nothing is run.
inline reports::Report race() {
    auto document = study();
    document["study"] = "race";
    document["solvers"] = Json::parse(
        R"([{ "name": "mpm", "label": "mpm a" }, { "name": "mpm", "label": "mpm b", "stress_update": "usl" }])");
    document["sweep"] = Json::parse(R"({ "cells": [4, 8, 16, 32], "ppc": 2, "dt": 0.01, "path": "space" })");
    document["expect"] = Json::array();
    std::vector<studies::Run> runs;
    for (const int method : {0, 1}) {
        for (int k = 0; k < 4; ++k) {
            studies::Run run;
            run.id = static_cast<int>(runs.size());
            run.solver = method == 0 ? "mpm a" : "mpm b";
            const double cells = 4 * std::pow(2, k);
            run.axes = {{"cells", cells}, {"ppc", 2}, {"dt", 0.01}};
            run.h = 25 / cells;
            run.dt = 0.01;
            run.t = 0.2;
            const double seconds = 2e-3 * std::pow(4, k);
            run.work = {{"particle_steps", 100 * std::pow(4, k)}};
            run.errors = {{"displacement.rms", method == 0 ? 1e-2 / seconds : 1e-4 / seconds / seconds}};
            runs.push_back(run);
        }
    }
    auto report = report_of(document, std::move(runs));
    for (auto& run : report.result.runs) run.seconds = 2e-3 * std::pow(4, run.id % 4);
    return report;
}

}  // namespace ordo::samples

// A run that has blown up stops within a bounded number of steps, however many are planned.
#include "core/text.hpp"
#include "studies/engine/run.hpp"
#include "tests/catch.hpp"
#include "tests/studies/sample_study.hpp"

using namespace ordo;
using namespace ordo::studies;

namespace {

/// Eight times the limit of stability, 5e5 steps to go.
RunSpec unstable(const std::string& solver) {
    auto document = tests::with("/sweep", R"({"cells": 50, "dt": 0.4, "path": "space"})");
    document["solvers"] = Json::parse(solver);
    document["measure"]["at"] = 2e5;
    document["expect"] = Json::array();
    return specs_of(tests::study_of(document)).front();
}

}  // namespace

TEST_CASE("a run that blows up stops at once", "[alarm]") {
    const std::string solver =
        GENERATE(as<std::string>{}, R"({"name": "mpm"})", R"({"name": "mpm", "stress_update": "usl"})",
                 R"({"name": "mpm", "frame": "total"})",
                 R"({"name": "mpm", "basis": "quadratic", "mass": "consistent"})", R"({"name": "fem"})");
    INFO(solver);
    long steps = 0;
    const auto counts = [&] {
        ++steps;
        return false;
    };
    const RunSpec spec = unstable(solver);
    const Run run = executed(spec, counts).run;
    CHECK(run.status == Status::diverged);
    // The shortest wave grows at least twofold a step: from round-off, 1e-16 of a cell, to a cell in some 60 of them.
    CHECK(steps < 100);
    CHECK(run.seconds < 1);
}

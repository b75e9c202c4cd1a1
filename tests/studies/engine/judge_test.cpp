// From runs to verdicts, on runs made by hand.
#include "studies/engine/judge.hpp"

#include <cmath>

#include "studies/engine/run.hpp"
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

Study published_study(const std::string& compare, const std::string& value) {
    return study_of(with("/published", R"json({"compare": )json" + compare + R"json(, "table": {"id": "T", "title": "t",
        "source": "WobbesTielen2015", "quantity": "displacement.rms", "rows": [{"cells": 4, "value": ")json" +
                                           value + "\"}]}}"));
}

}  // namespace

TEST_CASE("our value is written with the digits that the paper printed", "[unit]") {
    CHECK(as_printed("3.6e-03", 3.5828e-3) == "3.6e-03");
    CHECK(as_printed("1.2918e-03", 1.29183e-3) == "1.2918e-03");
    CHECK(as_printed("1.84724e-05", 1.8472399e-5) == "1.84724e-05");
    CHECK(as_printed("0.04798", 0.047981) == "0.04798");
    CHECK(as_printed("-1.44", -1.436) == "-1.44");
}

TEST_CASE("a study whose runs do as expected passes", "[unit]") {
    const Study study = study_of(tests::sample_document());
    const Result result = judged(study, planned_runs(study, second_order));
    CHECK(result.verdict == Verdict::pass);
    REQUIRE(result.series.size() == 1);
    CHECK(result.series[0].runs == std::vector<int>{0, 1, 2});
    REQUIRE(result.fits.size() == 1);
    REQUIRE(result.fits[0].outcome.fit);
    CHECK(result.fits[0].outcome.fit->order == Approx(2).epsilon(1e-12));
}

TEST_CASE("the gate rings for every way in which runs can be wrong", "[alarm]") {
    const Study study = study_of(tests::sample_document());
    auto runs = planned_runs(study, second_order);
    REQUIRE(verdict_of(study, runs) == Verdict::pass);

    SECTION("order too low") {
        CHECK(verdict_of(study, planned_runs(study, [](double h) { return h; })) == Verdict::fail);
    }
    SECTION("order too high") {
        CHECK(verdict_of(study, planned_runs(study, [](double h) { return h * h * h; })) == Verdict::fail);
    }
    SECTION("errors grow") {
        CHECK(verdict_of(study, planned_runs(study, [](double h) { return 1 / (h * h); })) == Verdict::fail);
    }
    SECTION("NaN") {
        runs[1].errors[0].value = std::nan("");
        CHECK(verdict_of(study, runs) == Verdict::fail);
    }
    SECTION("infinity") {
        runs[1].errors[0].value = INFINITY;
        CHECK(verdict_of(study, runs) == Verdict::fail);
    }
    SECTION("zero") {
        runs[1].errors[0].value = 0;
        CHECK(verdict_of(study, runs) == Verdict::fail);
    }
    SECTION("no error at all") {
        runs[1].errors.clear();
        CHECK(verdict_of(study, runs) == Verdict::fail);
    }
    SECTION("diverged") {
        runs[2].status = Status::diverged;
        CHECK(verdict_of(study, runs) == Verdict::fail);
    }
    SECTION("failed") {
        runs[2].status = Status::failed;
        CHECK(verdict_of(study, runs) == Verdict::fail);
    }
    SECTION("timed out") {
        runs[2].status = Status::timed_out;
        CHECK(verdict_of(study, runs) == Verdict::fail);
    }
    SECTION("a run is missing") {
        runs.pop_back();
        CHECK(verdict_of(study, runs) == Verdict::fail);
    }
    SECTION("a run is there twice") {
        runs.push_back(runs.back());
        runs.back().id = 3;
        CHECK(verdict_of(study, runs) == Verdict::fail);
    }
    SECTION("a run nobody planned") {
        runs.push_back(runs.back());
        runs.back().id = 3;
        runs.back().axes[0].value = 32;
        runs.back().h /= 2;
        runs.back().errors[0].value /= 4;
        CHECK(verdict_of(study, runs) == Verdict::fail);
    }
}

TEST_CASE("a run that may blow up is left out of the fit by name", "[unit]") {
    auto document = with("/allow", R"(["diverged"])");
    document["sweep"]["cells"] = {4, 8, 16, 32};
    const Study study = study_of(document);
    auto runs = planned_runs(study, second_order);
    runs[3].status = Status::diverged;
    runs[3].reason = "left";
    const Result result = judged(study, runs);
    CHECK(result.verdict == Verdict::pass);
    REQUIRE(result.fits[0].left_out.size() == 1);
    CHECK(result.fits[0].left_out[0].why == "diverged: left");
}

TEST_CASE("two points neither prove an order nor disprove it", "[unit]") {
    const Study study = study_of(with("/sweep/cells", "[4, 8]"));
    CHECK(verdict_of(study, planned_runs(study, second_order)) == Verdict::inconclusive);
    CHECK(verdict_of(study, planned_runs(study, [](double h) { return h; })) == Verdict::inconclusive);
}

TEST_CASE("points that scatter do not prove an order, wherever their slope lies", "[alarm]") {
    const Study study = study_of(tests::sample_document());
    auto runs = planned_runs(study, second_order);
    runs[1].errors[0].value *= 20;  // the slope of three points does not see the middle one
    const Result result = judged(study, runs);
    REQUIRE(result.fits[0].outcome.fit->order == Approx(2).epsilon(1e-12));
    CHECK(result.verdict == Verdict::inconclusive);
}

TEST_CASE("a study that expects nothing is inconclusive", "[alarm]") {
    auto document = tests::sample_document();
    document.erase("expect");
    const Study study = study_of(document);
    CHECK(verdict_of(study, planned_runs(study, second_order)) == Verdict::inconclusive);
}

TEST_CASE("bounds on errors: a zero is exact, never merely small", "[alarm]") {
    const auto [kind, error, expected] =
        GENERATE(table<std::string, double, Verdict>({{"error_at_most", 1e-3, Verdict::pass},
                                                      {"error_at_most", 2e-2, Verdict::fail},
                                                      {"error_at_most", 0.0, Verdict::fail},
                                                      {"exact_within", 1e-3, Verdict::pass},
                                                      {"exact_within", 0.0, Verdict::pass},
                                                      {"exact_within", 2e-2, Verdict::fail},
                                                      {"exact_within", NAN, Verdict::fail},
                                                      {"error_at_most", NAN, Verdict::fail},
                                                      {"error_at_most", -1.0, Verdict::fail}}));
    CAPTURE(kind, error);
    const Study study = study_of(with("/expect", "[{\"" + kind + "\": 1e-2, \"source\": \"test\"}]"));
    const double value = error;
    CHECK(verdict_of(study, planned_runs(study, [value](double) { return value; })) == expected);
}

TEST_CASE("a bound that speaks of no run fails", "[alarm]") {
    const Study study = study_of(with("/expect", R"([{"error_at_most": 1, "where": "cells > 99", "source": "test"}])"));
    CHECK(verdict_of(study, planned_runs(study, second_order)) == Verdict::fail);
}

TEST_CASE("published values: digits, band, none", "[alarm]") {
    const double ours = second_order(25.0 / 4);  // 1.171875e-02
    const auto verdict = [&](const std::string& compare, const std::string& value) {
        const Study study = published_study(compare, value);
        return verdict_of(study, planned_runs(study, second_order));
    };
    REQUIRE(ours == Approx(1.171875e-2));
    CHECK(verdict("\"digits\"", "1.1719e-02") == Verdict::pass);
    CHECK(verdict("\"digits\"", "1.1718e-02") == Verdict::fail);
    CHECK(verdict("\"digits\"", "1.1720e-02") == Verdict::fail);
    CHECK(verdict("\"band\", \"band\": 0.01", "1.18e-02") == Verdict::pass);
    CHECK(verdict("\"band\", \"band\": 0.001", "1.18e-02") == Verdict::fail);
    CHECK(verdict("\"none\", \"because\": \"another time\"", "9.9e-01") == Verdict::pass);
}

TEST_CASE("a published value without a run at its place fails", "[alarm]") {
    Study study = published_study("\"digits\"", "1.1719e-02");
    study.published[0].values[0].axes["cells"] = 5;
    CHECK(verdict_of(study, planned_runs(study, second_order)) == Verdict::fail);
}

TEST_CASE("the paths put the runs in lines", "[unit]") {
    auto document = with("/sweep", R"({"cells": [4, 8], "ppc": [1, 2], "dt": [0.02, 0.01], "path": "grid"})");
    document.erase("expect");
    const Study grid = study_of(document);
    const auto lines = series_of(grid, planned_runs(grid, second_order));
    REQUIRE(lines.size() == 8);
    CHECK(lines[0].label == "ppc = 1, dt = 0.02");
    CHECK(lines[0].abscissa == "h");
    CHECK(lines[4].abscissa == "dt");
    document["sweep"] = {{"cells", {4, 8}}, {"dt", {0.02, 0.01}}, {"path", "joint"}};
    const Study joint = study_of(document);
    CHECK(specs_of(joint).size() == 2);
    CHECK(series_of(joint, planned_runs(joint, second_order)).size() == 1);
}

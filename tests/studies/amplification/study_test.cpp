// Studies of stability: what their files may ask, what comes out, and who is told before a run.
#include <cmath>

#include "core/error.hpp"
#include "studies/amplification/figures.hpp"
#include "studies/amplification/warning.hpp"
#include "studies/engine/engine.hpp"
#include "studies/engine/judge.hpp"
#include "tests/catch.hpp"
#include "tests/studies/sample_study.hpp"

using namespace ordo;
using namespace ordo::studies;

namespace {

Json stability_document(const std::string& measure, const std::string& sweep, const std::string& expect = "[]") {
    return Json::parse(R"({"study": "s", "about": "a", "source": ["Sulsky1994"],
        "scene": {"name": "bar_vibration", "L": 4, "E": 1, "rho": 1, "ends": "periodic"},
        "solvers": [{"name": "mpm", "stress_update": "usl"}],
        "sweep": )" + sweep +
                       R"(, "measure": )" + measure + R"(, "expect": )" + expect + "}");
}

Result result_of(const Json& document) {
    const Study study = tests::study_of(document);
    return judged(study, run_all(study, {.jobs = 2}));
}

constexpr const char* four_cells = R"({"cells": 4, "ppc": 2, "path": "space"})";

std::string refusal(const std::string& measure, const std::string& sweep = four_cells,
                    const std::string& expect = "[]") {
    try {
        tests::study_of(stability_document(measure, sweep, expect));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a study of stability: its limits are numbers of the runs, held to values and to each other", "[unit]") {
    const std::string measure = R"({"stability": ["limit_by_matrix", "limit_by_theory"], "tolerance": 1e-4})";
    const auto good = result_of(stability_document(measure, four_cells, R"([
        {"value": 0.7559, "within": 5e-4, "of": "limit_by_matrix", "source": "closed form"},
        {"agrees_with": "limit_by_theory", "of": "limit_by_matrix", "within": 5e-4, "source": "closed form"}])"));
    CHECK(good.verdict == Verdict::pass);
    CHECK(good.fits.empty());
    CHECK(good.runs[0].error("limit_by_matrix") == Approx(0.7559).margin(5e-4));
    const auto low = result_of(stability_document(
        measure, four_cells, R"([{"value": 0.75, "within": 5e-4, "of": "limit_by_matrix", "source": "off"}])"));
    CHECK(low.verdict == Verdict::fail);
    CHECK(low.checks.back().fault == Fault::value_off);
}

TEST_CASE("a number that a run lacks fails what is expected of it, by name", "[alarm]") {
    auto document = stability_document(R"({"stability": ["limit_by_theory"]})", four_cells,
                                       R"([{"value": 1, "within": 9, "source": "none"}])");
    document["solvers"][0]["basis"] = "cubic";
    const auto result = result_of(document);
    CHECK(result.verdict == Verdict::fail);
    CHECK(result.checks.back().fault == Fault::error_is_nan);
    document["expect"][0]["where"] = "cells > 4";
    CHECK(result_of(document).checks.back().fault == Fault::no_such_series);
}

TEST_CASE("a run that blows up is a diverged one, and has its other figures", "[alarm]") {
    const auto document = stability_document(R"({"stability": ["growth", "spectral_radius"], "crossings": 100})",
                                             R"({"cells": 4, "ppc": 2, "courant": [0.5, 3], "path": "joint"})");
    const auto runs = result_of(document).runs;
    CHECK(runs[0].status == Status::ok);
    CHECK(runs[0].error("growth") < 10);
    CHECK(runs[0].error("spectral_radius") == Approx(1).epsilon(1e-8));
    CHECK(runs[1].status == Status::diverged);
    CHECK(runs[1].error("spectral_radius") > 1.1);
    CHECK_FALSE(runs[1].reason.empty());
}

TEST_CASE("energy over a long run: kept by MUSL, lost by USL and sooner by PIC", "[unit]") {
    auto document = stability_document(R"({"stability": "energy_kept", "crossings": 400})",
                                       R"({"cells": 8, "ppc": 2, "courant": 0.3, "path": "joint"})");
    const auto kept = [&](const char* order, const char* transfer) {
        document["solvers"][0]["stress_update"] = order;
        document["solvers"][0]["transfer"] = transfer;
        return result_of(document).runs[0].error("energy_kept");
    };
    CHECK(kept("musl", "flip") == Approx(1).epsilon(0.2));  // of noise, whose waves swing apart
    CHECK(kept("usl", "flip") < 0.95 * kept("musl", "flip"));
    CHECK(kept("usl", "pic") < 0.5 * kept("usl", "flip"));
}

TEST_CASE("a study of stability refuses what does not go together, by name and place", "[alarm]") {
    CHECK_THAT(refusal(R"({"stability": "limit"})"), ContainsSubstring("/measure/stability"));
    CHECK_THAT(refusal(R"({"stability": "growth"})"), ContainsSubstring("sweep 'courant'"));
    CHECK_THAT(refusal(R"({"stability": "limit_by_runs"})", R"({"cells": 4, "courant": 0.5, "path": "joint"})"),
               ContainsSubstring("'courant' must not be swept"));
    CHECK_THAT(refusal(R"({"stability": []})"), ContainsSubstring("empty list"));
    CHECK_THAT(refusal(R"({"stability": ["limit_by_runs", "limit_by_runs"]})"), ContainsSubstring("repeats"));
    CHECK_THAT(refusal(R"({"stability": "limit_by_runs", "between": [2, 1]})"), ContainsSubstring("two rising"));
    CHECK_THAT(refusal(R"({"stability": "limit_by_runs", "between": [0.1]})"),
               ContainsSubstring("two Courant numbers"));
    CHECK_THAT(refusal(R"({"stability": "limit_by_runs", "growth": 0.5})"), ContainsSubstring("must be > 1"));
    CHECK_THAT(refusal(R"({"stability": "limit_by_runs", "crossings": 0})"), ContainsSubstring("must be > 0"));
    CHECK_THAT(refusal(R"({"stability": "limit_by_runs", "at": 1})"), ContainsSubstring("at"));
    CHECK_THAT(refusal(R"({"stability": "limit_by_runs"})", four_cells, R"([{"error_at_most": 1, "source": "x"}])"),
               ContainsSubstring("no error but a number"));
    CHECK_THAT(refusal(R"({"stability": ["limit_by_runs", "limit_by_theory"]})", four_cells,
                       R"([{"value": 1, "within": 0.1, "source": "x"}])"),
               ContainsSubstring("must name in 'of'"));
}

TEST_CASE("before a run: a step beyond the closed form is told, once a solver, and others are not", "[unit]") {
    auto document = tests::sample_document();
    document["sweep"] = Json::parse(R"({"cells": [4, 8, 16], "ppc": 2, "courant": 1.5, "path": "joint"})");
    document["solvers"] = Json::parse(R"([{"name": "mpm", "stress_update": ["usl", "musl"]}, {"name": "fem"}])");
    const auto lines = beyond_limits(tests::study_of(document));
    REQUIRE(lines.size() == 2);
    CHECK_THAT(lines[0], ContainsSubstring("fem") && ContainsSubstring("Courant number 1.5"));
    CHECK_THAT(lines[1], ContainsSubstring("mpm usl") && ContainsSubstring("0.7559"));
    document["sweep"]["courant"] = 0.5;
    CHECK(beyond_limits(tests::study_of(document)).empty());
}

TEST_CASE("the published blow-up: the oedometer runs with 37 elements and leaves its end with 38", "[published]") {
    const Study study = read_study(std::string(ORDO_SOURCE_DIR) + "/studies/stability/oedometer_published.json", {});
    const auto runs = run_all(study, {.jobs = 2});
    const auto at = [&](double cells) -> const Run& {
        return *std::ranges::find_if(runs, [&](const Run& run) { return run.axis("cells") == cells; });
    };
    CHECK(at(37).error("displacement.rms") < 2e-5);
    CHECK(at(38).error("displacement.rms") > 1e-4);  // it was 2e-5
    CHECK(at(39).status == Status::diverged);
}

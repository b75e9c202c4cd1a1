// "stop": "when_decided": when finer levels are skipped, when they must not be, and what the gate says of it.
#include "studies/engine/decided.hpp"

#include <cmath>

#include "core/error.hpp"
#include "studies/engine/engine.hpp"
#include "studies/engine/judge.hpp"
#include "studies/engine/run.hpp"
#include "tests/catch.hpp"
#include "tests/studies/sample_study.hpp"

using namespace ordo;
using namespace ordo::studies;

namespace {

constexpr int levels = 10;

/// One line of ten levels, 4 to 2048 cells, that may stop, with these expectations.
Study study_that_expects(const std::string& expectations) {
    auto document = tests::with("/expect", expectations);
    document["sweep"] = Json::parse(R"({"cells": [4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048], "ppc": 2,
                                        "dt": 1e-4, "path": "space"})");
    document["stop"] = "when_decided";
    return tests::study_of(document);
}

/// All runs as planned, with the errors that `error` gives for each h.
template <class Error>
std::vector<Run> runs_with(const Study& study, Error&& error) {
    std::vector<Run> runs;
    for (const auto& spec : specs_of(study)) {
        runs.push_back(planned_run(spec));
        runs.back().errors = {{"displacement.rms", error(runs.back().h)}};
    }
    return runs;
}

/// Levels that are run before the others are skipped, and why they are; all of them where none is.
std::pair<int, std::string> stop_of(const Study& study, const std::vector<Run>& runs) {
    const auto line = lines_of(study, runs).front();
    for (int ended = 1; ended < levels; ++ended) {
        const auto why = why_decided(study, runs, line, static_cast<std::size_t>(ended));
        if (!why.empty()) return {ended, why};
    }
    return {levels, ""};
}

/// A few per cent up and down, as real errors have.
double second_order(double h) { return h * h * (1 + 0.01 * std::sin(40 * std::log(h))); }

const std::string order_2 = R"({"order": 2, "within": 0.2, "source": "theory"})";

}  // namespace

TEST_CASE("an order is decided by five levels that pass, as four of them did", "[unit]") {
    const Study study = study_that_expects("[" + order_2 + "]");
    const auto [ended, why] = stop_of(study, runs_with(study, second_order));
    CHECK(ended == 5);
    CHECK(why == "every expected order is decided at cells = 64");
}

TEST_CASE("an order that does not pass is never decided", "[alarm]") {
    const Study study = study_that_expects(R"([{"order": 3, "within": 0.2, "source": "theory"}])");
    CHECK(stop_of(study, runs_with(study, second_order)).first == levels);
}

TEST_CASE("an order waits for the levels that are asked for", "[alarm]") {
    const Study study = study_that_expects(R"([{"order": 2, "within": 0.2, "levels": 7, "source": "theory"}])");
    const int ended = stop_of(study, runs_with(study, second_order)).first;
    CHECK(ended >= 7);
    CHECK(ended < levels);
}

TEST_CASE("a bound waits for every level in its range, unless it is broken", "[alarm]") {
    const auto with_bound = [](const std::string& bound) {
        return study_that_expects("[" + order_2 + R"(, {"error_at_most": )" + bound + R"(, "source": "theory"}])");
    };
    const Study holds = with_bound("1e3");
    CHECK(stop_of(holds, runs_with(holds, second_order)).first == levels);
    const Study broken = with_bound("1e-9");
    CHECK(stop_of(broken, runs_with(broken, second_order)).first == 5);
    const Study coarse = with_bound(R"(1e3, "where": "cells <= 256")");
    CHECK(stop_of(coarse, runs_with(coarse, second_order)).first == 7);
}

TEST_CASE("where no level is left in the range of an order, its verdict stands whatever it is", "[unit]") {
    const Study study =
        study_that_expects(R"([{"order": 3, "within": 0.2, "where": "cells <= 32", "source": "theory"}])");
    CHECK(stop_of(study, runs_with(study, second_order)).first == 4);
}

TEST_CASE("at a floor finer levels are skipped, although the order fails", "[unit]") {
    const Study study = study_that_expects(R"([{"order": 4, "within": 0.2, "source": "theory"}])");
    const auto [ended, why] = stop_of(study, runs_with(study, [](double h) { return second_order(h) + 0.05; }));
    CHECK(ended < levels);
    CHECK_THAT(why, ContainsSubstring("at their floor"));
}

TEST_CASE("without an expectation nothing is decided but a floor", "[alarm]") {
    const Study study = study_that_expects("[]");
    CHECK(stop_of(study, runs_with(study, second_order)).first == levels);
}

TEST_CASE("after a run that blew up, larger Courant numbers are skipped; smaller ones are not", "[unit]") {
    const Study study = study_that_expects("[" + order_2 + "]");
    auto runs = runs_with(study, second_order);
    runs[2].status = Status::diverged;
    runs[2].errors.clear();
    const auto [ended, why] = stop_of(study, runs);
    CHECK(ended == 3);
    CHECK_THAT(why, ContainsSubstring("blew up at cells = 16"));

    auto document = tests::with("/sweep", R"({"cells": 8, "ppc": 2, "dt": [0.4, 0.2, 0.1, 0.05], "path": "time"})");
    document["stop"] = "when_decided";
    const Study in_time = tests::study_of(document);
    auto refined = runs_with(in_time, second_order);
    refined[0].status = Status::diverged;
    CHECK(why_decided(in_time, refined, lines_of(in_time, refined).front(), 1).empty());
}

TEST_CASE("a study that may stop gives the same for any number of jobs, and its gate knows what was skipped",
          "[alarm]") {
    auto document = tests::with("/sweep", R"({"cells": [4, 8, 16, 32, 64, 128, 256], "ppc": [2, 3], "dt": 0.002,
                                              "path": "space"})");
    document["stop"] = "when_decided";
    const Study study = tests::study_of(document);
    const auto alone = run_all(study, {.jobs = 1, .progress = {}});
    const auto together = run_all(study, {.jobs = 8, .progress = {}});
    REQUIRE(alone.size() == 14);
    for (std::size_t i = 0; i < alone.size(); ++i) {
        CHECK(alone[i].status == together[i].status);
        CHECK(alone[i].reason == together[i].reason);
        CHECK(alone[i].errors == together[i].errors);
    }
    CHECK(std::ranges::count(alone, Status::skipped, &Run::status) == 4);
    const Result result = judged(study, alone);
    CHECK(result.verdict == Verdict::pass);
    CHECK_THAT(result.checks[0].found, ContainsSubstring("4 skipped"));

    // A level that the coarser ones do not decide cannot be skipped by writing so.
    auto forged = alone;
    forged[3].status = Status::skipped;
    CHECK(judged(study, forged).checks[0].fault == Fault::point_missing);
    auto without = study;
    without.stops_when_decided = false;
    CHECK(judged(without, alone).checks[0].fault == Fault::point_missing);
}

TEST_CASE("what stopping hides: errors that grow where nobody looks any more", "[alarm]") {
    const auto grows = [](double h) { return h > 0.3 ? second_order(h) : 0.1; };
    const Study stops = study_that_expects("[" + order_2 + "]");
    CHECK(stop_of(stops, runs_with(stops, grows)).first == 5);
    Study looks = stops;
    looks.stops_when_decided = false;
    CHECK(judged(looks, runs_with(looks, grows)).verdict == Verdict::fail);
}

TEST_CASE("stopping is refused where coarse runs do not say all that is judged", "[alarm]") {
    const std::vector<std::pair<std::string, std::string>> refused{
        {"/measure/against", "\"itself\""},
        {"/measure/orders_against", "\"1/steps\""},
        {"/sweep", R"({"cells": [4, 8], "dt": [0.01, 0.005], "path": "grid"})"}};
    for (const auto& [place, value] : refused) {
        auto document = tests::with(place, value);
        document["expect"] = Json::array();
        CHECK_NOTHROW(tests::study_of(document));
        document["stop"] = "when_decided";
        CHECK_THROWS_AS(tests::study_of(document), InputError);
    }
    CHECK_THROWS_AS(tests::study_of(tests::with("/stop", "\"early\"")), InputError);
}

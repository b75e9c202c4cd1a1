// The engine: order of runs, same bits, blow-ups, time limits, ends.
#include "studies/engine/engine.hpp"

#include <cmath>
#include <cstring>
#include <map>
#include <mutex>

#include "core/error.hpp"
#include "studies/engine/judge.hpp"
#include "studies/engine/run.hpp"
#include "studies/engine/scene_entry.hpp"
#include "tests/catch.hpp"
#include "tests/studies/sample_study.hpp"

using namespace ordo;
using namespace ordo::studies;
using ordo::tests::study_of;
using ordo::tests::with;

TEST_CASE("the same bits for any number of jobs", "[property]") {
    const Study study =
        study_of(with("/sweep", R"({"cells": [4, 8, 16, 32], "ppc": [1, 2, 3], "dt": 0.005, "path": "space"})"));
    const auto alone = run_all(study, {.jobs = 1, .progress = {}});
    const auto together = run_all(study, {.jobs = 7, .progress = {}});
    REQUIRE(alone.size() == 12);
    REQUIRE(together.size() == 12);
    for (std::size_t i = 0; i < alone.size(); ++i) {
        CHECK(alone[i].id == static_cast<int>(i));
        CHECK(together[i].id == static_cast<int>(i));
        CHECK(std::memcmp(&alone[i].errors[0].value, &together[i].errors[0].value, sizeof(double)) == 0);
    }
}

TEST_CASE("progress counts every run once", "[unit]") {
    const Study study = study_of(tests::sample_document());
    int calls = 0;
    Progress last;
    run_all(study, {.jobs = 2, .progress = [&](const Progress& now) {
                        ++calls;
                        last = now;
                    }});
    CHECK(calls == 3);
    CHECK(last.done == 3);
    CHECK(last.running == 0);
    CHECK(last.work_done == Approx(1));
}

TEST_CASE("a run that blows up is a row with its reason, and the sweep goes on", "[alarm]") {
    const Study study = study_of(with("/sweep/cells", "[4, 2000]"));  // Courant number 8 at 2000 cells
    const auto runs = run_all(study, {.jobs = 2, .progress = {}});
    CHECK(runs[0].status == Status::ok);
    CHECK(runs[1].status == Status::diverged);
    CHECK_THAT(runs[1].reason, ContainsSubstring("is turned inside out"));
    CHECK(runs[1].errors.empty());
}

TEST_CASE("a run that passes its time limit is a row, not the end", "[alarm]") {
    auto document = with("/sweep", R"({"cells": [4, 100000], "dt": 1e-6, "path": "space"})");
    document["timeout_s"] = 0.02;
    document["measure"]["at"] = 1e-3;
    const auto runs = run_all(study_of(document), {.jobs = 2, .progress = {}});
    CHECK(runs[0].status == Status::ok);
    CHECK(runs[1].status == Status::timed_out);
}

namespace {

/// Keeps in memory, and counts what was kept.
class Memory : public FinishedRuns {
public:
    std::optional<Run> find(const std::string& description) override {
        const std::lock_guard lock(mutex_);
        const auto place = runs_.find(description);
        if (place == runs_.end()) return std::nullopt;
        Run run = place->second;
        run.origin = Origin::shared;
        return run;
    }
    void keep(const std::string& description, const Run& run) override {
        const std::lock_guard lock(mutex_);
        ++kept;
        runs_.emplace(description, run);
    }
    int kept = 0;

private:
    std::mutex mutex_;
    std::map<std::string, Run> runs_;
};

/// Five studies whose sweeps overlap: 8, 4 and 5, 4 to 6, 4 to 7, 4 to 8 and 16 to 64 cells.
std::vector<Study> overlapping() {
    std::vector<Study> studies;
    for (const auto* cells : {"[8]", "[4, 5]", "[4, 5, 6]", "[4, 5, 6, 7]", "[4, 5, 6, 7, 8, 16, 32, 64]"})
        studies.push_back(study_of(with("/sweep/cells", cells)));
    return studies;
}

std::vector<const Study*> all_of(const std::vector<Study>& studies) {
    std::vector<const Study*> all;
    for (const auto& study : studies) all.push_back(&study);
    return all;
}

}  // namespace

TEST_CASE("studies of one call: each as alone, in their order, equal runs made once", "[property]") {
    const auto studies = overlapping();
    for (const int jobs : {1, 2, 3, 8}) {
        Memory memory;
        std::vector<int> told(studies.size());
        Engine engine(all_of(studies), {.jobs = jobs,
                                        .progress = [&](const Progress& now) { told[now.study] = now.done; },
                                        .finished = &memory});
        for (std::size_t k = 0; k < studies.size(); ++k) {
            const auto together = engine.next().runs;
            const auto alone = run_all(studies[k], {});
            REQUIRE(together.size() == alone.size());
            CHECK(told[k] == static_cast<int>(alone.size()));
            for (std::size_t i = 0; i < alone.size(); ++i) {
                CHECK(std::memcmp(&together[i].errors[0].value, &alone[i].errors[0].value, sizeof(double)) == 0);
            }
        }
        CHECK(memory.kept == 8);  // 4, 5, 6, 7, 8, 16, 32 and 64 cells
    }
}

TEST_CASE("a study that is wrong ends the call at its turn, and those before it are whole", "[alarm]") {
    auto studies = overlapping();
    studies[2].solvers.front().name = "unknown";
    Engine engine(all_of(studies), {.jobs = 3});
    CHECK(engine.next().runs.size() == 1);
    CHECK(engine.next().runs.size() == 2);
    CHECK_THROWS_AS(engine.next(), InputError);
}

TEST_CASE("an engine that is left before its studies have ended stops them", "[unit]") {
    const Study endless = study_of(with("/sweep", R"({"cells": [100000], "dt": 1e-9, "path": "space"})"));
    const Study short_one = study_of(tests::sample_document());
    Engine engine({&short_one, &endless, &endless}, {.jobs = 3});
    CHECK(engine.next().runs.size() == 3);
}

TEST_CASE("an interrupt keeps nothing", "[alarm]") {
    const std::atomic<bool> stop{true};
    CHECK_THROWS_AS(run_all(study_of(tests::sample_document()), {.jobs = 1, .progress = {}, .interrupted = &stop}),
                    StudyInterrupted);
}

TEST_CASE("the three ends: exactly, by accumulation, by steps", "[unit]") {
    Measure measure;
    measure.at = 0.5;
    CHECK(end_time(measure, 0.3) == 0.5);
    measure.until = Until::accumulated;
    CHECK(end_time(measure, 0.3) == Approx(0.6).epsilon(1e-15));
    CHECK(end_time(measure, 0.1) == Approx(0.5).epsilon(1e-15));  // 5 sums of 0.1 give 0.5 exactly in binary
    measure.at = 1;
    CHECK(end_time(measure, 0.1) == Approx(1.1).epsilon(1e-15));  // 10 sums of 0.1 stay below 1
    measure.until = Until::steps;
    measure.at = 499;
    CHECK(end_time(measure, 1e-3) == Approx(0.499).epsilon(1e-15));
}

TEST_CASE("a dt that does not divide the end becomes equal steps, and the run says so", "[unit]") {
    auto document = with("/sweep/dt", "0.03");
    const auto runs = run_all(study_of(document), {.jobs = 1, .progress = {}});
    CHECK(runs[0].dt == Approx(0.2 / 7).epsilon(1e-15));
    CHECK(runs[0].t == 0.2);
    CHECK(runs[0].work[0].value == 7);
}

TEST_CASE("the maximum over time is no smaller than the end and hits the same end", "[property]") {
    const auto end = run_all(study_of(tests::sample_document()), {.jobs = 1, .progress = {}});
    const auto largest = run_all(study_of(with("/measure/over", "\"maximum\"")), {.jobs = 1, .progress = {}});
    for (std::size_t i = 0; i < end.size(); ++i) {
        CHECK(largest[i].errors[0].name == "displacement.rms.max");
        // Equal steps of t/20 differ from one stretch of 20 steps in the last digits of dt only.
        CHECK(largest[i].errors[0].value >= end[i].errors[0].value * (1 - 1e-10));
        CHECK(largest[i].t == end[i].t);
        CHECK(largest[i].work[0].value == end[i].work[0].value);
    }
}

TEST_CASE("the finest run is the reference and has no error against itself", "[unit]") {
    auto document = with("/sweep", R"({"cells": 8, "ppc": 2, "dt": [0.02, 0.01, 0.005, 0.00125], "path": "time"})");
    document["measure"]["against"] = {"finest", "exact"};
    document["expect"] = {{{"order", 2}, {"within", 0.15}, {"of", "displacement.rms@finest"}, {"source", "a(0) = 0"}}};
    const Study study = study_of(document);
    const Result result = judged(study, run_all(study, {.jobs = 1, .progress = {}}));
    CHECK(result.runs[3].status == Status::reference);
    CHECK(std::isnan(result.runs[3].error("displacement.rms@finest")));
    CHECK(std::isfinite(result.runs[3].error("displacement.rms")));
    CHECK(result.runs[0].error("displacement.rms@finest") > 0);
}

TEST_CASE("runs are compared with the finest once, whatever orders are against", "[unit]") {
    auto document = with("/sweep", R"({"cells": 8, "ppc": 2, "dt": [0.02, 0.01, 0.005], "path": "time"})");
    document["measure"]["against"] = "finest";
    document["measure"]["orders_against"] = {"dt", "1/steps"};
    document["expect"] = Json::array();
    const Study study = study_of(document);
    const Result result = judged(study, run_all(study, {.jobs = 1, .progress = {}}));
    CHECK(result.runs[0].errors.size() == 1);
    REQUIRE(result.fits.size() == 2);
    // Equal steps: one over their number is dt over the time.
    CHECK(result.fits[1].outcome.fit->order == Approx(result.fits[0].outcome.fit->order).epsilon(1e-9));
}

TEST_CASE("scene, solver and resolution that do not go together are refused before anything runs", "[alarm]") {
    auto document = tests::sample_document();
    document["sweep"].erase("dt");
    CHECK_THROWS_AS(specs_of(study_of(document)), InputError);
    document["sweep"]["dt"] = 1e-12;
    CHECK_THROWS_AS(specs_of(study_of(document)), InputError);  // more than 1e9 steps
    document["sweep"].erase("cells");
    document["sweep"]["dt"] = 1e-2;
    CHECK_THROWS_AS(specs_of(study_of(document)), InputError);
}

TEST_CASE("every benchmark of the catalogue can be built and has every field of its truth", "[unit]") {
    REQUIRE_FALSE(all_scenes().empty());
    for (const auto& scene : all_scenes()) {
        const Values values = resolve(scene.parameters, {}, "test", scene.name);
        const auto problem = scene.problem(values);
        if (solvers::is_solid(problem)) {
            const auto dim = [&]<int dim>(const solvers::SolidScene<dim>&) { return dim; };
            CHECK(solvers::on_solid(problem, dim) == scene.truth(values).dim);
        }
        CHECK_NOTHROW(oracles::oracle_named(scene.oracle, "test"));
    }
}

// What is made once only: equal runs, the run of several measures, what was finished before; and what is never kept.
#include "studies/engine/crew.hpp"

#include <cstring>
#include <map>
#include <thread>

#include "studies/engine/judge.hpp"
#include "studies/engine/measure.hpp"
#include "tests/catch.hpp"
#include "tests/studies/sample_study.hpp"

using namespace ordo;
using namespace ordo::studies;

namespace {

/// Remembers what is kept, and counts.
struct Memory : FinishedRuns {
    std::mutex mutex;
    std::map<std::string, Run> runs;
    int made = 0;

    std::optional<Run> find(const std::string& description) override {
        const std::lock_guard lock(mutex);
        const auto found = runs.find(description);
        if (found == runs.end()) return {};
        Run run = found->second;
        run.origin = Origin::cached;
        return run;
    }
    void keep(const std::string& description, const Run& run) override {
        const std::lock_guard lock(mutex);
        ++made;
        runs[description] = run;
    }
};

/// A simulation that counts its snapshots.
struct Counted : solvers::Simulation {
    Counted(std::unique_ptr<solvers::Simulation> inner, int& snapshots) : inner_(std::move(inner)), shots_(snapshots) {}
    void advance_to(double t, const solvers::Interrupt& interrupt) override { inner_->advance_to(t, interrupt); }
    solvers::Snapshot snapshot() const override {
        ++shots_;
        return inner_->snapshot();
    }
    std::vector<solvers::Figure> work() const override { return inner_->work(); }
    std::vector<solvers::Figure> drift() const override { return inner_->drift(); }

private:
    std::unique_ptr<solvers::Simulation> inner_;
    int& shots_;
};

bool same(const std::vector<Run>& a, const std::vector<Run>& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const Run& one, const Run& other) {
               return one.id == other.id && one.solver == other.solver && one.axes == other.axes && one.h == other.h &&
                      one.dt == other.dt && one.t == other.t && one.status == other.status &&
                      one.reason == other.reason && one.errors == other.errors && one.drift == other.drift &&
                      one.work == other.work && one.skipped == other.skipped;
           });
}

std::vector<Run> all_of(const Study& study, FinishedRuns* finished, int jobs = 2) {
    return run_all(study, {.jobs = jobs, .progress = {}, .finished = finished});
}

}  // namespace

TEST_CASE("several fields and norms are measured from one run and one snapshot", "[unit]") {
    auto document = tests::with("/measure/fields", R"(["displacement", "velocity"])");
    document["measure"]["norms"] = {"rms", "l2", "linf"};
    document["expect"] = Json::array();
    const RunSpec spec = specs_of(tests::study_of(document)).front();
    int starts = 0, snapshots = 0, truths = 0;
    SceneEntry scene = house_parts().scene(spec.scene.name);
    solvers::Solver solver = house_parts().solver(spec.solver.name);
    scene.truth = [&truths, truth = scene.truth](const Values& values) {
        ++truths;
        return truth(values);
    };
    solver.start = [&, start = solver.start](const auto& problem, const auto& options, const auto& fine, auto fields) {
        ++starts;
        return std::make_unique<Counted>(start(problem, options, fine, fields), snapshots);
    };
    const Parts parts{.scene = [&](const auto&) -> const SceneEntry& { return scene; },
                      .solver = [&](const auto&) -> const solvers::Solver& { return solver; },
                      .errors = errors_against_exact};
    const auto never = [] { return false; };
    const Run run = executed(spec, never, parts).run;
    CHECK(run.errors.size() == 6);
    CHECK(starts == 1);
    CHECK(snapshots == 1);
    CHECK(truths == 1);

    // An oracle that nothing is measured against is not asked.
    document["measure"]["against"] = "itself";
    const RunSpec alone = specs_of(tests::study_of(document)).front();
    const int before = truths;
    CHECK(executed(alone, never, parts).run.errors.size() == 6);
    CHECK(truths == before);
}

TEST_CASE("runs that were finished before are the same bits, and none is made", "[property]") {
    const std::vector<std::pair<std::string, std::string>> kinds{
        {"/study", "\"as it is\""},
        {"/sweep/cells", "[4, 2000]"},  // blows up at 2000 cells
        {"/measure/over", "\"maximum\""},
        {"/stop", "\"when_decided\""}};
    for (const auto& [place, value] : kinds) {
        INFO(place);
        const Study study = tests::study_of(tests::with(place, value));
        Memory memory;
        const auto fresh = all_of(study, nullptr);
        const auto kept = all_of(study, &memory);
        CHECK(same(fresh, kept));
        const int made = memory.made;
        CHECK(made > 0);
        const auto again = all_of(study, &memory);
        CHECK(same(fresh, again));
        CHECK(memory.made == made);
        CHECK(again.front().origin == Origin::cached);
        for (std::size_t i = 0; i < again.size(); ++i) CHECK(again[i].seconds == kept[i].seconds);
    }
}

TEST_CASE("runs that are compared with the finest are found all together or made all together", "[alarm]") {
    auto document = tests::with("/sweep", R"({"cells": 8, "ppc": [1, 2], "dt": [0.02, 0.01, 0.005], "path": "time"})");
    document["measure"]["against"] = {"finest", "exact"};
    document["expect"] = Json::array();
    const Study study = tests::study_of(document);
    Memory memory;
    const auto fresh = all_of(study, nullptr, 1);
    CHECK(same(fresh, all_of(study, &memory, 8)));
    CHECK(memory.made == 6);
    CHECK(same(fresh, all_of(study, &memory)));
    CHECK(memory.made == 6);
    // Another finest run is another reference: nothing of the line can be taken over.
    document["sweep"]["dt"] = {0.02, 0.01, 0.0025};
    const Study finer = tests::study_of(document);
    CHECK(same(all_of(finer, nullptr), all_of(finer, &memory)));
    CHECK(memory.made == 12);
    // One more coarse run needs the snapshot of the reference again.
    document["sweep"]["dt"] = {0.04, 0.02, 0.01, 0.005};
    const Study longer = tests::study_of(document);
    CHECK(same(all_of(longer, nullptr), all_of(longer, &memory)));
    CHECK(memory.made == 20);
}

TEST_CASE("equal runs of one study are made once", "[unit]") {
    auto document = tests::sample_document();
    document["solvers"] = Json::parse(R"([{"name": "mpm", "label": "one"}, {"name": "mpm", "label": "other"}])");
    document["expect"] = Json::array();
    const Study study = tests::study_of(document);
    Memory memory;
    int told = 0;
    const auto runs = run_all(study, {.jobs = 2, .progress = [&](const Progress&) { ++told; }, .finished = &memory});
    CHECK(memory.made == 3);
    CHECK(told == 6);
    REQUIRE(runs.size() == 6);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(runs[i].origin == Origin::made);
        CHECK(runs[i + 3].origin == Origin::shared);
        CHECK(runs[i + 3].solver == "other");
        CHECK(runs[i + 3].errors == runs[i].errors);
    }
}

TEST_CASE("a run that failed or passed its time is never kept", "[alarm]") {
    Memory memory;
    auto document = tests::with("/timeout_s", "1e-9");
    CHECK(all_of(tests::study_of(document), &memory).front().status == Status::timed_out);
    CHECK(memory.made == 0);
    // Nor is what was compared with it.
    document["sweep"] = Json::parse(R"({"cells": 8, "ppc": 2, "dt": [0.02, 0.01], "path": "time"})");
    document["measure"]["against"] = "finest";
    document["expect"] = Json::array();
    all_of(tests::study_of(document), &memory);
    CHECK(memory.made == 0);
}

TEST_CASE("of an interrupted study the finished runs are kept", "[alarm]") {
    const Study study = tests::study_of(tests::sample_document());
    Memory memory;
    std::atomic<bool> stop{false};
    const auto after_the_first = [&](const Progress&) { stop = true; };
    CHECK_THROWS_AS(run_all(study, {.jobs = 1, .progress = after_the_first, .interrupted = &stop, .finished = &memory}),
                    StudyInterrupted);
    CHECK(memory.made == 1);
    CHECK(all_of(study, &memory).size() == 3);
    CHECK(memory.made == 3);
}

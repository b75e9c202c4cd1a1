// Times by repetition: their statistics, when repetitions end, and that each ends in the same bits.
#include "studies/engine/timing.hpp"

#include <cmath>
#include <stdexcept>

#include "studies/engine/engine.hpp"
#include "tests/catch.hpp"
#include "tests/studies/sample_study.hpp"

using namespace ordo;
using namespace ordo::studies;
using ordo::tests::study_of;
using ordo::tests::with;

namespace {

const auto never = [] { return false; };

/// The first run of the sample, run and then timed by the rule.
RunOutcome timed(const TimingRule& rule, const Parts& parts = house_parts()) {
    const auto specs = specs_of(study_of(tests::sample_document()));
    auto outcome = executed(specs[0], never, parts);
    time_again(specs[0], outcome, rule, never, parts);
    return outcome;
}

/// The real simulation, whose n-th snapshot is off by n units in the last place of one velocity, position or weight.
class Drifting : public solvers::Simulation {
public:
    Drifting(std::unique_ptr<solvers::Simulation> real, int& snapshots) : real_(std::move(real)), count_(snapshots) {}
    void advance_to(double t, const solvers::Interrupt& interrupt) override { real_->advance_to(t, interrupt); }
    solvers::Snapshot snapshot() const override {
        auto shot = real_->snapshot();
        ++count_;
        for (int k = 0; k < count_; ++k) shot.fields[0].values[1] = std::nextafter(shot.fields[0].values[1], 1);
        return shot;
    }
    std::vector<solvers::Figure> work() const override { return real_->work(); }
    std::vector<solvers::Figure> drift() const override { return real_->drift(); }

private:
    std::unique_ptr<solvers::Simulation> real_;
    int& count_;
};

/// The real simulation, with helpers that work 100 s in each of its parts, the start included.
class Helped : public solvers::Simulation {
public:
    explicit Helped(std::unique_ptr<solvers::Simulation> real) : real_(std::move(real)) {}
    void advance_to(double t, const solvers::Interrupt& interrupt) override {
        helpers_ += 100;
        real_->advance_to(t, interrupt);
    }
    solvers::Snapshot snapshot() const override { return real_->snapshot(); }
    std::vector<solvers::Figure> work() const override { return real_->work(); }
    std::vector<solvers::Figure> drift() const override { return real_->drift(); }
    double helper_seconds() const override { return helpers_; }

private:
    std::unique_ptr<solvers::Simulation> real_;
    double helpers_ = 100;
};

}  // namespace

TEST_CASE("timing: median and median absolute deviation of samples", "[unit]") {
    const auto odd = statistics_of({3, 1, 2, 10, 2});  // off the median by 1, 1, 0, 8, 0
    CHECK(odd.median == 2);
    CHECK(odd.spread == 0.5);
    CHECK(odd.samples == 5);
    const auto even = statistics_of({4, 1, 3, 2});  // off by 1.5, 1.5, 0.5, 0.5
    CHECK(even.median == 2.5);
    CHECK(even.spread == Approx(0.4).epsilon(1e-15));
    CHECK(statistics_of({7}).median == 7);
    CHECK(std::isnan(statistics_of({7}).spread));
    CHECK_THROWS_AS(statistics_of({}), std::logic_error);
}

TEST_CASE("timing: repetitions end by the spread, by their number, or by the time used", "[unit]") {
    const auto by_spread = timed({.spread = 1e9, .least = 3, .most = 25, .seconds = 10, .shortest = 0});
    REQUIRE(by_spread.run.repeats);
    CHECK(by_spread.run.repeats->number == 3);
    CHECK(by_spread.run.repeats->spread >= 0);
    CHECK(by_spread.run.seconds > 0);
    CHECK(timed({.spread = -1, .least = 1, .most = 7, .seconds = 10, .shortest = 0}).run.repeats->number == 7);
    const auto long_run = timed({.seconds = 0});
    CHECK(long_run.run.repeats->number == 1);
    CHECK(std::isnan(long_run.run.repeats->spread));
    const int within =
        timed({.spread = -1, .least = 1, .most = 1000, .seconds = 5e-3, .shortest = 2e-3}).run.repeats->number;
    CHECK(within >= 2);
    CHECK(within <= 10);  // a sample lasts about 2 ms however short the run
}

TEST_CASE("timing: what is measured stays as it is, and a run that stopped is not repeated", "[unit]") {
    const auto specs = specs_of(study_of(tests::sample_document()));
    const auto once = executed(specs[0], never);
    const auto again = timed({.most = 2});
    CHECK(again.run.errors == once.run.errors);
    CHECK(again.run.work == once.run.work);
    CHECK(again.run.status == Status::ok);
    auto broken = executed(specs[0], never);
    broken.run.status = Status::diverged;
    time_again(specs[0], broken, {}, never);
    CHECK_FALSE(broken.run.repeats);
}

TEST_CASE("timing: a run that does not repeat itself to the bit is a failed one, with its reason", "[alarm]") {
    int snapshots = 0;
    solvers::Solver drifting = solvers::solver_named("mpm", "");
    const auto real = drifting.start;
    drifting.start = [&](const auto& scene, const auto& options, const auto& resolution, auto fields) {
        return std::make_unique<Drifting>(real(scene, options, resolution, fields), snapshots);
    };
    Parts parts = house_parts();
    parts.solver = [&](const std::string&) -> const solvers::Solver& { return drifting; };
    const auto outcome = timed({}, parts);
    CHECK(outcome.run.status == Status::failed);
    CHECK_THAT(outcome.run.reason, ContainsSubstring("does not repeat itself"));
    CHECK(outcome.run.errors.empty());
}

TEST_CASE("timing: what helpers use counts, for a run's time and for its limit", "[unit]") {
    solvers::Solver helped = solvers::solver_named("mpm", "");
    const auto real = helped.start;
    helped.start = [&](const auto& scene, const auto& options, const auto& resolution, auto fields) {
        return std::make_unique<Helped>(real(scene, options, resolution, fields));
    };
    Parts parts = house_parts();
    parts.solver = [&](const std::string&) -> const solvers::Solver& { return helped; };
    auto spec = specs_of(study_of(tests::sample_document()))[0];
    auto outcome = executed(spec, never, parts);
    CHECK(outcome.run.seconds == Approx(200).margin(10));
    time_again(spec, outcome, {.most = 1, .seconds = 1e9}, never, parts);
    CHECK(outcome.run.seconds == Approx(200).margin(10));
    spec.timeout_s = 150;
    CHECK(executed(spec, never, parts).run.status == Status::timed_out);
    spec.timeout_s = 250;
    CHECK(executed(spec, never, parts).run.status == Status::ok);
}

TEST_CASE("timing: where errors are over all steps, repetitions are held to one another", "[unit]") {
    const auto specs = specs_of(study_of(with("/measure/over", R"("maximum")")));
    auto outcome = executed(specs[0], never);
    const auto errors = outcome.run.errors;
    time_again(specs[0], outcome, {.most = 3}, never);
    CHECK(outcome.run.status == Status::ok);
    CHECK(outcome.run.errors == errors);
}

TEST_CASE("timing: a study's runs are timed one by one, and give the same errors", "[unit]") {
    const Study study = study_of(tests::sample_document());
    const auto plain = run_all(study, {.jobs = 2, .progress = {}});
    const auto runs = run_all(study, {.jobs = 2, .progress = {}, .timing = TimingRule{.most = 2}});
    REQUIRE(runs.size() == plain.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        CHECK(runs[i].errors == plain[i].errors);
        CHECK_FALSE(plain[i].repeats);
        REQUIRE(runs[i].repeats);
    }
}

TEST_CASE("timing: after a run that passes its time limit, dearer ones of its solver are not run", "[alarm]") {
    auto document = with("/sweep", R"({"cells": [200000, 4, 100000], "dt": 1e-6, "path": "space"})");
    document["timeout_s"] = 0.02;
    document["measure"]["at"] = 1e-3;
    document["allow"] = "timed_out";
    const auto runs = run_all(study_of(document), {.jobs = 1, .progress = {}, .timing = TimingRule{.most = 1}});
    CHECK(runs[0].status == Status::timed_out);
    CHECK(runs[0].id == 0);
    CHECK(runs[0].h > 0);
    CHECK_THAT(runs[0].reason, ContainsSubstring("not run"));
    CHECK(runs[1].status == Status::ok);
    CHECK(runs[2].status == Status::timed_out);
    CHECK_THAT(runs[2].reason, ContainsSubstring("passed its time limit"));
}

#include "studies/engine/engine.hpp"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "studies/engine/judge.hpp"
#include "studies/engine/measure.hpp"
#include "studies/engine/run.hpp"

namespace ordo::studies {
namespace {

bool needs_reference(const Quantity& quantity) { return quantity.against == Against::finest; }

/// Counts ended runs and tells the listener, one call at a time.
class Counter {
public:
    Counter(const EngineOptions& options, const std::vector<RunSpec>& specs) : options_(options) {
        now_.total = static_cast<int>(specs.size());
        for (const auto& spec : specs) planned_ += spec.cost;
    }
    void begins() {
        const std::lock_guard lock(mutex_);
        ++now_.running;
    }
    void ends(const Run& run, double cost) {
        const std::lock_guard lock(mutex_);
        --now_.running;
        ++now_.done;
        done_ += cost;
        now_.work_done = planned_ > 0 ? done_ / planned_ : 1;
        now_.last = &run;
        if (options_.progress) options_.progress(now_);
    }

private:
    const EngineOptions& options_;
    std::mutex mutex_;
    Progress now_;
    double planned_ = 0;
    double done_ = 0;
};

/// The most expensive first, so that threads end together; to be timed, the cheapest first.
std::vector<std::size_t> order_of(const std::vector<RunSpec>& specs, bool timed) {
    std::vector<std::size_t> order(specs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
        return timed ? specs[a].cost < specs[b].cost : specs[a].cost > specs[b].cost;
    });
    return order;
}

/// Runs one after the other, each timed, until one of the same solver has passed the time limit.
class Timer {
public:
    explicit Timer(const TimingRule& rule) : rule_(rule) {}

    RunOutcome operator()(const RunSpec& spec, const std::function<bool()>& stop) {
        RunOutcome outcome;
        if (late_.contains(spec.solver.label)) {
            outcome.run = planned_run(spec);
            outcome.run.status = Status::timed_out;
            outcome.run.reason = "not run: one of less work has passed its time limit";
            return outcome;
        }
        outcome = executed(spec, stop);
        if (outcome.run.status == Status::timed_out) late_.insert(spec.solver.label);
        time_again(spec, outcome, rule_, stop);
        return outcome;
    }

private:
    TimingRule rule_;
    std::set<std::string> late_;  ///< labels of solvers
};

/// Every run on a pool; outcomes stand by the place of their spec, whoever made them.
std::vector<RunOutcome> outcomes_of(const std::vector<RunSpec>& specs, const EngineOptions& options, bool keep) {
    std::vector<RunOutcome> outcomes(specs.size());
    const auto stop = [&] {
        return options.interrupted != nullptr && options.interrupted->load(std::memory_order_relaxed);
    };
    Counter counter(options, specs);
    std::optional<Timer> timer;
    if (options.timing) timer.emplace(*options.timing);
    boost::asio::thread_pool pool(timer ? 1 : static_cast<std::size_t>(options.jobs));
    for (const std::size_t i : order_of(specs, timer.has_value())) {
        boost::asio::post(pool, [&, i] {
            if (stop()) return;
            counter.begins();
            try {
                outcomes[i] = timer ? (*timer)(specs[i], stop) : executed(specs[i], stop);
            } catch (const solvers::Interrupted&) {
                return;
            }
            if (!keep) outcomes[i].snapshot.reset();
            counter.ends(outcomes[i].run, specs[i].cost);
        });
    }
    pool.join();
    if (stop()) throw StudyInterrupted{};
    return outcomes;
}

/// Along each line of refinement in time, compares every run with the one of smallest dt.
void compare_with_finest(const Study& study, std::vector<RunOutcome>& outcomes) {
    std::vector<Run> runs;
    for (const auto& outcome : outcomes) runs.push_back(outcome.run);
    for (const auto& series : lines_of(study, runs)) {
        auto& reference = outcomes[static_cast<std::size_t>(series.runs.back())];
        if (reference.run.status == Status::ok) reference.run.status = Status::reference;
        for (const int id : series.runs) {
            auto& outcome = outcomes[static_cast<std::size_t>(id)];
            if (!outcome.snapshot || !reference.snapshot || &outcome == &reference) continue;
            for (const auto& quantity : study.measure.quantities) {
                if (!needs_reference(quantity)) continue;
                outcome.run.errors.push_back(
                    {quantity.key(), error_against(quantity, *outcome.snapshot, *reference.snapshot)});
            }
        }
    }
}

}  // namespace

std::vector<Run> run_all(const Study& study, const EngineOptions& options) {
    const auto specs = specs_of(study);
    const auto& quantities = study.measure.quantities;
    const bool references = std::any_of(quantities.begin(), quantities.end(), needs_reference);
    auto outcomes = outcomes_of(specs, options, references);
    if (references) compare_with_finest(study, outcomes);
    std::vector<Run> runs;
    for (auto& outcome : outcomes) runs.push_back(std::move(outcome.run));
    return runs;
}

}  // namespace ordo::studies

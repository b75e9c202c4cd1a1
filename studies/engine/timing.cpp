#include "studies/engine/timing.hpp"

#include <algorithm>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "studies/engine/thread_time.hpp"

namespace ordo::studies {
namespace {

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

/// Positions, weights and fields to the last bit: the errors follow from them.
bool same_bits(const solvers::Snapshot& a, const solvers::Snapshot& b) {
    const auto alike = [](const Field& one, const Field& other) { return same_bits(one.values, other.values); };
    return same_bits(a.X, b.X) && same_bits(a.x, b.x) && same_bits(a.weights, b.weights) &&
           std::ranges::equal(a.fields, b.fields, alike);
}

/// One sample: the run from its start to its end, `times` over, in one piece.
struct Sample {
    double seconds = 0;  ///< of one run
    solvers::Snapshot end;
};

Sample sample_of(const RunSpec& spec, int times, const solvers::Interrupt& interrupt, const Parts& parts) {
    const auto problem = parts.scene(spec.scene.name).problem(spec.scene.values);
    const auto& solver = parts.solver(spec.solver.name);
    std::unique_ptr<solvers::Simulation> simulation;
    double helpers = 0;
    const double begin = thread_seconds();
    for (int k = 0; k < times; ++k) {
        simulation = solver.start(problem, spec.solver.options, spec.resolution, spec.measure.fields);
        simulation->advance_to(spec.t_end, interrupt);
        helpers += simulation->helper_seconds();
    }
    const double seconds = (thread_seconds() - begin + helpers) / times;
    return {seconds, simulation->snapshot()};
}

bool enough(const std::vector<double>& samples, double used, const TimingRule& rule) {
    const int count = static_cast<int>(samples.size());
    if (count >= rule.most || (count > 0 && used >= rule.seconds)) return true;
    return count >= rule.least && statistics_of(samples).spread <= rule.spread;
}

/// How many runs of so many seconds a sample takes to last about `rule.shortest`.
int times_within(double seconds, const TimingRule& rule) {
    return static_cast<int>(std::clamp(std::ceil(rule.shortest / std::max(seconds, 1e-9)), 1.0, 1e4));
}

/// Where errors are over all steps, the run that was measured stopped between them, and may end in other last bits.
bool in_one_piece(const RunSpec& spec) { return std::ranges::none_of(spec.measure.quantities, &Quantity::maximum); }

void set_times(Run& run, const std::vector<double>& samples) {
    const auto [median, spread, count] = statistics_of(samples);
    run.seconds = median;
    run.repeats = Repeats{count, spread};
}

}  // namespace

TimeStatistics statistics_of(std::vector<double> samples) {
    if (samples.empty()) throw std::logic_error("no samples of a time");
    const double median = boost::math::statistics::median(samples);
    const int count = static_cast<int>(samples.size());
    if (count < 2) return {median, std::nan(""), count};
    // Boost 1.74's own median_absolute_deviation leaves out the subtraction of the centre.
    for (double& sample : samples) sample = std::abs(sample - median);
    return {median, boost::math::statistics::median(samples) / median, count};
}

void time_again(const RunSpec& spec, RunOutcome& outcome, const TimingRule& rule, const std::function<bool()>& stop,
                const Parts& parts) {
    Run& run = outcome.run;
    if (run.status != Status::ok) return;
    if (run.seconds >= rule.seconds) return set_times(run, {run.seconds});
    std::optional<solvers::Snapshot> end;
    if (in_one_piece(spec)) end = outcome.snapshot;
    std::vector<double> samples;
    double used = 0;
    while (!enough(samples, used, rule)) {
        // The run that was measured met cold caches; what follows is known better from sample to sample.
        const int times = times_within(samples.empty() ? run.seconds : samples.back(), rule);
        auto [seconds, now] = sample_of(spec, times, stop, parts);
        if (end && !same_bits(*end, now)) {
            run.status = Status::failed;
            run.reason = "does not repeat itself: repetition " + std::to_string(samples.size() + 1) +
                         " ended in other bits than the run before it";
            run.errors.clear();
            outcome.snapshot.reset();
            return;
        }
        end = std::move(now);
        samples.push_back(seconds);
        used += times * seconds;
    }
    set_times(run, samples);
}

RunOutcome Timer::operator()(const RunSpec& spec, const std::function<bool()>& stop) {
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

}  // namespace ordo::studies

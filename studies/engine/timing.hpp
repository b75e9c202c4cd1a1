#pragma once
// Run times as statistics: a run that came to its end, repeated until its median is well known.
#include <set>
#include <string>
#include <vector>

#include "studies/engine/run.hpp"

namespace ordo::studies {

/// When the repetitions of a run are enough: the spread is small, or one of the bounds is reached.
struct TimingRule {
    double spread = 0.02;    ///< small enough, of at least `least` samples
    int least = 5;           ///< samples before a spread is believed
    int most = 25;           ///< samples at most
    double seconds = 1;      ///< no sample begins when those before it took so long together [s]
    double shortest = 1e-3;  ///< a shorter run is repeated within each sample until one lasts about so long [s]
};

/// Median of the samples [s], their spread and number. The spread is the median absolute deviation over the median; NaN
/// for one sample. Throws std::logic_error where there is none.
struct TimeStatistics {
    double median = 0;
    double spread = 0;
    int samples = 0;
};
TimeStatistics statistics_of(std::vector<double> samples);

/// Repeats a run that came to its end and puts the median into its `seconds`, spread and number beside it. The run that
/// was measured is the warm-up and no sample, unless it took longer than `rule.seconds`; then it is the only one. Each
/// sample is start, steps and end in one piece, without measuring. A repetition that does not end in the same bits
/// makes the run a failed one. `stop` ends it by Interrupted.
void time_again(const RunSpec& spec, RunOutcome& outcome, const TimingRule& rule, const std::function<bool()>& stop,
                const Parts& parts = house_parts());

/// Runs one after the other, each timed, until one of the same solver has passed the time limit.
class Timer {
public:
    explicit Timer(const TimingRule& rule) : rule_(rule) {}

    RunOutcome operator()(const RunSpec& spec, const std::function<bool()>& stop);

private:
    TimingRule rule_;
    std::set<std::string> late_;  ///< labels of solvers
};

}  // namespace ordo::studies

#pragma once
// The engine: from a study to its runs.
#include <atomic>
#include <functional>
#include <optional>

#include "studies/engine/result.hpp"
#include "studies/engine/timing.hpp"

namespace ordo::studies {

/// Told as runs end, from the worker that ended it, one call at a time.
struct Progress {
    int done = 0;
    int running = 0;
    int total = 0;
    double work_done = 0;  ///< share of the planned work that has ended, 0 to 1
    const Run* last = nullptr;
};

struct EngineOptions {
    int jobs = 1;                                    ///< worker threads
    std::function<void(const Progress&)> progress;   ///< may be empty
    const std::atomic<bool>* interrupted = nullptr;  ///< set from outside to stop between two steps
    /// Runs are then timed by repetition, one at a time whatever `jobs` says, the cheapest first; where one passes its
    /// time limit, dearer ones of its solver are not run.
    std::optional<TimingRule> timing = {};
};

/// Thrown when `interrupted` was set; nothing of the study is kept.
struct StudyInterrupted : std::exception {};

/// All runs of the study, in the order of its sweep; the same bits for any number of jobs. Throws InputError, before
/// anything runs, where scene, solver and resolution do not go together.
std::vector<Run> run_all(const Study& study, const EngineOptions& options);

}  // namespace ordo::studies

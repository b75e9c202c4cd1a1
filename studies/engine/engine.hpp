#pragma once
// The engine: from a study to its runs.
#include <atomic>
#include <functional>
#include <optional>
#include <string>

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

/// Runs that have been made already, by their description (description.hpp). Asked before the first run, told from
/// any worker.
class FinishedRuns {
public:
    virtual ~FinishedRuns() = default;
    /// Its figures; id, label, axes and plan are the asker's.
    virtual std::optional<Run> find(const std::string& description) = 0;
    virtual void keep(const std::string& description, const Run& run) = 0;
};

struct EngineOptions {
    int jobs = 1;                                    ///< worker threads
    std::function<void(const Progress&)> progress;   ///< may be empty
    const std::atomic<bool>* interrupted = nullptr;  ///< set from outside to stop between two steps
    /// Runs are then timed by repetition, one at a time whatever `jobs` says, the cheapest first; where one passes its
    /// time limit, dearer ones of its solver are not run.
    std::optional<TimingRule> timing = {};
    FinishedRuns* finished = nullptr;  ///< null: every run is made
};

/// Thrown when `interrupted` was set; of the study nothing is kept but its finished runs.
struct StudyInterrupted : std::exception {};

/// All runs of the study, in the order of its sweep; the same bits for any number of jobs. Equal runs are made once.
/// Throws InputError, before anything runs, where scene, solver and resolution do not go together.
std::vector<Run> run_all(const Study& study, const EngineOptions& options);

}  // namespace ordo::studies

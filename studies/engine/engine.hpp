#pragma once
// The engine: from a study to its runs.
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "studies/engine/result.hpp"
#include "studies/engine/timing.hpp"

namespace ordo::studies {

/// Told as runs end, from the worker that ended it, of one study one call at a time.
struct Progress {
    std::size_t study = 0;  ///< its place in the call
    int done = 0;
    int running = 0;
    int total = 0;
    double work_done = 0;  ///< share of the planned work that has ended, 0 to 1
    double seconds = 0;    ///< since the study began
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
    int jobs = 1;                                        ///< worker threads
    std::function<void(const Progress&)> progress = {};  ///< may be empty
    const std::atomic<bool>* interrupted = nullptr;      ///< set from outside to stop between two steps
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

/// Several studies, one after the other, through one pool of workers: one that finds no run of a study left goes on to
/// the next study, unless runs are timed. Equal runs of two studies are made once where `finished` keeps them. Each
/// study's runs are those of `run_all`.
class Engine {
public:
    Engine(std::vector<const Study*> studies, EngineOptions options);
    /// Ends what still runs.
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    struct Outcome {
        std::vector<Run> runs;
        double seconds = 0;  ///< from the study's beginning to its last run's end
    };
    /// Waits for the runs of the next study. Throws StudyInterrupted, and what went wrong outside of a run.
    Outcome next();

private:
    struct Pool;
    std::unique_ptr<Pool> pool_;
};

}  // namespace ordo::studies

#pragma once
// The runs of one study as tasks for a pool of workers; engine.hpp is what others call.
#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "studies/engine/engine.hpp"
#include "studies/engine/run.hpp"
#include "studies/engine/timing.hpp"

namespace ordo::studies {

/// Runs that are found, compared or stopped together, coarse to fine: one alone; all of a line where the others are
/// compared with its finest; or all of a line where coarse runs may decide that finer ones are skipped.
struct Line {
    Series series;
    std::vector<std::size_t> runs = {};
    std::vector<std::string> descriptions = {};  ///< of these runs
    std::optional<std::size_t> twin = {};        ///< an earlier line of equal runs
    std::size_t left = 0;                        ///< runs still to be made
};

/// Work for one worker, which may throw.
struct Task {
    double cost = 0;
    std::vector<std::string> descriptions = {};  ///< of the runs that it makes or waits for
    std::function<void()> work;
};

class Crew {
public:
    /// `place` is that of the study in the call, `stop` says that runs are to end by Interrupted.
    Crew(const Study& study, std::size_t place, const EngineOptions& options, std::function<bool()> stop);

    /// Descriptions of all runs.
    std::vector<std::string> descriptions() const;
    /// Takes what has been made already; the rest is returned in the order in which it is best begun. The tasks may be
    /// worked on from several threads, while the crew stays where it is.
    std::vector<Task> begin();
    /// After all tasks.
    Engine::Outcome end();

private:
    void find_finished(Line& line);
    void make(Line& line, std::size_t i);
    void go_down(Line& line);
    void copy_from_twin(const Line& line);
    void compare_with_finest(const Line& line);
    void keep(const Line& line, std::size_t place);
    void begins();
    void ends(std::size_t i);
    double seconds() const;

    const Study& study_;
    const EngineOptions& options_;
    std::function<bool()> stop_;
    std::optional<Timer> timer_;  ///< where runs are timed, one at a time
    std::vector<RunSpec> specs_;
    std::vector<Run> runs_;
    std::vector<std::optional<solvers::Snapshot>> shots_;  ///< where runs are compared, until they are
    std::vector<bool> found_;                              ///< not to be made
    std::vector<Line> lines_;
    bool compares_ = false;
    std::mutex mutex_;
    Progress now_;
    double planned_ = 0;
    double done_ = 0;
    std::chrono::steady_clock::time_point begin_;
};

}  // namespace ordo::studies

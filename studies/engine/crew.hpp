#pragma once
// The runs of one study on their way through a pool of workers; engine.hpp is what others call.
#include <functional>
#include <mutex>
#include <optional>
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

class Crew {
public:
    Crew(const Study& study, const EngineOptions& options);
    /// Throws StudyInterrupted, and what went wrong outside of a run.
    std::vector<Run> all_runs();

private:
    struct Task {
        double cost = 0;
        std::function<void()> work;
    };

    std::vector<Task> tasks();
    void find_finished(Line& line);
    void make(Line& line, std::size_t i);
    void go_down(Line& line);
    void copy_from_twin(const Line& line);
    void compare_with_finest(const Line& line);
    void keep(const Line& line, std::size_t place);
    void begins();
    void ends(std::size_t i);
    bool stop() const;

    const Study& study_;
    const EngineOptions& options_;
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
};

}  // namespace ordo::studies

#pragma once
// What a terminal shows: the progress of a study, and colour where it is wanted.
#include <chrono>
#include <string>

#include "studies/engine/engine.hpp"

namespace ordo::app {

/// Progress on stderr: one line that is written over on a terminal, one line a run otherwise.
class ProgressLine {
public:
    explicit ProgressLine(std::string study);
    ~ProgressLine();
    void show(const studies::Progress& progress);

private:
    std::string study_;
    bool live_;  ///< stderr is a terminal that can write over a line
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// The verdict's word, green, red or yellow on a terminal unless NO_COLOR is set and not empty.
std::string shown(studies::Verdict verdict);

}  // namespace ordo::app

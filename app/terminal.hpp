#pragma once
// What a terminal shows: the progress of a study, and colour where it is wanted.
#include <mutex>
#include <string>
#include <vector>

#include "studies/engine/engine.hpp"

namespace ordo::app {

/// Progress of several studies on stderr, of one after the other: one line that is written over on a terminal, one line
/// a run otherwise. What a later study has to say is held until its turn. May be told from several threads.
class ProgressLines {
public:
    explicit ProgressLines(std::vector<std::string> studies);
    ~ProgressLines();
    void show(const studies::Progress& progress);
    /// Leaves the line to others until `next`; after the last run of a study.
    void wipe() const;
    /// It is the next study's turn.
    void next();

private:
    std::vector<std::string> studies_;
    bool live_;  ///< stderr is a terminal that can write over a line
    std::mutex mutex_;
    std::size_t turn_ = 0;
    std::vector<std::string> held_;  ///< of each study
};

/// The verdict's word, green, red or yellow on a terminal unless NO_COLOR is set and not empty.
std::string shown(studies::Verdict verdict);

}  // namespace ordo::app

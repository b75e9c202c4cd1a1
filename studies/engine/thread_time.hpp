#pragma once
// The clock that runs are timed by.
#include <ctime>

namespace ordo::studies {

/// Processor time that this thread has used [s]; waiting, and what other threads do, is not in it.
inline double thread_seconds() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace ordo::studies

#pragma once
// Threads that work together on pieces of a step.
#include <atomic>
#include <exception>
#include <functional>
#include <list>
#include <thread>
#include <vector>

namespace ordo::solvers::mpm::fast {

/// Threads that wait for work beside the one that calls. A wait is a short while of looking, then sleep. Ended with its
/// owner; of one caller at a time.
class Team {
public:
    explicit Team(int members);  ///< with the caller; fewer where the system gives no more threads
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;
    ~Team();

    int members() const { return static_cast<int>(workers_.size()) + 1; }
    /// job(member) once by each, the caller being member 0; returns when all are done. Rethrows what the first of the
    /// members threw.
    void run(const std::function<void(int)>& job);
    double helper_seconds() const;  ///< processor time of all but the caller, up to the end of their last job [s]

private:
    /// Each in its own line of the cache.
    struct alignas(64) Worker {
        std::atomic<double> seconds = 0;
        std::thread thread;
    };

    void work(Worker& worker, int member);
    void attempt(int member);

    std::list<Worker> workers_;
    std::vector<std::exception_ptr> faults_;  ///< by members
    const std::function<void(int)>* job_ = nullptr;
    bool ends_ = false;
    alignas(64) std::atomic<unsigned> call_ = 0;  ///< how often there was work
    alignas(64) std::atomic<unsigned> busy_ = 0;  ///< workers that are not done
};

}  // namespace ordo::solvers::mpm::fast

#include "solvers/mpm/fast/team.hpp"

#include <ctime>
#include <system_error>

namespace ordo::solvers::mpm::fast {
namespace {

double thread_seconds() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Looks again some tens of microseconds long, about as long as waking a sleeper takes, and lets others run meanwhile.
void wait_while(const std::atomic<unsigned>& number, unsigned value) {
    for (int look = 0; look < 100; ++look) {
        if (number.load(std::memory_order_acquire) != value) return;
        std::this_thread::yield();
    }
    number.wait(value, std::memory_order_acquire);
}

}  // namespace

Team::Team(int members) : faults_(static_cast<std::size_t>(members)) {
    try {
        for (int member = 1; member < members; ++member) {
            auto& worker = workers_.emplace_back();
            worker.thread = std::thread([this, &worker, member] { work(worker, member); });
        }
    } catch (const std::system_error&) {
        workers_.pop_back();
    }
}

Team::~Team() {
    ends_ = true;
    ++call_;
    call_.notify_all();
    for (auto& worker : workers_) worker.thread.join();
}

void Team::run(const std::function<void(int)>& job) {
    job_ = &job;
    busy_ = static_cast<unsigned>(workers_.size());
    ++call_;
    call_.notify_all();
    attempt(0);
    for (unsigned busy = busy_; busy != 0; busy = busy_) wait_while(busy_, busy);
    std::exception_ptr first;
    for (auto& fault : faults_) {
        if (!first) first = fault;
        fault = nullptr;
    }
    if (first) std::rethrow_exception(first);
}

void Team::attempt(int member) {
    try {
        (*job_)(member);
    } catch (...) {
        faults_[static_cast<std::size_t>(member)] = std::current_exception();
    }
}

void Team::work(Worker& worker, int member) {
    for (unsigned call = 0;; ++call) {
        wait_while(call_, call);
        if (ends_) return;
        attempt(member);
        worker.seconds = thread_seconds();
        if (--busy_ == 0) busy_.notify_one();
    }
}

double Team::helper_seconds() const {
    double sum = 0;
    for (const auto& worker : workers_) sum += worker.seconds;
    return sum;
}

}  // namespace ordo::solvers::mpm::fast

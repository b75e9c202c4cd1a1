#include "studies/engine/engine.hpp"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <set>
#include <utility>

#include "studies/engine/crew.hpp"

namespace ordo::studies {
namespace {

/// A study on its way.
struct Station {
    std::optional<Crew> crew = {};
    std::optional<Engine::Outcome> outcome = {};
    std::exception_ptr wrong = {};
    std::size_t left = 0;  ///< tasks
};

}  // namespace

/// The queue holds the tasks of a study and, behind them, the beginning of the next one.
struct Engine::Pool {
    Pool(std::vector<const Study*> studies_, EngineOptions options_)
        : studies(std::move(studies_)),
          options(std::move(options_)),
          stations(studies.size()),
          workers(options.timing ? 1 : static_cast<std::size_t>(options.jobs)) {}

    bool stopped() const {
        return quit.load(std::memory_order_relaxed) ||
               (options.interrupted != nullptr && options.interrupted->load(std::memory_order_relaxed));
    }

    void post_beginning(std::size_t k) {
        if (k == studies.size()) return;
        boost::asio::post(workers, [this, k] { begin(k); });
    }

    /// Each run that equals one on its way in an earlier study waits for that; all of those have been begun.
    void begin(std::size_t k) {
        auto& station = stations[k];
        std::vector<Task> tasks;
        try {
            station.crew.emplace(*studies[k], k, options, [this] { return stopped(); });
            wait_for(station.crew->descriptions());
            if (!stopped()) tasks = station.crew->begin();
        } catch (...) {
            station.wrong = std::current_exception();
        }
        if (tasks.empty()) end(k);
        else post(k, std::move(tasks));
        if (!options.timing) post_beginning(k + 1);
    }

    void post(std::size_t k, std::vector<Task> tasks) {
        const std::lock_guard lock(mutex);
        stations[k].left = tasks.size();
        for (auto& task : tasks) {
            under_way.insert(task.descriptions.begin(), task.descriptions.end());
            boost::asio::post(workers, [this, k, task = std::move(task)] { work_on(k, task); });
        }
    }

    void wait_for(const std::vector<std::string>& descriptions) {
        std::unique_lock lock(mutex);
        changed.wait(lock, [&] {
            return std::ranges::none_of(descriptions, [&](const auto& text) { return under_way.contains(text); });
        });
    }

    void work_on(std::size_t k, const Task& task) {
        std::exception_ptr wrong;
        try {
            if (!stopped()) task.work();
        } catch (const solvers::Interrupted&) {
        } catch (...) {
            wrong = std::current_exception();
        }
        bool last = false;
        {
            const std::lock_guard lock(mutex);
            for (const auto& text : task.descriptions) under_way.erase(under_way.find(text));
            if (wrong) stations[k].wrong = wrong;
            last = --stations[k].left == 0;
        }
        changed.notify_all();
        if (last) end(k);
    }

    void end(std::size_t k) {
        auto outcome = stopped() || stations[k].wrong ? Outcome{} : stations[k].crew->end();
        const std::lock_guard lock(mutex);
        stations[k].outcome = std::move(outcome);
        stations[k].crew.reset();
        changed.notify_all();
    }

    std::vector<const Study*> studies;
    EngineOptions options;
    std::vector<Station> stations;
    std::size_t next = 0;
    std::multiset<std::string> under_way;  ///< descriptions of tasks that have not ended
    std::atomic<bool> quit{false};
    std::mutex mutex;
    std::condition_variable changed;
    boost::asio::thread_pool workers;
};

Engine::Engine(std::vector<const Study*> studies, EngineOptions options)
    : pool_(std::make_unique<Pool>(std::move(studies), std::move(options))) {
    if (!pool_->options.timing) pool_->post_beginning(0);
}

Engine::~Engine() {
    pool_->quit = true;
    pool_->workers.join();
}

Engine::Outcome Engine::next() {
    const std::size_t k = pool_->next++;
    if (pool_->options.timing) pool_->post_beginning(k);
    auto& station = pool_->stations.at(k);
    std::unique_lock lock(pool_->mutex);
    pool_->changed.wait(lock, [&] { return station.outcome.has_value(); });
    if (pool_->stopped()) throw StudyInterrupted{};
    if (station.wrong) std::rethrow_exception(station.wrong);
    return *std::exchange(station.outcome, std::nullopt);
}

std::vector<Run> run_all(const Study& study, const EngineOptions& options) {
    return Engine({&study}, options).next().runs;
}

}  // namespace ordo::studies

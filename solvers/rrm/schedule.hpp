#pragma once
// When each front acts next, and which one is first.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ordo::solvers::rrm {

/// A tournament over slots: each inner node holds the earlier of its two children's times. A change climbs to the root,
/// for a processor guesses badly how far it matters; the first slot is found down from there. Both are log2(n) steps.
class Schedule {
public:
    static constexpr double never = std::numeric_limits<double>::infinity();

    double first_time() const { return times_[1]; }

    /// The slot with the earliest time, the lowest one among equals.
    int first() const {
        std::size_t node = 1;
        while (node < leaves_) node = 2 * node + (times_[2 * node] != times_[node]);
        return static_cast<int>(node - leaves_);
    }

    void set(int slot, double time) {
        std::size_t node = leaves_ + static_cast<std::size_t>(slot);
        double* const times = times_.data();
        times[node] = time;
        while (node > 1) {
            time = std::min(time, times[node ^ 1]);
            node /= 2;
            times[node] = time;
        }
    }

    /// Room for `slots`; times that are set stay.
    void reserve(std::size_t slots) {
        if (slots <= leaves_) return;
        const std::vector<double> old(times_.begin() + static_cast<std::ptrdiff_t>(leaves_), times_.end());
        while (leaves_ < slots) leaves_ *= 2;
        times_.assign(2 * leaves_, never);
        for (std::size_t slot = 0; slot < old.size(); ++slot) set(static_cast<int>(slot), old[slot]);
    }

private:
    std::size_t leaves_ = 1;
    std::vector<double> times_{never, never};
};

}  // namespace ordo::solvers::rrm

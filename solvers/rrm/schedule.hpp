#pragma once
// When each front acts next, and which one is first.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ordo::solvers::rrm {

/// A tournament over slots: each inner node holds the earliest of its four children's times. A change climbs to the
/// root, for a processor guesses badly how far it matters; the first slot is found down from there. Both are log4(n)
/// steps, each of which waits for the one before, so that four children are faster than two.
class Schedule {
public:
    static constexpr double never = std::numeric_limits<double>::infinity();

    double first_time() const { return times_[0]; }

    /// The slot with the earliest time, the lowest one among equals.
    int first() const {
        std::size_t node = 0;
        while (node < first_leaf_) {
            const double least = times_[node];
            const double* const child = times_.data() + 4 * (node + 1);
            const bool after_0 = child[0] > least;
            const bool after_1 = after_0 & (child[1] > least);
            const bool after_2 = after_1 & (child[2] > least);
            node = 4 * (node + 1) + (std::size_t{after_0} + after_1 + after_2);
        }
        return static_cast<int>(node - first_leaf_);
    }

    void set(int slot, double time) {
        std::size_t node = first_leaf_ + static_cast<std::size_t>(slot);
        double* const times = times_.data();
        times[node] = time;
        while (node > 0) {
            const double others = std::min(std::min(times[node ^ 1], times[node ^ 2]), times[node ^ 3]);
            time = std::min(time, others);
            node = node / 4 - 1;
            times[node] = time;
        }
    }

    /// Room for `slots`; times that are set stay.
    void reserve(std::size_t slots) {
        const std::size_t room = times_.size() - first_leaf_;
        if (slots <= room) return;
        const std::vector<double> old(times_.begin() + static_cast<std::ptrdiff_t>(first_leaf_), times_.end());
        std::size_t leaves = room;
        while (leaves < slots) {
            leaves *= 4;
            first_leaf_ = 4 * (first_leaf_ + 1);
        }
        times_.assign(first_leaf_ + leaves, never);
        for (std::size_t slot = 0; slot < old.size(); ++slot) set(static_cast<int>(slot), old[slot]);
    }

private:
    std::size_t first_leaf_ = 0;  ///< the children of node i are the four from 4 (i + 1); 1 to 3 are no nodes
    std::vector<double> times_{never};
};

}  // namespace ordo::solvers::rrm

#pragma once
// Parts of a row of cells or nodes that a step may change. What lies between them is quiet, and is not touched.
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace ordo::solvers {

/// Indices from <= i < to.
struct Stretch {
    std::size_t from = 0;
    std::size_t to = 0;

    std::size_t size() const { return to - from; }
    bool operator==(const Stretch&) const = default;
};

/// Neighbours with at most this many indices between them are one: so few cost less than a loop of their own.
inline constexpr std::size_t no_gap = 16;

/// One more behind `rising`, united with the last one where they overlap or have no gap between them.
inline void append(std::vector<Stretch>& rising, const Stretch& next) {
    if (!rising.empty() && next.from <= rising.back().to + no_gap)
        rising.back().to = std::max(rising.back().to, next.to);
    else rising.push_back(next);
}

/// Unites all that append would. Allocates nothing.
inline void unite_near(std::vector<Stretch>& rising) {
    std::size_t last = 0;
    for (std::size_t i = 1; i < rising.size(); ++i) {
        if (rising[i].from <= rising[last].to + no_gap) rising[last].to = std::max(rising[last].to, rising[i].to);
        else rising[++last] = rising[i];
    }
    if (!rising.empty()) rising.resize(last + 1);
}

/// Indices within all of them.
inline std::size_t total(std::span<const Stretch> stretches) {
    std::size_t sum = 0;
    for (const Stretch& s : stretches) sum += s.size();
    return sum;
}

}  // namespace ordo::solvers

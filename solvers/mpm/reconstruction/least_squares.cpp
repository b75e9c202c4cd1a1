#include "solvers/mpm/reconstruction/least_squares.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/mpm/reconstruction/least_squares_kernels.hpp"

namespace ordo::solvers::mpm {
namespace {

using Window = MovingLeastSquares::Window;

/// From a window nearby to that about `at`; false where there are not `fewest` particles.
bool widen(std::span<const double> x, Window& window, double at, double& radius, std::size_t fewest) {
    if (x.size() < fewest) return false;
    auto& [first, last] = window;
    while (first > 0 && x[first - 1] > at - radius) --first;
    while (first < x.size() && x[first] <= at - radius) ++first;
    last = std::max(last, first);
    while (last < x.size() && x[last] < at + radius) ++last;
    while (last > first && x[last - 1] >= at + radius) --last;
    while (last - first < fewest) {
        const bool left = first > 0 && (last == x.size() || at - x[first - 1] <= x[last] - at);
        if (left) --first;
        else ++last;
        radius = std::max(radius, 1.2 * std::abs(x[left ? first : last - 1] - at));
    }
    return true;
}

}  // namespace

bool MovingLeastSquares::fit(std::span<const double> x, std::span<const double> places, double radius,
                             std::size_t fewest) {
    windows_.clear();
    groups_.clear();
    std::size_t rows = 0;
    Window window;
    for (std::size_t from = 0; from < places.size(); from += together) {
        Neighbours near{};
        Window span{x.size(), 0};
        for (std::size_t lane = 0; lane < together; ++lane) {  // behind the last place it stands again
            const double at = places[std::min(from + lane, places.size() - 1)];
            double wide = radius;
            if (!widen(x, window, at, wide, fewest)) return false;
            windows_.push_back(window);
            span = {std::min(span.first, window.first), std::max(span.last, window.last)};
            near.at[lane] = at;
            near.per_radius[lane] = 1 / wide;
            near.widened = near.widened || wide > radius;
        }
        groups_.push_back({span, rows});
        rows += span.last - span.first;
        if (phi_.size() < rows) phi_.resize(2 * rows);
        near.x = x.subspan(span.first, span.last - span.first);
        near.first = span.first;
        near.windows = &windows_[from];
        near.phi = &phi_[groups_.back().phi];
        if (!weigh(degree_, set_, near)) return false;
    }
    return true;
}

void MovingLeastSquares::sample(std::span<const double> f, std::span<double> out) const {
    sum_up(set_, {groups_, phi_, f, out});
}

double MovingLeastSquares::weight(std::size_t place, std::size_t p) const {
    const auto& [span, phi] = groups_[place / together];
    return phi_[phi + p - span.first][place % together];
}

}  // namespace ordo::solvers::mpm

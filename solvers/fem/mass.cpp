#include "solvers/fem/mass.hpp"

#include <algorithm>
#include <numeric>

namespace ordo::solvers::fem {

Mass::Mass(int cells, double element_mass, bool lumped, std::array<bool, 2> held)
    : diagonal_(cells + 1, lumped ? element_mass : element_mass * 2 / 3),
      beside_(lumped ? 0 : element_mass / 6),
      row_sums_(cells + 1),
      first_(held[0] ? 1 : 0),
      last_(held[1] ? cells - 1 : cells),
      pivots_(cells + 1),
      factor_(cells + 1) {
    diagonal_.front() /= 2;
    diagonal_.back() /= 2;
    for (int i = 0; i <= cells; ++i) {
        row_sums_[i] = (i > 0 ? beside_ : 0) + diagonal_[i] + (i < cells ? beside_ : 0);
    }
    for (int i = first_; i <= last_; ++i) {
        factor_[i] = i > first_ ? beside_ / pivots_[i - 1] : 0;
        pivots_[i] = diagonal_[i] - factor_[i] * beside_;
    }
}

double Mass::accelerate(std::span<const double> f, std::span<double> a, std::span<const Stretch> nodes) const {
    const int end = static_cast<int>(a.size()) - 1;
    if (beside_ == 0) {
        for (const Stretch& s : nodes) {
            const int to = std::min(static_cast<int>(s.to), last_ + 1);
            for (int i = std::max(static_cast<int>(s.from), first_); i < to; ++i) a[i] = f[i] / pivots_[i];
        }
    } else {
        solve(f, a);
    }
    double reactions = 0;
    if (first_ > 0) reactions += reaction(0, 1, f, a);
    if (last_ < end) reactions += reaction(end, end - 1, f, a);
    return reactions;
}

/// The free nodes of the coupled system.
void Mass::solve(std::span<const double> f, std::span<double> a) const {
    const int end = static_cast<int>(a.size()) - 1;
    if (first_ > last_) return;
    for (int i = first_; i <= last_; ++i) a[i] = f[i];
    if (first_ > 0) a[first_] -= beside_ * a[0];
    if (last_ < end) a[last_] -= beside_ * a[end];
    for (int i = first_ + 1; i <= last_; ++i) a[i] -= factor_[i] * a[i - 1];
    for (int i = first_; i <= last_; ++i) a[i] /= pivots_[i];
    for (int i = last_; i > first_; --i) a[i - 1] -= factor_[i] * a[i];
}

double Mass::total() const { return std::accumulate(row_sums_.begin(), row_sums_.end(), 0.0); }

}  // namespace ordo::solvers::fem

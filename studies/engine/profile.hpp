#pragma once
// A field on cells side by side on a line: uniform in each of them, or with a linear rise across it.
#include <span>

namespace ordo::studies {

/// edges [n + 1], rising [m]; means over the cells and, where there are any, rises across them [n], in the field's
/// unit.
struct Profile {
    std::span<const double> edges;
    std::span<const double> means;
    std::span<const double> rises = {};

    std::size_t cells() const { return means.size(); }
    double rise(std::size_t cell) const { return rises.empty() ? 0 : rises[cell]; }
    double at_left(std::size_t cell) const { return means[cell] - 0.5 * rise(cell); }
    double at_right(std::size_t cell) const { return means[cell] + 0.5 * rise(cell); }
    /// At x within a cell.
    double at(std::size_t cell, double x) const {
        const double a = edges[cell], b = edges[cell + 1];
        return means[cell] + rise(cell) * ((x - a) - 0.5 * (b - a)) / (b - a);
    }

    /// The place nearest to `x` within [from, to] where the profile passes `level`: inside a cell, or at an edge where
    /// it jumps over it. NaN where it does so nowhere [m].
    double crossing(double level, double x, double from, double to) const;
};

}  // namespace ordo::studies

#pragma once
// Linear shape functions: the tent of each node, seen from inside one cell.
#include <array>

namespace ordo::solvers::mpm {

/// In a cell, at the local coordinate xi in [0, 1]: the two tents that live there and their slopes times h.
struct Linear {
    static constexpr int width = 2;  ///< nodes that a particle touches along one axis
    static constexpr std::array<double, width> values(double xi) { return {1 - xi, xi}; }
    static constexpr std::array<double, width> slopes(double /*xi*/) { return {-1, 1}; }
};

}  // namespace ordo::solvers::mpm

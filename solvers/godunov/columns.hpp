#pragma once
// Cells as columns of numbers, so that a loop over them runs several at a time.
#include <vector>

#include "solvers/media/medium.hpp"

namespace ordo::solvers::godunov {

/// Contents of n cells or faces, one column each.
struct Columns {
    std::vector<double> mass, momentum, energy;

    explicit Columns(std::size_t n) : mass(n), momentum(n), energy(n) {}

    std::size_t size() const { return mass.size(); }
    Contents operator[](std::size_t i) const { return {mass[i], momentum[i], energy[i]}; }
    void set(std::size_t i, const Contents& q) {
        mass[i] = q.mass;
        momentum[i] = q.momentum;
        energy[i] = q.energy;
    }
};

}  // namespace ordo::solvers::godunov

#pragma once
// Plain loops over particles in any order: to the grid, over the nodes, back.
#include <array>
#include <vector>

#include "bench/reference/wave.hpp"

namespace ordo::bench {

/// The grid and the numbers of a step.
struct ScalarGrid {
    std::array<int, 3> cells{1, 1, 1};  ///< along each axis, margin included
    std::array<int, 3> stride{};        ///< from a node to the next along each axis
    std::array<double, 3> lower{};      ///< [m]
    double inv_h, dt, lambda, mu;
    bool walls, free_end;
    std::vector<double> nodes;  ///< [node]: m, momentum or velocity, force or acceleration
};

class Scalar {
public:
    /// `in_registers`: the sums of a bar's cell are kept until a particle of another cell comes; one dimension only.
    explicit Scalar(const Wave& wave, bool in_registers = false);

    void step() { step_(grid_, p_); }
    const Particles& particles() const { return p_; }
    double bytes_per_particle() const;

private:
    Particles p_;
    ScalarGrid grid_;
    void (*step_)(ScalarGrid&, Particles&);
};

}  // namespace ordo::bench

#pragma once
// The loops of moving least squares: vectors over neighbouring places, compiled for each set of instructions. The same
// bits with each.
#include "solvers/mpm/reconstruction/least_squares.hpp"

namespace ordo::solvers::mpm {

/// Neighbouring places and the particles that their windows span.
struct Neighbours {
    std::span<const double> x;  ///< of particles from `first` on
    std::size_t first;
    MovingLeastSquares::Lanes at, per_radius;
    const MovingLeastSquares::Window* windows;  ///< of each place
    bool widened;                               ///< a radius reaches beyond its window
    MovingLeastSquares::Lanes* phi;             ///< to be filled, one a particle
};

/// phi of a polynomial of the given degree. False where the particles do not determine it at one of the places.
bool weigh(int degree, InstructionSet set, const Neighbours& near);

/// A field of the particles, and what becomes of it at the places.
struct Sampled {
    std::span<const MovingLeastSquares::Group> groups;
    std::span<const MovingLeastSquares::Lanes> phi;
    std::span<const double> f;
    std::span<double> out;
};

void sum_up(InstructionSet set, const Sampled& sampled);

}  // namespace ordo::solvers::mpm

#pragma once
// A part of a sweep that one thread goes over, and what has come of it.
#include <limits>
#include <vector>

#include "solvers/mpm/fast/slots.hpp"

namespace ordo::solvers::mpm::fast {

template <int dim>
class FastMpm;

/// What particles have told in a sweep.
template <int dim>
struct Told {
    static constexpr long none = std::numeric_limits<long>::max();

    bool on_face = false;
    bool dirty = false;    ///< another set of blocks has particles or is awake
    bool missed = false;   ///< a particle came where no sweep was
    bool finite = true;    ///< all positions are
    long lost = none;      ///< first particle that has left the grid
    long inverted = none;  ///< that is turned inside out
    long crossings = 0;
    Vec<dim> load = Vec<dim>::Zero();  ///< [N]
};

/// A run of the blocks in a sweep's order. Its nodes are none of the section's after the next, and its slots its own:
/// so every second section may be swept at the same time.
template <int dim>
struct alignas(64) Section {
    long begin = 0;  ///< in the order
    long end = 0;
    int first = 0, last = 0;            ///< numbers of the blocks that it seats travellers in, ends included
    Pool pool;                          ///< unused where the section is the only one
    std::vector<Traveller<dim>> later;  ///< to blocks beyond, or without slot: seated when all sections are swept
    Told<dim> told;
};

/// A traveller's turn to be seated.
struct Turn {
    int block, place;  ///< that it comes from, and where there: rank and lane
    std::size_t who;
};

/// A thread's own: what it sweeps, and who travels there.
template <int dim>
struct alignas(64) Hand {
    FastMpm<dim>* of = nullptr;
    Section<dim>* section = nullptr;
    std::vector<Traveller<dim>> leaving, waiting;  ///< in this piece of the section, since an earlier one
    std::vector<Turn> turns;                       ///< of those that leave
};

}  // namespace ordo::solvers::mpm::fast

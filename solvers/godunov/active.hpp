#pragma once
// Which cells a step can change.
#include <span>
#include <vector>

#include "solvers/godunov/columns.hpp"
#include "solvers/stretches.hpp"

namespace ordo::solvers::godunov {

/// Stretches of a row of cells, kept around the places where two neighbours differ in any bit. Where all that an update
/// reads is equal, the fluxes through both faces are, bit by bit, and the cell keeps its contents: skipping it is exact
/// at any velocity. The cells at both ends always belong to a stretch, though it may be empty: what passes the ends is
/// counted. A stretch is tightened from its two ends only.
class Active {
public:
    /// All cells, until find: `cells` without the `ghosts` >= reach beyond each end; an update reads `reach` cells on
    /// each side.
    Active(const Stretch& cells, std::size_t ghosts, std::size_t reach);

    /// Those that differences reach.
    void find(const Columns& q);

    /// After a step that changed cells of the stretches, and ghosts. Costs the number of stretches, and no more where
    /// they do not shrink.
    void follow(const Columns& q);

    std::span<const Stretch> stretches() const { return stretches_; }

private:
    Stretch around(std::size_t first, std::size_t last) const;
    void tighten(Stretch& s, const Columns& q) const;

    Stretch cells_;  ///< without ghosts
    std::size_t ghosts_;
    std::size_t reach_;
    std::vector<Stretch> stretches_;
};

}  // namespace ordo::solvers::godunov

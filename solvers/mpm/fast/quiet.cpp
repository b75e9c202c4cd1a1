// Which blocks are awake, and what a sweep goes over.
#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/mpm/fast/fast.hpp"

namespace ordo::solvers::mpm::fast {

/// The blocks to sweep, and the nodes that they touch: those awake, and around them 4 degree cells, no more than a
/// block has. A step of two gathers wakes 2 degree cells more; the first gather of the next reaches one degree further,
/// and the nodes on which its stress acts have their mass, from the step before, from cells one more degree away.
template <int dim>
void FastMpm<dim>::arrange() {
    dirty_ = false;
    mark_swept();
    order_.clear();
    watched_.clear();
    in_sweep_ = 0;
    auto& blocks = slots_.blocks();
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const bool before = std::exchange(blocks[b].swept, near_[b] != 0 && blocks[b].first >= 0);
        if (!blocks[b].swept) continue;
        if (!before) slots_.each_in(blocks[b], [&](Seat seat) { joined_ += slots_.at(seat, Row<dim>::m); });
        order_.push_back(static_cast<int>(b));
        if (!everywhere_ && !blocks[b].awake) watched_.push_back(static_cast<int>(b));
        in_sweep_ += slots_.particles_in(static_cast<int>(b));
    }
    list_runs();
    cut();
}

template <int dim>
void FastMpm<dim>::mark_swept() {
    const auto& blocks = slots_.blocks();
    for (std::size_t b = 0; b < blocks.size(); ++b) near_[b] = everywhere_ || blocks[b].awake;
    if (everywhere_) return;
    int step = 1;
    for (int axis = 0; axis < dim; ++axis) {
        const int n = slots_.blocks_along(axis);
        const int reach = axis == 0 ? 1 : 4 * grid_.degree;
        // Along each line forth and back: how far the last awake block lies behind.
        for (int b = 0; b < static_cast<int>(blocks.size()); ++b) {
            if (b / step % n != 0) continue;
            seen_row_.assign(static_cast<std::size_t>(n), 0);
            for (const bool back : {false, true}) {
                int behind = reach + 1;
                for (int k = 0; k < n; ++k) {
                    const int along = back ? n - 1 - k : k;
                    behind = near_[static_cast<std::size_t>(b + along * step)] != 0 ? 0 : behind + 1;
                    if (behind <= reach) seen_row_[static_cast<std::size_t>(along)] = 1;
                }
            }
            for (int k = 0; k < n; ++k)
                near_[static_cast<std::size_t>(b + k * step)] = seen_row_[static_cast<std::size_t>(k)];
        }
        step *= n;
    }
}

template <int dim>
void FastMpm<dim>::list_runs() {
    std::fill(seen_.begin(), seen_.end(), static_cast<unsigned char>(0));
    const int across = dim > 1 ? grid_.degree : 0;
    const int deep = dim > 2 ? grid_.degree : 0;
    for (const int b : order_) {
        const long node = slots_.blocks()[static_cast<std::size_t>(b)].node;
        for (int k = 0; k <= deep; ++k) {
            for (int j = 0; j <= across; ++j) {
                const long run = node + j * slots_.row_of_nodes(1) + k * slots_.row_of_nodes(2);
                seen_[static_cast<std::size_t>(run / lanes)] = 1;
                seen_[static_cast<std::size_t>(run / lanes + 1)] = 1;
            }
        }
    }
    runs_.clear();
    for (std::size_t run = 0; run < seen_.size(); ++run) {
        if (seen_[run] != 0) runs_.push_back(static_cast<long>(run) * lanes);
    }
}

/// Blocks that a sweep has reached: what moves or is stressed there wakes them; what is less than `rest` is put to
/// rest.
template <int dim>
void FastMpm<dim>::wake() {
    using R = Row<dim>;
    const auto restless = [&](Seat seat) {
        bool any = false;
        for (int row = R::v; row < R::m; ++row) {
            const double size = std::abs(slots_.at(seat, row));
            any = any || !(size <= (row < R::sigma ? rest_v_ : rest_sigma_));
        }
        return any;
    };
    for (const int number : watched_) {
        Block& block = slots_.blocks()[static_cast<std::size_t>(number)];
        if (block.awake) continue;
        slots_.each_in(block, [&](Seat seat) { block.awake = block.awake || restless(seat); });
        dirty_ = dirty_ || block.awake;
        if (block.awake) continue;
        slots_.each_in(block, [&](Seat seat) {
            for (int row = R::v; row < R::m; ++row) slots_.at(seat, row) = 0;
        });
    }
}

template <int dim>
void FastMpm<dim>::wake_loaded() {
    for (const auto& cell : boundary_.cell) {
        Block& block = slots_.blocks()[static_cast<std::size_t>(slots_.block_at(cell))];
        dirty_ = dirty_ || !block.awake;
        block.awake = true;
    }
}

template class FastMpm<1>;
template class FastMpm<2>;
template class FastMpm<3>;

}  // namespace ordo::solvers::mpm::fast

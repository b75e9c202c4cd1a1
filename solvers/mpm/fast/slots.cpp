#include "solvers/mpm/fast/slots.hpp"

#include <algorithm>

namespace ordo::solvers::mpm::fast {
namespace {

template <int dim>
Cell<dim> nearest_cell(const Grid<dim>& grid, const Vec<dim>& x) {
    Cell<dim> cell = Cell<dim>::Constant(nowhere);
    Vec<dim> xi;
    if (grid.locate(x, cell, xi)) return cell;
    for (int axis = 0; axis < dim; ++axis) {
        const double r = std::clamp((x[axis] - grid.lower[axis]) / grid.h, 0.0, grid.cells[axis] - 1.0);
        cell[axis] = std::isfinite(r) ? static_cast<int>(r) : 0;
    }
    return cell;
}

}  // namespace

template <int dim>
Slots<dim>::Slots(const Grid<dim>& grid, const Particles<dim>& particles, bool total)
    : lower_(grid.lower), h_(grid.h), total_(total) {
    using R = Row<dim>;
    rows_ = total ? R::of_total : particles.F.empty() ? R::of_updated : R::of_updated_with_F;
    along_[0] = (grid.cells[0] + lanes - 1) / lanes;
    node_row_[1] = lanes * (along_[0] + 1L);
    for (int axis = 1; axis < dim; ++axis) {
        along_[axis] = grid.cells[axis];
        if (axis == 1) node_row_[2] = node_row_[1] * (grid.cells[1] + grid.degree);
    }
    blocks_.resize(static_cast<std::size_t>(along_[0]) * static_cast<std::size_t>(along_[1] * along_[2]));
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const int number = static_cast<int>(b);
        Block& block = blocks_[b];
        block.cell[0] = lanes * (number % along_[0]);
        block.cell[1] = number / along_[0] % along_[1];
        block.cell[2] = number / along_[0] / along_[1];
        block.node = block.cell[0] + block.cell[1] * node_row_[1] + block.cell[2] * node_row_[2];
    }
    // Chains of the length that each block needs, side by side in memory; then the particles.
    std::vector<int> count(blocks_.size() * lanes, 0);
    std::vector<Cell<dim>> cells;
    for (const auto& x : total ? particles.X : particles.x) {
        cells.push_back(nearest_cell(grid, x));
        ++count[static_cast<std::size_t>(block_at(cells.back()) * lanes + cells.back()[0] % lanes)];
    }
    std::size_t needed = 0;
    const auto longest = [&](std::size_t b) {
        return *std::max_element(count.begin() + static_cast<long>(b) * lanes,
                                 count.begin() + static_cast<long>(b + 1) * lanes);
    };
    for (std::size_t b = 0; b < blocks_.size(); ++b) needed += static_cast<std::size_t>(longest(b));
    reserve(needed + needed / 8 + 2 * blocks_.size() / static_cast<std::size_t>(along_[0]) + lanes);
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        for (int k = longest(b); k > 0; --k) append(static_cast<int>(b), pool_);
    }
    for (std::size_t p = 0; p < cells.size(); ++p)
        fill(seat_in(block_at(cells[p]), cells[p][0] % lanes, pool_), particles, p);
}

template <int dim>
void Slots<dim>::reserve(std::size_t slots) {
    data_.reserve(slots * static_cast<std::size_t>(rows_));
    id_.reserve(slots * lanes);
    for (auto* list : {&next_, &block_of_, &rank_, &taken_}) list->reserve(slots);
}

template <int dim>
int Slots<dim>::block_at(const Cell<dim>& cell) const {
    int number = cell[0] / lanes;
    if constexpr (dim > 1) number += along_[0] * cell[1];
    if constexpr (dim > 2) number += along_[0] * along_[1] * cell[2];
    return number;
}

template <int dim>
Cell<dim> Slots<dim>::cell(Seat seat) const {
    const Block& block = blocks_[static_cast<std::size_t>(block_of(seat.slot))];
    Cell<dim> cell;
    for (int axis = 0; axis < dim; ++axis) cell[axis] = block.cell[axis];
    cell[0] += seat.lane;
    return cell;
}

template <int dim>
int Slots<dim>::particles_in(int block) const {
    int sum = 0;
    each_in(blocks_[static_cast<std::size_t>(block)], [&](Seat) { ++sum; });
    return sum;
}

template <int dim>
int Slots<dim>::take_from(Pool& pool) {
    const int slot = pool.first;
    if (slot >= 0) {
        pool.first = next_[static_cast<std::size_t>(slot)];
        --pool.count;
        return slot;
    }
    if (&pool != &pool_) return -1;
    data_.resize(data_.size() + static_cast<std::size_t>(rows_));
    id_.resize(id_.size() + lanes);
    for (auto* list : {&next_, &block_of_, &rank_, &taken_}) list->push_back(0);
    return static_cast<int>(next_.size()) - 1;
}

template <int dim>
void Slots<dim>::put_into(Pool& pool, int slot) {
    next_[static_cast<std::size_t>(slot)] = pool.first;
    pool.first = slot;
    ++pool.count;
}

template <int dim>
void Slots<dim>::stock(Pool& pool, int wanted) {
    while (pool.count < wanted) put_into(pool, take_from(pool_));
    while (pool.count > 2 * wanted) put_into(pool_, take_from(pool));
}

template <int dim>
int Slots<dim>::append(int block, Pool& pool) {
    const int slot = take_from(pool);
    if (slot < 0) return slot;
    const auto k = static_cast<std::size_t>(slot);
    int* last = &blocks_[static_cast<std::size_t>(block)].first;
    rank_[k] = 0;
    while (*last >= 0) {
        rank_[k] = rank(*last) + 1;
        last = &next_[static_cast<std::size_t>(*last)];
    }
    *last = slot;
    next_[k] = -1;
    block_of_[k] = block;
    taken_[k] = 0;
    for (int lane = 0; lane < lanes; ++lane) {
        for (int row = 0; row < rows_; ++row) at({slot, lane}, row) = 0;
        empty({slot, lane}, blocks_[static_cast<std::size_t>(block)]);
        for (int axis = 0; axis < dim; ++axis) {
            if (rows_ > Row<dim>::F) at({slot, lane}, Row<dim>::F + axis * (dim + 1)) = 1;
            if (total_) at({slot, lane}, Row<dim>::xi + axis) = 0.5;
        }
    }
    return slot;
}

/// The first empty seat of a cell.
template <int dim>
Seat Slots<dim>::seat_in(int block, int lane, Pool& pool) {
    const int* link = &blocks_[static_cast<std::size_t>(block)].first;
    while (*link >= 0 && id({*link, lane}) != nobody) link = &next_[static_cast<std::size_t>(*link)];
    return {*link >= 0 ? *link : append(block, pool), lane};
}

/// Without mass, mid-cell: whatever is gathered there moves nothing and gives nothing.
template <int dim>
void Slots<dim>::empty(Seat seat, const Block& block) {
    using R = Row<dim>;
    id_[number(seat)] = nobody;
    double* rows = &at(seat, 0);
    rows[R::m * lanes] = 0;
    rows[R::volume * lanes] = 0;
    for (int axis = 0; axis < dim; ++axis)
        rows[(R::x + axis) * lanes] = lower_[axis] + h_ * (block.cell[axis] + (axis == 0 ? seat.lane : 0) + 0.5);
}

template <int dim>
void Slots<dim>::fill(Seat seat, const Particles<dim>& particles, std::size_t p) {
    using R = Row<dim>;
    id_[number(seat)] = static_cast<int>(p) + 1;
    ++taken_[static_cast<std::size_t>(seat.slot)];
    const Cell<dim> in = cell(seat);
    for (int i = 0; i < dim; ++i) {
        at(seat, R::x + i) = particles.x[p][i];
        at(seat, R::v + i) = particles.v[p][i];
        at(seat, R::sigma + i) = particles.sigma[p](i, i);
        for (int j = i + 1; j < dim; ++j) at(seat, R::sigma + dim + i + j - 1) = particles.sigma[p](i, j);
        if (total_) at(seat, R::xi + i) = (particles.X[p][i] - lower_[i]) / h_ - in[i];
    }
    at(seat, R::m) = particles.m[p];
    at(seat, R::volume) = particles.volume[p];
    for (int k = 0; rows_ > R::F && k < dim * dim; ++k) at(seat, R::F + k) = particles.F[p].data()[k];
}

/// visit(row) for those of a particle in the updated frame; most have no F, and their number is known here.
template <int dim>
template <class Visit>
void Slots<dim>::each_row(Visit&& visit) const {
#pragma GCC unroll 14
    for (int row = 0; row < Row<dim>::of_updated; ++row) visit(row);
    for (int row = Row<dim>::of_updated; row < rows_; ++row) visit(row);
}

template <int dim>
void Slots<dim>::take_out(Seat seat, Traveller<dim>& to) {
    const double* rows = &at(seat, 0);
    each_row([&](int row) { to.row[row] = rows[row * lanes]; });
    to.id = id(seat);
    to.from = seat;
    --taken_[static_cast<std::size_t>(seat.slot)];
    empty(seat, blocks_[static_cast<std::size_t>(block_of(seat.slot))]);
}

template <int dim>
void Slots<dim>::seat(const Traveller<dim>& who, Seat seat) {
    double* rows = &at(seat, 0);
    each_row([&](int row) { rows[row * lanes] = who.row[row]; });
    id_[number(seat)] = who.id;
    ++taken_[static_cast<std::size_t>(seat.slot)];
}

template <int dim>
Seat Slots<dim>::put_in(const Traveller<dim>& who, Pool& pool) {
    const Seat at = seat_in(who.block, who.to[0] % lanes, pool);
    if (at.slot >= 0) seat(who, at);
    return at;
}

template <int dim>
void Slots<dim>::close(Seat gap) {
    int last = -1;
    for (int slot = next_[static_cast<std::size_t>(gap.slot)]; slot >= 0;
         slot = next_[static_cast<std::size_t>(slot)]) {
        if (id({slot, gap.lane}) != nobody) last = slot;
    }
    if (last < 0) return;
    Traveller<dim> who;
    take_out({last, gap.lane}, who);
    seat(who, gap);
}

template <int dim>
void Slots<dim>::trim(int block, Pool& pool) {
    for (int* link = &blocks_[static_cast<std::size_t>(block)].first; *link >= 0;) {
        const int slot = *link;
        int& next = next_[static_cast<std::size_t>(slot)];
        if (taken_[static_cast<std::size_t>(slot)] > 0) {
            link = &next;
        } else {
            *link = next;
            put_into(pool, slot);
        }
    }
}

template class Slots<1>;
template class Slots<2>;
template class Slots<3>;

}  // namespace ordo::solvers::mpm::fast

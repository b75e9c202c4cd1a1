#pragma once
// Particles in slots: eight cells side by side along axis 0 make a block, and lane l of its slots holds those of cell
// l.
#include <vector>

#include "solvers/mpm/fast/sweep.hpp"
#include "solvers/mpm/particles.hpp"

namespace ordo::solvers::mpm::fast {

struct alignas(64) Eight {
    double at[lanes];
};

/// One particle among the slots.
struct Seat {
    int slot;
    int lane;
};

/// Slots without particle, in a chain.
struct Pool {
    int first = -1;
    int count = 0;
};

/// A particle between two seats, in one piece.
template <int dim>
struct Traveller {
    double row[Row<dim>::of_updated_with_F];
    Vec<dim> xi;  ///< place in the cell that it comes to [-]
    int id;
    int block;  ///< that it comes to
    Seat from;
    Cell<dim> to;
    bool near;  ///< it comes to stand `beside` a face
    bool far;   ///< from further away than quiet regions reckon with
};

/// The particles of a cell fill the slots of its block from the first on; a slot without particle goes back to the
/// pool. A lane without particle has mass and volume zero.
template <int dim>
class Slots {
public:
    /// All particles where the grid has their place; each beyond it in the cell nearest to it.
    Slots(const Grid<dim>& grid, const Particles<dim>& particles, bool total);

    long rows() const { return rows_; }
    double* data() { return data_.front().at; }
    double& at(Seat seat, int row) { return data_[index(seat.slot, row)].at[seat.lane]; }
    double at(Seat seat, int row) const { return data_[index(seat.slot, row)].at[seat.lane]; }
    const int* next() const { return next_.data(); }
    const int* ids() const { return id_.data(); }
    int id(Seat seat) const { return id_[number(seat)]; }
    int block_of(int slot) const { return block_of_[static_cast<std::size_t>(slot)]; }
    int rank(int slot) const { return rank_[static_cast<std::size_t>(slot)]; }  ///< in its block's chain
    std::vector<Block>& blocks() { return blocks_; }
    const std::vector<Block>& blocks() const { return blocks_; }
    Cell<dim> cell(Seat seat) const;
    int block_at(const Cell<dim>& cell) const;  ///< number of the block that holds a cell
    int blocks_along(int axis) const { return along_[axis]; }
    int particles_in(int block) const;
    long row_of_nodes(int axis) const { return node_row_[axis]; }  ///< from a node to the next along an axis

    void take_out(Seat seat, Traveller<dim>& to);  ///< leaves a gap
    /// Its new seat: the first gap of its cell, or in a slot of the pool after the last; slot -1 where that has none.
    Seat put_in(const Traveller<dim>& who, Pool& pool);
    void close(Seat gap);                ///< the last particle of the cell takes the empty seat
    void trim(int block, Pool& pool);    ///< slots without particle go back to a pool
    Pool& pool() { return pool_; }       ///< the common one; it alone grows where it is empty, and may move all data
    void stock(Pool& pool, int wanted);  ///< from and to the common one: from `wanted` to twice as many

    /// visit(seat) for all particles of a block, or of all.
    template <class Visit>
    void each_in(const Block& block, Visit&& visit) const {
        for (int slot = block.first; slot >= 0; slot = next_[static_cast<std::size_t>(slot)]) {
            for (int lane = 0; lane < lanes; ++lane) {
                if (id_[static_cast<std::size_t>(slot * lanes + lane)] != nobody) visit(Seat{slot, lane});
            }
        }
    }
    template <class Visit>
    void each(Visit&& visit) const {
        for (const Block& block : blocks_) each_in(block, visit);
    }

    static constexpr int nobody = 0;  ///< ids are counted from one, so that a lane without particle reads the first

private:
    static std::size_t number(Seat seat) { return static_cast<std::size_t>(seat.slot * lanes + seat.lane); }
    std::size_t index(int slot, int row) const {
        return static_cast<std::size_t>(slot) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(row);
    }
    void reserve(std::size_t slots);
    int take_from(Pool& pool);  ///< a slot; -1: none
    void put_into(Pool& pool, int slot);
    int append(int block, Pool& pool);  ///< an empty slot; its number
    Seat seat_in(int block, int lane, Pool& pool);
    void empty(Seat seat, const Block& block);
    void seat(const Traveller<dim>& who, Seat seat);
    template <class Visit>
    void each_row(Visit&& visit) const;
    void fill(Seat seat, const Particles<dim>& particles, std::size_t p);

    Vec<dim> lower_;
    double h_;
    int along_[3] = {1, 1, 1};
    long node_row_[3] = {1, 0, 0};
    long rows_;
    bool total_;
    std::vector<Eight> data_;
    std::vector<int> id_, next_, block_of_, rank_, taken_;  ///< of the slots; `taken`: lanes with a particle
    std::vector<Block> blocks_;
    Pool pool_;
};

}  // namespace ordo::solvers::mpm::fast

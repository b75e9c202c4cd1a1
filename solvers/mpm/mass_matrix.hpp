#pragma once
// The grid's mass matrix, and what stands for its inverse.
#include <span>
#include <vector>

#include "solvers/mpm/basis/stencil.hpp"
#include "solvers/mpm/grid.hpp"

namespace ordo::solvers::mpm {

/// A symmetric banded matrix and its factors L D L^T.
class BandedMatrix {
public:
    void reset(int size, int bandwidth);  ///< zero, with `bandwidth` diagonals below the main one
    void add(int i, int j, double value) { rows_[index(i, j)] += value; }  ///< i >= j
    /// M_{first + a, first + b} += factor w_a w_b; as many as the band holds.
    void add_product(int first, std::span<const double> w, double factor);
    double at(int i, int j) const {
        return i - j > band_ || j - i > band_ ? 0 : rows_[i >= j ? index(i, j) : index(j, i)];
    }
    int size() const { return size_; }
    int bandwidth() const { return band_; }
    void isolate(int i);                    ///< row and column i become those of the identity
    int factor();                           ///< the first row whose pivot is lost in round-off, or -1
    void solve(std::span<double> x) const;  ///< after factor(): right-hand side in, solution out
private:
    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(band_ + 1) +
               static_cast<std::size_t>(j - i + band_);
    }

    int size_ = 0;
    int band_ = 0;
    std::vector<double> rows_;  ///< row by row, from the lowest diagonal to the main one
};

/// lumped       m_i
/// consistent   M_ij = sum_p m_p S_ip S_jp, factored with the held nodes taken out; banded as the nodes are numbered:
///              meant for one dimension, and for small grids in more
/// fmpm         (1 + A + ... + A^(k-1)) / m with A = 1 - M / m, in place of the inverse of M.   [Nairn2021]
template <int dim>
class MassMatrix {
public:
    explicit MassMatrix(const Options& options)
        : kind_(options.mass),
          terms_(options.terms),
          series_(kind_ == Mass::fmpm || options.transfer == Transfer::xpic) {}

    /// From the points' masses; m_i must be gathered already. Throws Diverged where M has no inverse.
    void assemble(const Grid<dim>& grid, const Stencils<dim>& stencils, std::span<const double> m);

    /// Solves M x = b, b in `b`, x out. Where a node is held, x is held_values of the same place, or 0 where there are
    /// none; where a node has no mass it is 0.
    void solve(const Grid<dim>& grid, std::vector<Vec<dim>>& b, std::span<const double> held_values) const;

    /// By the series of `terms` terms whatever the kind: XPIC's velocity.
    void solve_by_series(const Grid<dim>& grid, std::vector<Vec<dim>>& b, std::span<const double> held_values) const;

    /// What holding component `axis` of node i has added to the right-hand side f of the last solve, whose result is x.
    double reaction(const Grid<dim>& grid, int i, int axis, std::span<const Vec<dim>> x,
                    std::span<const Vec<dim>> f) const;

private:
    double times(const Grid<dim>& grid, int i, int axis, std::span<const Vec<dim>> x) const;

    void solve_consistent(const Grid<dim>& grid, std::vector<Vec<dim>>& b, std::span<const double> held_values) const;

    Mass kind_;
    int terms_;
    bool series_;  ///< somebody asks for it, so that M must be known
    mutable bool last_by_series_ = false;
    BandedMatrix M_;
    std::vector<BandedMatrix> factors_;  ///< one an axis; a single one where all axes hold the same nodes
    mutable std::vector<double> line_;   ///< scratch
    mutable std::vector<Vec<dim>> increment_, next_;
};

}  // namespace ordo::solvers::mpm

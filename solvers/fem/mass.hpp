#pragma once
// The mass matrix of a bar of equal linear elements.
#include <array>
#include <span>
#include <vector>

#include "solvers/stretches.hpp"

namespace ordo::solvers::fem {

/// Symmetric and tridiagonal, of cells + 1 nodes; an element of mass m_e adds m_e/6 [2 1; 1 2], lumped m_e/2 [1 0; 0
/// 1]. Only the first and the last node can be held. L D L^T of what lies between them is made once; without pivoting
/// it is stable, since the matrix is positive definite. source   [Hughes2000]
class Mass {
public:
    /// element_mass   rho h [kg]      held   whether the first, the last node is held
    Mass(int cells, double element_mass, bool lumped, std::array<bool, 2> held);

    /// M a = f + r for given a at held nodes and r = 0 at free ones.
    ///
    /// f   force, nodes [N]      a   in: acceleration of held nodes; out: of all [m/s^2]
    /// nodes   lumped: those whose a is asked for, both ends among them; consistent: all, since all are coupled
    /// Returns the sum of the reactions r [N]. Exact up to round-off; costs O(nodes), allocates nothing.
    double accelerate(std::span<const double> f, std::span<double> a, std::span<const Stretch> nodes) const;

    std::span<const double> row_sums() const { return row_sums_; }  ///< the lumped mass, nodes [kg]
    double total() const;                                           ///< sum of all entries [kg]

private:
    void solve(std::span<const double> f, std::span<double> a) const;
    double reaction(int node, int neighbour, std::span<const double> f, std::span<const double> a) const {
        return diagonal_[node] * a[node] + beside_ * a[neighbour] - f[node];
    }

    std::vector<double> diagonal_;
    double beside_;  ///< every entry beside the diagonal [kg]
    std::vector<double> row_sums_;
    int first_;                   ///< free node
    int last_;                    ///< free node; below `first_` where there is none
    std::vector<double> pivots_;  ///< D
    std::vector<double> factor_;  ///< L beside its diagonal; entry i belongs to row i
};

}  // namespace ordo::solvers::fem

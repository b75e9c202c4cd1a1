#include "solvers/mpm/mass_matrix.hpp"

#include <algorithm>
#include <string>

#include "solvers/solver.hpp"

namespace ordo::solvers::mpm {

void BandedMatrix::reset(int size, int bandwidth) {
    size_ = size;
    band_ = bandwidth;
    rows_.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(bandwidth + 1), 0.0);
}

void BandedMatrix::add_product(int first, std::span<const double> w, double factor) {
    for (std::size_t a = 0; a < w.size(); ++a) {
        const double share = factor * w[a];
        double* row = &rows_[index(first + static_cast<int>(a), first)];
        for (std::size_t b = 0; b <= a; ++b) row[b] += share * w[b];
    }
}

void BandedMatrix::isolate(int i) {
    for (int j = std::max(0, i - band_); j < i; ++j) rows_[index(i, j)] = 0;
    for (int j = i + 1; j <= std::min(size_ - 1, i + band_); ++j) rows_[index(j, i)] = 0;
    rows_[index(i, i)] = 1;
}

int BandedMatrix::factor() {
    constexpr double lost = 1e-14;  // of the diagonal: what subtracting leaves of it is round-off
    for (int i = 0; i < size_; ++i) {
        const int first = std::max(0, i - band_);
        for (int j = first; j < i; ++j) {
            double sum = rows_[index(i, j)];
            for (int k = std::max(first, j - band_); k < j; ++k) sum -= rows_[index(i, k)] * rows_[index(j, k)];
            rows_[index(i, j)] = sum;  // L_ij D_j until the row is done
        }
        const double diagonal = rows_[index(i, i)];
        double pivot = diagonal;
        for (int j = first; j < i; ++j) {
            const double scaled = rows_[index(i, j)];
            rows_[index(i, j)] = scaled / rows_[index(j, j)];
            pivot -= scaled * rows_[index(i, j)];
        }
        if (!(pivot > lost * diagonal)) return i;
        rows_[index(i, i)] = pivot;
    }
    return -1;
}

void BandedMatrix::solve(std::span<double> x) const {
    const auto at = [&](int i) -> double& { return x[static_cast<std::size_t>(i)]; };
    for (int i = 0; i < size_; ++i) {
        for (int j = std::max(0, i - band_); j < i; ++j) at(i) -= rows_[index(i, j)] * at(j);
    }
    for (int i = size_ - 1; i >= 0; --i) {
        at(i) /= rows_[index(i, i)];
        // The one found last comes last: it is what the sum waits for.
        for (int j = std::min(size_ - 1, i + band_); j > i; --j) at(i) -= rows_[index(j, i)] * at(j);
    }
}

namespace {

bool consecutive(std::span<const int> nodes) {
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        if (nodes[k] != nodes[k - 1] + 1) return false;
    }
    return !nodes.empty();
}

/// How far apart in number two nodes may lie that one point touches.
template <int dim>
int reach(const Stencils<dim>& stencils) {
    int widest = 0;
    for (std::size_t p = 0; p < stencils.points(); ++p) {
        const auto nodes = stencils.nodes(p);
        if (nodes.empty()) continue;
        const auto [first, last] = std::ranges::minmax(nodes);
        widest = std::max(widest, last - first);
    }
    return widest;
}

template <int dim>
bool is_held(const Grid<dim>& grid, int node, int axis) {
    return std::ranges::any_of(grid.held, [&](const Held& held) { return held.node == node && held.axis == axis; });
}

}  // namespace

template <int dim>
void MassMatrix<dim>::assemble(const Grid<dim>& grid, const Stencils<dim>& stencils, std::span<const double> m) {
    if (kind_ == Mass::lumped && !series_) return;
    M_.reset(grid.nodes(), reach(stencils));
    for (std::size_t p = 0; p < stencils.points(); ++p) {
        const auto nodes = stencils.nodes(p);
        if (consecutive(nodes)) {
            M_.add_product(nodes.front(), stencils.weights(p), m[p]);
            continue;
        }
        stencils.row(p, [&](int i, double w_i, const Vec<dim>&) {
            const double share = m[p] * w_i;
            stencils.row(p, [&](int j, double w_j, const Vec<dim>&) {
                if (j <= i) M_.add(i, j, share * w_j);
            });
        });
    }
    if (kind_ != Mass::consistent) return;
    if (factors_.empty()) {
        bool alike = true;
        for (const auto& [node, axis] : grid.held) {
            for (int other = 0; other < dim; ++other) alike = alike && is_held(grid, node, other);
        }
        factors_.resize(alike ? 1 : dim);
    }
    for (int axis = 0; axis < static_cast<int>(factors_.size()); ++axis) {
        BandedMatrix& factors = factors_[static_cast<std::size_t>(axis)];
        factors = M_;
        for (const Held& held : grid.held) {
            if (held.axis == axis) factors.isolate(held.node);
        }
        for (int i = 0; i < grid.nodes(); ++i) {
            if (!(grid.m[static_cast<std::size_t>(i)] > 0)) factors.isolate(i);
        }
        const int lost = factors.factor();
        if (lost >= 0)
            throw Diverged("the consistent mass matrix is singular at node " + std::to_string(lost) +
                           ": too few particles for the functions there");
    }
}

template <int dim>
void MassMatrix<dim>::solve(const Grid<dim>& grid, std::vector<Vec<dim>>& b,
                            std::span<const double> held_values) const {
    last_by_series_ = false;
    if (kind_ == Mass::consistent) return solve_consistent(grid, b, held_values);
    if (kind_ == Mass::fmpm) return solve_by_series(grid, b, held_values);
    for (std::size_t i = 0; i < b.size(); ++i) {
        if (grid.m[i] > 0) b[i] /= grid.m[i];
        else b[i].setZero();
    }
    for (std::size_t k = 0; k < grid.held.size(); ++k) {
        const auto [node, axis] = grid.held[k];
        b[static_cast<std::size_t>(node)][axis] = held_values.empty() ? 0 : held_values[k];
    }
}

template <int dim>
void MassMatrix<dim>::solve_consistent(const Grid<dim>& grid, std::vector<Vec<dim>>& b,
                                       std::span<const double> held_values) const {
    line_.resize(b.size());
    for (int axis = 0; axis < dim; ++axis) {
        for (std::size_t i = 0; i < b.size(); ++i) line_[i] = grid.m[i] > 0 ? b[i][axis] : 0;
        for (std::size_t k = 0; k < grid.held.size(); ++k) {
            const auto [node, held_axis] = grid.held[k];
            if (held_axis != axis || held_values.empty() || held_values[k] == 0) continue;
            const int last = std::min(grid.nodes() - 1, node + M_.bandwidth());
            for (int i = std::max(0, node - M_.bandwidth()); i <= last; ++i)
                line_[static_cast<std::size_t>(i)] -= M_.at(i, node) * held_values[k];
        }
        for (std::size_t k = 0; k < grid.held.size(); ++k) {
            const auto [node, held_axis] = grid.held[k];
            if (held_axis == axis) line_[static_cast<std::size_t>(node)] = held_values.empty() ? 0 : held_values[k];
        }
        factors_[factors_.size() == 1 ? 0 : static_cast<std::size_t>(axis)].solve(line_);
        for (std::size_t i = 0; i < b.size(); ++i) b[i][axis] = line_[i];
    }
}

/// x = sum of increments d(1) = b / m, d(l) = d(l-1) - M d(l-1) / m, each with the held nodes at rest but for the
/// first.
template <int dim>
void MassMatrix<dim>::solve_by_series(const Grid<dim>& grid, std::vector<Vec<dim>>& b,
                                      std::span<const double> held_values) const {
    last_by_series_ = true;
    const auto rule = [&](std::vector<Vec<dim>>& x, std::span<const double> values) {
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (!(grid.m[i] > 0)) x[i].setZero();
        }
        for (std::size_t k = 0; k < grid.held.size(); ++k) {
            const auto [node, axis] = grid.held[k];
            x[static_cast<std::size_t>(node)][axis] = values.empty() ? 0 : values[k];
        }
    };
    for (std::size_t i = 0; i < b.size(); ++i) {
        if (grid.m[i] > 0) b[i] /= grid.m[i];
    }
    rule(b, held_values);
    increment_ = b;
    next_ = b;
    for (int l = 2; l <= terms_; ++l) {
        for (int i = 0; i < grid.nodes(); ++i) {
            const auto k = static_cast<std::size_t>(i);
            next_[k] = increment_[k];
            if (!(grid.m[k] > 0)) continue;
            for (int axis = 0; axis < dim; ++axis) next_[k][axis] -= times(grid, i, axis, increment_) / grid.m[k];
        }
        rule(next_, {});
        std::swap(increment_, next_);
        for (std::size_t i = 0; i < b.size(); ++i) b[i] += increment_[i];
    }
}

template <int dim>
double MassMatrix<dim>::times(const Grid<dim>& grid, int i, int axis, std::span<const Vec<dim>> x) const {
    double sum = 0;
    const int last = std::min(grid.nodes() - 1, i + M_.bandwidth());
    for (int j = std::max(0, i - M_.bandwidth()); j <= last; ++j)
        sum += M_.at(i, j) * x[static_cast<std::size_t>(j)][axis];
    return sum;
}

/// The equation of row i with what it lacks. In a series every increment but the last has been multiplied by M once;
/// the last one, which at a held node is not zero where it is the first too, by m.
template <int dim>
double MassMatrix<dim>::reaction(const Grid<dim>& grid, int i, int axis, std::span<const Vec<dim>> x,
                                 std::span<const Vec<dim>> f) const {
    const auto k = static_cast<std::size_t>(i);
    if (last_by_series_) {
        const double last = grid.m[k] * increment_[k][axis] - times(grid, i, axis, increment_);
        return times(grid, i, axis, x) + last - f[k][axis];
    }
    const double needed = kind_ == Mass::consistent ? times(grid, i, axis, x) : grid.m[k] * x[k][axis];
    return needed - f[k][axis];
}

template class MassMatrix<1>;
template class MassMatrix<2>;
template class MassMatrix<3>;

}  // namespace ordo::solvers::mpm

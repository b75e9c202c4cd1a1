#pragma once
// Sums over stencils: from points to the grid, and back.
#include <algorithm>
#include <vector>

#include "solvers/mpm/basis/stencil.hpp"
#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/particles.hpp"

namespace ordo::solvers::mpm {

/// out_i = sum_p S_ip m_p.
template <int dim>
void scatter_mass(const Stencils<dim>& stencils, std::span<const double> m, std::vector<double>& out) {
    std::fill(out.begin(), out.end(), 0.0);
    for (std::size_t p = 0; p < stencils.points(); ++p)
        stencils.row(p, [&](int i, double w, const Vec<dim>&) { out[static_cast<std::size_t>(i)] += w * m[p]; });
}

/// out_i += sum_p S_ip m_p f_p.
template <int dim>
void scatter(const Stencils<dim>& stencils, std::span<const double> m, std::span<const Vec<dim>> f,
             std::vector<Vec<dim>>& out) {
    for (std::size_t p = 0; p < stencils.points(); ++p) {
        const Vec<dim> amount = m[p] * f[p];
        stencils.row(p, [&](int i, double w, const Vec<dim>&) { out[static_cast<std::size_t>(i)] += w * amount; });
    }
}

/// out_i += sum_p S_ip m_p L_p (x_i - x_p): what an affine velocity field adds to the momentum.
template <int dim>
void scatter_affine(const Grid<dim>& grid, const Stencils<dim>& stencils, std::span<const Vec<dim>> x,
                    std::span<const double> m, std::span<const Tensor<dim>> L, std::vector<Vec<dim>>& out) {
    for (std::size_t p = 0; p < stencils.points(); ++p) {
        stencils.row(p, [&](int i, double w, const Vec<dim>&) {
            out[static_cast<std::size_t>(i)] += w * m[p] * (L[p] * (grid.position(i) - x[p]));
        });
    }
}

/// out_i -= sum_p V_p sigma_p grad S_ip. `nominal(p)` is the stress that goes with the gradients.
template <int dim, class Nominal>
void scatter_stress(const Stencils<dim>& stencils, std::span<const double> volume, Nominal&& nominal,
                    std::vector<Vec<dim>>& out) {
    for (std::size_t p = 0; p < stencils.points(); ++p) {
        const Tensor<dim> pull = volume[p] * nominal(p);
        stencils.row(p,
                     [&](int i, double, const Vec<dim>& grad_w) { out[static_cast<std::size_t>(i)] -= pull * grad_w; });
    }
}

/// sum_i S_ip f_i.
template <int dim>
Vec<dim> value_at(const Stencils<dim>& stencils, std::size_t p, std::span<const Vec<dim>> f) {
    Vec<dim> sum = Vec<dim>::Zero();
    stencils.row(p, [&](int i, double w, const Vec<dim>&) { sum += w * f[static_cast<std::size_t>(i)]; });
    return sum;
}

/// sum_i f_i (x) grad S_ip.
template <int dim>
Tensor<dim> gradient_at(const Stencils<dim>& stencils, std::size_t p, std::span<const Vec<dim>> f) {
    Tensor<dim> sum = Tensor<dim>::Zero();
    stencils.row(
        p, [&](int i, double, const Vec<dim>& grad_w) { sum += f[static_cast<std::size_t>(i)] * grad_w.transpose(); });
    return sum;
}

/// D_p = sum_i S_ip (x_i - x_p)(x_i - x_p)^T [m^2].
template <int dim>
Tensor<dim> spread_at(const Grid<dim>& grid, const Stencils<dim>& stencils, std::size_t p, const Vec<dim>& x) {
    Tensor<dim> sum = Tensor<dim>::Zero();
    stencils.row(p, [&](int i, double w, const Vec<dim>&) {
        const Vec<dim> r = grid.position(i) - x;
        sum += w * r * r.transpose();
    });
    return sum;
}

}  // namespace ordo::solvers::mpm

#pragma once
// The dual-domain basis: tents as shape functions, and a gradient that is continuous across cell faces.
#include <array>

#include "solvers/mpm/basis/tensor.hpp"

namespace ordo::solvers::mpm {

/// grad S~_i = alpha grad S_i + (1 - alpha) sum_j S_j <grad S_i>_j with the nodal means <f>_j = int S_j f / int S_j,
/// alpha = prod_axes 4 xi (1 - xi) / 2: half the tent's gradient amid a cell, none of it on a face.
///
/// Integrals are over the cells beside node j for which occupied(cell) holds: where there is no material, there is none
/// to average over, and no node without mass gets a gradient. source [Zhang2011], with that addition
///
/// Appends the row of a point at the local coordinates xi of `cell`, an occupied one.
template <int dim, class Occupied>
void add_dual_domain(const Grid<dim>& grid, const Cell<dim>& cell, const Vec<dim>& xi, Occupied&& occupied,
                     Stencils<dim>& stencils) {
    constexpr int corners = 1 << dim;
    constexpr int reach = 4;  // nodes along an axis: those of the cell and one more on either side
    const auto bit = [](int k, int axis) { return k >> axis & 1; };
    double alpha = 0.5;
    for (int axis = 0; axis < dim; ++axis) alpha *= 4 * xi[axis] * (1 - xi[axis]);

    std::array<Vec<dim>, 1 << 2 * dim> grad;
    grad.fill(Vec<dim>::Zero());
    for (int j = 0; j < corners; ++j) {
        double S_j = 1;
        for (int axis = 0; axis < dim; ++axis) S_j *= bit(j, axis) == 0 ? 1 - xi[axis] : xi[axis];
        // In units of h: int S_j over a cell is 1/2^dim; along one axis int S_j S_i is 1/3 for i = j, else 1/6, and
        // int S_j dS_i/dr is -+1/2 for the cell's first and second node.
        double volume = 0;
        std::array<Vec<dim>, 1 << 2 * dim> mean;
        mean.fill(Vec<dim>::Zero());
        for (int c = 0; c < corners; ++c) {  // cells beside node j: bit 0 before it, bit 1 behind it
            Cell<dim> beside = cell;
            for (int axis = 0; axis < dim; ++axis) beside[axis] += bit(j, axis) + bit(c, axis) - 1;
            if (!occupied(beside)) continue;
            volume += 1.0 / corners;
            for (int i = 0; i < corners; ++i) {
                int place = 0;
                Vec<dim> part = Vec<dim>::Ones();
                for (int axis = 0, stride = 1; axis < dim; ++axis, stride *= reach) {
                    place += stride * (1 + beside[axis] - cell[axis] + bit(i, axis));
                    const bool is_j = bit(i, axis) != bit(c, axis);  // j is the second node of the cell before it
                    for (int a = 0; a < dim; ++a)
                        part[a] *= a == axis ? (bit(i, axis) == 0 ? -0.5 : 0.5) : is_j ? 1.0 / 3 : 1.0 / 6;
                }
                mean[static_cast<std::size_t>(place)] += part;
            }
        }
        for (std::size_t k = 0; k < grad.size(); ++k) grad[k] += (1 - alpha) * S_j / volume * mean[k];
    }
    for (std::size_t k = 0; k < grad.size(); ++k) {
        int node = 0;
        double w = 1;
        Vec<dim> own = Vec<dim>::Constant(alpha);
        bool inside = true;
        int rest = static_cast<int>(k);
        for (int axis = 0; axis < dim; ++axis, rest /= reach) {
            const int along = rest % reach;
            const double tent = along == 1 ? 1 - xi[axis] : along == 2 ? xi[axis] : 0;
            const double slope = along == 1 ? -1 : along == 2 ? 1 : 0;
            inside = inside && cell[axis] + along >= 1 && cell[axis] + along <= grid.cells[axis] + 1;
            node += (cell[axis] + along - 1) * grid.stride[axis];
            w *= tent;
            for (int a = 0; a < dim; ++a) own[a] *= a == axis ? slope : tent;
        }
        if (inside && (w != 0 || grad[k] != Vec<dim>::Zero())) stencils.add(node, w, (grad[k] + own) / grid.h);
    }
}

}  // namespace ordo::solvers::mpm

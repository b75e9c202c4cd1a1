#pragma once
// Tensor products: the functions of one axis after the other become the row of a point.
#include <array>

#include "solvers/mpm/basis/spline.hpp"
#include "solvers/mpm/basis/stencil.hpp"
#include "solvers/mpm/grid.hpp"

namespace ordo::solvers::mpm {

/// Values and slopes (times h) of the functions along one axis that a point touches, those of the nodes from `first`
/// on. Arrays, or whatever has [] and size().
template <class Values, class Slopes = Values>
struct AlongAxis {
    int first = 0;
    Values value;
    Slopes slope;
};

/// Appends to the open row of `stencils` the products of one function an axis.
template <int dim, class Axis>
void add_products(const Grid<dim>& grid, const std::array<Axis, dim>& axes, Stencils<dim>& stencils) {
    std::array<std::size_t, dim> k{};
    while (k[dim - 1] < axes[dim - 1].value.size()) {
        int node = 0;
        double w = 1;
        Vec<dim> grad_w = Vec<dim>::Constant(1 / grid.h);
        for (int axis = 0; axis < dim; ++axis) {
            const auto& [first, value, slope] = axes[axis];
            node += (first + static_cast<int>(k[axis])) * grid.stride[axis];
            w *= value[k[axis]];
            for (int c = 0; c < dim; ++c) grad_w[c] *= c == axis ? slope[k[axis]] : value[k[axis]];
        }
        stencils.add(node, w, grad_w);
        for (int axis = 0; axis < dim && ++k[axis] == axes[axis].value.size() && axis + 1 < dim; ++axis) k[axis] = 0;
    }
}

/// The splines of `degree` at the local coordinates xi of a cell.
template <int degree, int dim>
void add_splines(const Grid<dim>& grid, const Cell<dim>& cell, const Vec<dim>& xi, Stencils<dim>& stencils) {
    using Numbers = std::array<double, degree + 1>;
    std::array<AlongAxis<Numbers>, dim> axes;
    for (int axis = 0; axis < dim; ++axis) {
        const Spline<degree> spline(cell[axis], xi[axis], grid.cells[axis]);
        axes[axis] = {cell[axis], spline.value, spline.slope};
    }
    add_products<dim>(grid, axes, stencils);
}

}  // namespace ordo::solvers::mpm

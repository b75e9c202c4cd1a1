#pragma once
// The loop over the nodes that one particle touches; everything between particles and grid goes through it.
#include <array>

#include "solvers/mpm/grid.hpp"

namespace ordo::solvers::mpm {

constexpr int power(int base, int exponent) { return exponent == 0 ? 1 : base * power(base, exponent - 1); }

/// visit(node, w, grad_w) for each node that a particle at the local coordinate xi of the cell `base` touches:
/// w its shape value [-], grad_w its gradient [1/m], as tensor products of the 1D functions of Basis.
template <class Basis, int dim, class Visit>
inline void for_each_node(const Grid<dim>& grid, int base, const Vec<dim>& xi, Visit&& visit) {
    constexpr int width = Basis::width;
    std::array<std::array<double, width>, dim> value;
    std::array<std::array<double, width>, dim> slope;
    for (int axis = 0; axis < dim; ++axis) {
        value[axis] = Basis::values(xi[axis]);
        slope[axis] = Basis::slopes(xi[axis]);
    }
    for (int k = 0; k < power(width, dim); ++k) {
        int node = base;
        double w = 1;
        Vec<dim> grad_w = Vec<dim>::Constant(1 / grid.h);
        for (int axis = 0; axis < dim; ++axis) {
            const int along = k / power(width, axis) % width;
            node += along * grid.stride[axis];
            w *= value[axis][along];
            for (int c = 0; c < dim; ++c) grad_w[c] *= c == axis ? slope[axis][along] : value[axis][along];
        }
        visit(node, w, grad_w);
    }
}

/// Calls f with the flag as a compile-time constant, so that a choice made between passes costs nothing inside one.
template <class F>
void with_constant(bool flag, F&& f) {
    if (flag) f(std::true_type{});
    else f(std::false_type{});
}

}  // namespace ordo::solvers::mpm

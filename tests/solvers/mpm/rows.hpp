#pragma once
// Rows of stencils as dense sums, so that a node that stands in a row twice is seen once.
#include <map>
#include <vector>

#include "solvers/mpm/basis/basis.hpp"
#include "tests/solvers/mpm/bodies.hpp"

namespace ordo::solvers::mpm::test {

template <int dim>
struct Entry {
    double w = 0;
    Vec<dim> grad = Vec<dim>::Zero();
};

/// Four cells along each edge of the unit box, held all around.
inline constexpr double quarter = 0.25;
template <int dim>
Grid<dim> unit_grid() {
    SolidScene<dim> scene{.lower = Vec<dim>::Zero(), .upper = Vec<dim>::Ones(), .faces = all_faces<dim>(Face::fixed)};
    return {scene, {}, {.cells = 4, .ppc = 1, .h = quarter, .dt = 1}};
}

/// What one point touches, node by node, and the sums that tell constants and linear fields.
template <int dim>
struct Row {
    std::map<int, Entry<dim>> at;
    double w = 0;                             ///< sum S_i
    Vec<dim> grad = Vec<dim>::Zero();         ///< sum grad S_i
    Vec<dim> x = Vec<dim>::Zero();            ///< sum S_i x_i
    Tensor<dim> slope = Tensor<dim>::Zero();  ///< sum x_i (x) grad S_i

    Row(const Grid<dim>& grid, const Stencils<dim>& stencils, std::size_t p) {
        stencils.row(p, [&](int i, double weight, const Vec<dim>& grad_w) {
            REQUIRE((i >= 0 && i < grid.nodes()));
            at[i].w += weight;
            at[i].grad += grad_w;
            w += weight;
            grad += grad_w;
            x += weight * grid.position(i);
            slope += grid.position(i) * grad_w.transpose();
        });
    }
    Entry<dim> operator[](int i) const { return at.contains(i) ? at.at(i) : Entry<dim>{}; }
};

/// The grid's own functions at x.
template <int dim>
Row<dim> row_at(const Grid<dim>& grid, const Vec<dim>& x) {
    Stencils<dim> stencils;
    Cell<dim> cell = Cell<dim>::Constant(nowhere);
    REQUIRE(fill_at_points<dim>(grid, {&x, 1}, {&cell, 1}, stencils).rows == 1);
    return {grid, stencils, 0};
}

/// Constants and linear fields come out exactly: sums of a few numbers of order one, gradients of order 1/h.
template <int dim>
void check_linear_fields(const Row<dim>& row, const Vec<dim>& x, double h) {
    CHECK(std::abs(row.w - 1) < 2e-14);
    CHECK(row.grad.cwiseAbs().maxCoeff() * h < 2e-14);
    CHECK((row.x - x).cwiseAbs().maxCoeff() < 2e-14);
    CHECK((row.slope - Tensor<dim>::Identity()).cwiseAbs().maxCoeff() < 1e-13);
}

}  // namespace ordo::solvers::mpm::test

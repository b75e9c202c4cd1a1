#include "solvers/mpm/basis/dual_domain.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/rows.hpp"

using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

constexpr double h = quarter;

/// The row of a point where material fills the grid up to the cell `last` along the first axis.
template <int dim>
Row<dim> row(const Cell<dim>& cell, const Vec<dim>& xi, int last = 3) {
    const auto grid = unit_grid<dim>();
    Stencils<dim> stencils;
    const auto occupied = [&](const Cell<dim>& c) {
        return c.minCoeff() >= 0 && c.maxCoeff() < grid.cells[0] && c[0] <= last;
    };
    add_dual_domain<dim>(grid, cell, xi, occupied, stencils);
    stencils.close_row();
    return {grid, stencils, 0};
}

struct BilinearTent {
    double value;
    Vec<2> slope;
};

BilinearTent tent(const Vec<2>& node, const Vec<2>& x) {
    const Vec<2> r = (x - node) / h;
    if (r.cwiseAbs().maxCoeff() >= 1) return {0, Vec<2>::Zero()};
    const Vec<2> N = Vec<2>::Ones() - r.cwiseAbs();
    const Vec<2> sign(r[0] < 0 ? 1 : -1, r[1] < 0 ? 1 : -1);
    return {N.prod(), Vec<2>(sign[0] * N[1], sign[1] * N[0]) / h};
}

/// int S_j grad S_i / int S_j over the grid, by two Gauss points an axis and cell: exact for these products.
Vec<2> nodal_mean(const Grid<2>& grid, int i, int j) {
    Vec<2> sum = Vec<2>::Zero();
    double volume = 0;
    for (int q = 0; q < 8 * 8; ++q) {
        const auto place = [](int k) { return h * (k / 2 + 0.5 + (k % 2 == 0 ? -0.5 : 0.5) / std::sqrt(3.0)); };
        const Vec<2> x(place(q % 8), place(q / 8));
        const double weight = tent(grid.position(j), x).value;
        sum += weight * tent(grid.position(i), x).slope;
        volume += weight;
    }
    return sum / volume;
}

}  // namespace

TEST_CASE("ddmp: on a line the gradient is the closed form", "[unit]") {
    for (const double xi : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const double alpha = 2 * xi * (1 - xi);
        const auto inside = row<1>(Cell<1>(1), Vec<1>(xi));
        // An inner node's means: -1/2 and 1/2 of its neighbours' slopes 1/h.
        CHECK(inside[0].grad[0] * h == Approx(-(1 - alpha) * (1 - xi) / 2).margin(1e-14));
        CHECK(inside[1].grad[0] * h == Approx(-alpha - (1 - alpha) * xi / 2).margin(1e-14));
        CHECK(inside[2].grad[0] * h == Approx(alpha + (1 - alpha) * (1 - xi) / 2).margin(1e-14));
        CHECK(inside[3].grad[0] * h == Approx((1 - alpha) * xi / 2).margin(1e-14));
        CHECK(inside[1].w == 1 - xi);
        CHECK(inside[2].w == xi);
        // At the end of the grid the outermost node has one cell: its mean is that cell's slope.
        const auto first = row<1>(Cell<1>(0), Vec<1>(xi));
        CHECK(first[0].grad[0] * h == Approx(-alpha - (1 - alpha) * ((1 - xi) + xi / 2)).margin(1e-14));
        CHECK(first[1].grad[0] * h == Approx(alpha + (1 - alpha) * (1 - xi)).margin(1e-14));
        CHECK(first[2].grad[0] * h == Approx((1 - alpha) * xi / 2).margin(1e-14));
    }
}

TEST_CASE("ddmp: in the plane the means are those of the definition, by quadrature", "[unit]") {
    const auto grid = unit_grid<2>();
    const Cell<2> cell = GENERATE(Cell<2>(1, 2), Cell<2>(0, 3));
    const Vec<2> xi(0.3, 0.8);
    const Vec<2> x = h * (cell.cast<double>() + xi);
    const double alpha = 0.5 * 4 * xi[0] * (1 - xi[0]) * 4 * xi[1] * (1 - xi[1]);
    const auto found = row<2>(cell, xi);
    for (int i = 0; i < grid.nodes(); ++i) {
        Vec<2> expected = alpha * tent(grid.position(i), x).slope;
        for (int j = 0; j < grid.nodes(); ++j)
            expected += (1 - alpha) * tent(grid.position(j), x).value * nodal_mean(grid, i, j);
        CHECK(found[i].w == Approx(tent(grid.position(i), x).value).margin(1e-15));
        CHECK((found[i].grad - expected).norm() < 1e-13);
    }
}

TEMPLATE_TEST_CASE_SIG("ddmp: the gradient is continuous across every face", "[unit]", ((int dim), dim), 1, 2, 3) {
    const auto grid = unit_grid<dim>();
    for (int axis = 0; axis < dim; ++axis) {
        Cell<dim> cell = Cell<dim>::Constant(1);
        Vec<dim> xi = Vec<dim>::Constant(0.35);
        xi[axis] = 1;
        const auto before = row<dim>(cell, xi);
        cell[axis] += 1;
        xi[axis] = 0;
        const auto after = row<dim>(cell, xi);
        for (int i = 0; i < grid.nodes(); ++i) {
            CHECK((before[i].grad - after[i].grad).norm() < 1e-13);
            CHECK(before[i].w == Approx(after[i].w).margin(1e-15));
        }
    }
}

TEMPLATE_TEST_CASE_SIG("ddmp: constants and linear fields come out exactly, in outer cells too", "[unit]",
                       ((int dim), dim), 1, 2, 3) {
    for (const int along : {0, 1, 3}) {
        const Cell<dim> cell = Cell<dim>::Constant(along);
        const Vec<dim> xi = Vec<dim>::LinSpaced(dim, 0.1, 0.7);
        check_linear_fields<dim>(row<dim>(cell, xi), h * (cell.template cast<double>() + xi), h);
    }
}

TEMPLATE_TEST_CASE_SIG("ddmp: where no material is none is averaged over, and linear fields stay exact", "[unit]",
                       ((int dim), dim), 1, 2, 3) {
    // Cells 0 and 1 along the first axis hold points: node 2 has one of them beside it, as the grid's end has.
    const auto grid = unit_grid<dim>();
    Cell<dim> cell = Cell<dim>::Constant(1);
    const Vec<dim> xi = Vec<dim>::Constant(0.4);
    const auto found = row<dim>(cell, xi, 1);
    check_linear_fields<dim>(found, h * (cell.template cast<double>() + xi), h);
    for (const auto& [node, entry] : found.at) {
        if (grid.position(node)[0] > 0.51) CHECK((entry.w == 0 && entry.grad.isZero(0)));
    }
    // Mirrored, it is the cell at the grid's lower end.
    const auto first = row<1>(Cell<1>(0), Vec<1>(0.6));
    const auto last = row<1>(Cell<1>(1), Vec<1>(0.4), 1);
    for (int i = 0; i < 3; ++i) CHECK(first[i].grad[0] == Approx(-last[2 - i].grad[0]).margin(1e-14));
}

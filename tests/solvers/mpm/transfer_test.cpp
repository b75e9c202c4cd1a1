#include "solvers/mpm/transfer.hpp"

#include <cmath>
#include <random>

#include "solvers/mpm/basis/basis.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo::solvers;
using namespace ordo::solvers::mpm;

namespace {

template <int dim>
Grid<dim> some_grid(BeyondGrid beyond_grid) {
    const Vec<dim> edges = Vec<dim>(Vec<3>(1.0, 0.6, 0.8).head<dim>());
    const auto scene = test::box<dim>(edges, Face::fixed, test::uniform<dim>(Vec<dim>::Zero()));
    return {scene, {.beyond_grid = beyond_grid}, {.cells = 5, .ppc = 1, .h = 0.2, .dt = 1}};
}

/// The row of one point.
template <int dim>
Stencils<dim> row_of(const Grid<dim>& grid, const Vec<dim>& at) {
    Stencils<dim> stencils;
    Cell<dim> cell = Cell<dim>::Constant(nowhere);
    REQUIRE(fill_at_points<dim>(grid, {&at, 1}, {&cell, 1}, stencils).rows == 1);
    return stencils;
}

/// Sums over the nodes of x: w, grad w, w x_i and x_i (x) grad w.
template <int dim>
struct Moments {
    double w = 0;
    Vec<dim> grad = Vec<dim>::Zero();
    Vec<dim> x = Vec<dim>::Zero();
    Tensor<dim> slope = Tensor<dim>::Zero();
    int nodes = 0;
    bool negative = false;

    Moments(const Grid<dim>& grid, const Vec<dim>& at) {
        row_of(grid, at).row(0, [&](int i, double weight, const Vec<dim>& grad_w) {
            w += weight;
            grad += grad_w;
            x += weight * grid.position(i);
            slope += grid.position(i) * grad_w.transpose();
            ++nodes;
            negative = negative || weight < 0;
        });
    }
};

template <int dim>
void check_linear_reproduction(const Grid<dim>& grid, const Vec<dim>& at) {
    // Each sum is of 2^dim numbers below a few units (gradients: below 1/h = 5 times those): a few ulp.
    const Moments<dim> sum(grid, at);
    CHECK(sum.nodes == 1 << dim);
    CHECK(std::abs(sum.w - 1) < 1e-14);
    CHECK(sum.grad.cwiseAbs().maxCoeff() < 1e-13);
    CHECK((sum.x - at).cwiseAbs().maxCoeff() < 1e-14);
    CHECK((sum.slope - Tensor<dim>::Identity()).cwiseAbs().maxCoeff() < 1e-13);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("transfer: the weights are a partition of unity and reproduce linear fields", "[unit]",
                       ((int dim), dim), 1, 2, 3) {
    const auto grid = some_grid<dim>(BeyondGrid::extend);
    std::mt19937 bits(7);
    std::uniform_real_distribution<double> inside(0, 1);
    for (int sample = 0; sample < 100; ++sample) {
        Vec<dim> at;
        for (int axis = 0; axis < dim; ++axis) at[axis] = grid.lower[axis] + inside(bits) * grid.cells[axis] * grid.h;
        check_linear_reproduction<dim>(grid, at);
        CHECK_FALSE(Moments<dim>(grid, at).negative);
    }
    check_linear_reproduction<dim>(grid, grid.lower);                               // on the first node
    check_linear_reproduction<dim>(grid, grid.lower + Vec<dim>::Constant(grid.h));  // on an inner node
}

TEMPLATE_TEST_CASE_SIG("transfer: extrapolated weights still reproduce linear fields", "[unit]", ((int dim), dim), 1, 2,
                       3) {
    const auto grid = some_grid<dim>(BeyondGrid::extrapolate);
    const Vec<dim> before = grid.lower - Vec<dim>::Constant(0.07);
    check_linear_reproduction<dim>(grid, before);
    CHECK(Moments<dim>(grid, before).negative);
    Vec<dim> beyond;
    for (int axis = 0; axis < dim; ++axis) beyond[axis] = grid.lower[axis] + grid.cells[axis] * grid.h + 0.07;
    check_linear_reproduction<dim>(grid, beyond);
}

TEST_CASE("transfer: in 2D each weight and gradient is the bilinear one of its own node", "[unit]") {
    const auto grid = some_grid<2>(BeyondGrid::extend);
    const int base = 3 * grid.stride[0] + 1 * grid.stride[1];
    row_of<2>(grid, grid.lower + 0.2 * Vec<2>(3.25, 1.75)).row(0, [&](int i, double w, const Vec<2>& grad_w) {
        const int a = (i - base) % grid.stride[1];
        const int b = (i - base) / grid.stride[1];
        const double x = a == 0 ? 0.75 : 0.25;
        const double y = b == 0 ? 0.25 : 0.75;
        CHECK(w == Approx(x * y));
        CHECK(grad_w[0] == Approx((a == 0 ? -5 : 5) * y));
        CHECK(grad_w[1] == Approx((b == 0 ? -5 : 5) * x));
    });
}

TEMPLATE_TEST_CASE_SIG("transfer: sums over stencils are those of the formulas, node by node", "[unit]",
                       ((int dim), dim), 1, 2, 3) {
    // Two points of given weights on a grid of few nodes, against sums written out densely.
    const auto grid = some_grid<dim>(BeyondGrid::extend);
    std::vector<Vec<dim>> x{grid.lower + Vec<dim>::Constant(0.13), grid.lower + Vec<dim>::Constant(0.29)};
    std::vector<Cell<dim>> cell(2, Cell<dim>::Constant(nowhere));
    Stencils<dim> stencils;
    REQUIRE(fill_at_points<dim>(grid, std::span<const Vec<dim>>(x), cell, stencils).rows == 2);
    const auto nodes = static_cast<Eigen::Index>(grid.nodes());
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(nodes, 2);
    std::array<Eigen::MatrixXd, 2> G{Eigen::MatrixXd::Zero(nodes, dim), Eigen::MatrixXd::Zero(nodes, dim)};
    Eigen::MatrixXd where(nodes, dim);
    for (int i = 0; i < nodes; ++i) where.row(i) = grid.position(i).transpose();
    for (int p = 0; p < 2; ++p) {
        stencils.row(static_cast<std::size_t>(p), [&](int i, double w, const Vec<dim>& grad_w) {
            S(i, p) += w;
            G[static_cast<std::size_t>(p)].row(i) += grad_w.transpose();
        });
    }
    const std::vector<double> m{1.5, 0.4}, V{0.3, 0.7};
    const std::vector<Vec<dim>> f{Vec<dim>::LinSpaced(dim, 1, 2), Vec<dim>::LinSpaced(dim, -3, 0.5)};
    std::vector<Tensor<dim>> A{Tensor<dim>::Random(), Tensor<dim>::Random()};
    const auto count = static_cast<std::size_t>(nodes);
    std::vector<double> mass(count);
    std::vector<Vec<dim>> sum(count, Vec<dim>::Ones()), affine = sum, stress = sum;  // all but the mass are added to
    scatter_mass<dim>(stencils, m, mass);
    scatter<dim>(stencils, m, f, sum);
    scatter_affine<dim>(grid, stencils, x, m, A, affine);
    scatter_stress<dim>(
        stencils, V, [&](std::size_t p) { return A[p]; }, stress);
    for (int i = 0; i < nodes; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const Vec<dim> x_i = grid.position(i);
        CHECK(mass[k] == Approx(S(i, 0) * m[0] + S(i, 1) * m[1]).epsilon(1e-14));
        Vec<dim> by_hand = Vec<dim>::Ones() + S(i, 0) * m[0] * f[0] + S(i, 1) * m[1] * f[1];
        CHECK((sum[k] - by_hand).norm() < 1e-14);
        by_hand = Vec<dim>::Ones() + S(i, 0) * m[0] * A[0] * (x_i - x[0]) + S(i, 1) * m[1] * A[1] * (x_i - x[1]);
        CHECK((affine[k] - by_hand).norm() < 1e-14);
        by_hand = Vec<dim>::Ones() - V[0] * A[0] * G[0].row(i).transpose() - V[1] * A[1] * G[1].row(i).transpose();
        CHECK((stress[k] - by_hand).norm() < 1e-13);
    }
    for (std::size_t p = 0; p < 2; ++p) {
        const auto column = static_cast<Eigen::Index>(p);
        const Eigen::Map<const Eigen::Matrix<double, dim, Eigen::Dynamic>> values(affine.front().data(), dim, nodes);
        const std::span<const Vec<dim>> of(affine);
        CHECK((value_at<dim>(stencils, p, of) - values * S.col(column)).norm() < 1e-14);
        CHECK((gradient_at<dim>(stencils, p, of) - values * G[p]).norm() < 1e-13);
        const Eigen::MatrixXd from = where.rowwise() - x[p].transpose();
        const Tensor<dim> D = from.transpose() * S.col(column).asDiagonal() * from;
        CHECK((spread_at<dim>(grid, stencils, p, x[p]) - D).norm() < 1e-14);
    }
}

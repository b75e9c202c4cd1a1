#include "solvers/mpm/transfer.hpp"

#include <cmath>
#include <random>

#include "solvers/mpm/linear.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo::solvers;
using namespace ordo::solvers::mpm;

namespace {

template <int dim>
Vec<dim> position_of(const Grid<dim>& grid, int node) {
    Vec<dim> x;
    for (int axis = 0; axis < dim; ++axis) {
        x[axis] = grid.lower[axis] + grid.h * (node / grid.stride[axis] % (grid.cells[axis] + 1));
    }
    return x;
}

template <int dim>
Grid<dim> some_grid(bool extrapolate) {
    const Vec<dim> edges = Vec<dim>(Vec<3>(1.0, 0.6, 0.8).head<dim>());
    const auto scene = test::box<dim>(edges, Face::fixed, test::uniform<dim>(Vec<dim>::Zero()));
    Options options;
    options.extrapolate = extrapolate;
    return {scene, {.cells = 5, .ppc = 1, .h = 0.2, .dt = 1}, options};
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
        int base = 0;
        Vec<dim> xi;
        REQUIRE(grid.locate(at, base, xi));
        for_each_node<Linear, dim>(grid, base, xi, [&](int i, double weight, const Vec<dim>& grad_w) {
            w += weight;
            grad += grad_w;
            x += weight * position_of(grid, i);
            slope += position_of(grid, i) * grad_w.transpose();
            ++nodes;
            negative = negative || weight < 0;
        });
    }
};

template <int dim>
void check_linear_reproduction(const Grid<dim>& grid, const Vec<dim>& at) {
    // Each sum is of 2^dim numbers below a few units (gradients: below 1/h = 5 times those): a few ulp.
    const Moments<dim> sum(grid, at);
    CHECK(sum.nodes == power(2, dim));
    CHECK(std::abs(sum.w - 1) < 1e-14);
    CHECK(sum.grad.cwiseAbs().maxCoeff() < 1e-13);
    CHECK((sum.x - at).cwiseAbs().maxCoeff() < 1e-14);
    CHECK((sum.slope - Tensor<dim>::Identity()).cwiseAbs().maxCoeff() < 1e-13);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("transfer: the weights are a partition of unity and reproduce linear fields", "[unit]",
                       ((int dim), dim), 1, 2, 3) {
    const auto grid = some_grid<dim>(false);
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
    const auto grid = some_grid<dim>(true);
    const Vec<dim> before = grid.lower - Vec<dim>::Constant(0.07);
    check_linear_reproduction<dim>(grid, before);
    CHECK(Moments<dim>(grid, before).negative);
    Vec<dim> beyond;
    for (int axis = 0; axis < dim; ++axis) beyond[axis] = grid.lower[axis] + grid.cells[axis] * grid.h + 0.07;
    check_linear_reproduction<dim>(grid, beyond);
}

TEST_CASE("transfer: in 2D each weight and gradient is the bilinear one of its own node", "[unit]") {
    const auto grid = some_grid<2>(false);
    const Vec<2> xi(0.25, 0.75);
    const int base = 3 * grid.stride[0] + 1 * grid.stride[1];
    for_each_node<Linear, 2>(grid, base, xi, [&](int i, double w, const Vec<2>& grad_w) {
        const int a = (i - base) % grid.stride[1];
        const int b = (i - base) / grid.stride[1];
        const double x = a == 0 ? 0.75 : 0.25;
        const double y = b == 0 ? 0.25 : 0.75;
        CHECK(w == Approx(x * y));
        CHECK(grad_w[0] == Approx((a == 0 ? -5 : 5) * y));
        CHECK(grad_w[1] == Approx((b == 0 ? -5 : 5) * x));
    });
}

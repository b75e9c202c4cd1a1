// GIMP and CPDI against the formulas of the papers, and against quadrature.
#include "solvers/mpm/basis/boxes.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/rows.hpp"

using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

constexpr double h = quarter;

/// N(z) and its antiderivative as in the literature, z in cells from the node.
double N(double z) { return std::max(0.0, 1 - std::abs(z)); }
double I(double z) {
    if (z <= -1) return 0;
    if (z >= 1) return 1;
    return z <= 0 ? 0.5 * (1 + z) * (1 + z) : 1 - 0.5 * (1 - z) * (1 - z);
}

Row<1> gimp(double x, double half) {
    const auto grid = unit_grid<1>();
    Stencils<1> stencils;
    add_gimp<1>(grid, Vec<1>(x), Vec<1>(half), stencils);
    stencils.close_row();
    return {grid, stencils, 0};
}

double tent(const Grid<2>& grid, int node, const Vec<2>& x) {
    const Vec<2> r = (x - grid.position(node)) / h;
    return N(r[0]) * N(r[1]);
}

template <int dim>
Row<dim> row_of_corners(const Grid<dim>& grid, const std::vector<Vec<dim>>& corners) {
    Stencils<dim> stencils;
    add_cpdi2<dim>(grid, corners, stencils);
    stencils.close_row();
    return {grid, stencils, 0};
}

/// Gauss-Legendre on [-1, 1] with six points, from the tables.
struct Gauss6 {
    std::array<double, 6> x{-0.932469514203152, -0.661209386466265, -0.238619186083197,
                            0.238619186083197,  0.661209386466265,  0.932469514203152};
    std::array<double, 6> w{0.171324492379170, 0.360761573048139, 0.467913934572691,
                            0.467913934572691, 0.360761573048139, 0.171324492379170};
};

/// A convex quadrilateral: corners counter-clockwise as in the papers, and in the order of the code.
const std::vector<Vec<2>> counter_clockwise{{0.31, 0.24}, {0.55, 0.33}, {0.61, 0.62}, {0.28, 0.57}};
const std::vector<Vec<2>> axis_0_fastest{counter_clockwise[0], counter_clockwise[1], counter_clockwise[3],
                                         counter_clockwise[2]};

double cross(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

}  // namespace

TEST_CASE("gimp: weights and gradients are the closed form, narrow or wider than a cell", "[unit]") {
    const auto grid = unit_grid<1>();
    for (const double half : {0.01, 0.0625, 0.125, 0.2, 0.3}) {
        for (double x = half + 0.003; x < 1 - half; x += 0.037) {
            const auto row = gimp(x, half);
            const double l = half / h;
            for (int i = 0; i < grid.nodes(); ++i) {
                const double r = x / h - i;
                CHECK(row[i].w == Approx((I(r + l) - I(r - l)) / (2 * l)).margin(1e-13));
                CHECK(row[i].grad[0] * h == Approx((N(r + l) - N(r - l)) / (2 * l)).margin(1e-13));
            }
            check_linear_fields<1>(row, Vec<1>(x), h);
        }
    }
}

TEST_CASE("gimp: the gradient is the derivative of the weight", "[unit]") {
    const auto grid = unit_grid<1>();
    const double half = 0.06;
    const double e = 1e-3;
    for (double x = 0.07; x < 0.93; x += 0.0217) {
        // The weight is quadratic between its kinks' places, where a box's end meets a node.
        const auto near_kink = [&](double end) { return std::abs(end / h - std::round(end / h)) * h < 1.5 * e; };
        if (near_kink(x - half) || near_kink(x + half)) continue;
        const auto row = gimp(x, half);
        const auto before = gimp(x - e, half);
        const auto after = gimp(x + e, half);
        for (int i = 0; i < grid.nodes(); ++i)
            CHECK(row[i].grad[0] == Approx((after[i].w - before[i].w) / (2 * e)).margin(1e-11));
    }
}

TEST_CASE("gimp: a box that reaches beyond the grid is cut there", "[unit]") {
    // [-0.05, 0.15] becomes [0, 0.15]: the mean of a linear field is its value amid that.
    const auto row = gimp(0.05, 0.1);
    CHECK(std::abs(row.w - 1) < 1e-15);
    CHECK(row.x[0] == Approx(0.075));
    CHECK(row.slope(0, 0) == Approx(1));
    CHECK(row[0].w == Approx(1 - 0.3));  // of the tent's flank 1 - x / h, amid [0, 0.15]
    const auto last = gimp(0.97, 0.1);
    CHECK(std::abs(last.w - 1) < 1e-15);
    CHECK(last.x[0] == Approx(0.935));
    CHECK(last[4].grad[0] == Approx(4));  // in one cell
}

TEST_CASE("gimp: in the plane it is the product of one axis and the other", "[unit]") {
    const auto grid = unit_grid<2>();
    Stencils<2> stencils;
    add_gimp<2>(grid, Vec<2>(0.4, 0.61), Vec<2>(0.12, 0.05), stencils);
    stencils.close_row();
    const Row<2> row(grid, stencils, 0);
    const auto x = gimp(0.4, 0.12);
    const auto y = gimp(0.61, 0.05);
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 5; ++j) {
            const auto entry = row[i * grid.stride[0] + j * grid.stride[1]];
            CHECK(entry.w == Approx(x[i].w * y[j].w).margin(1e-15));
            CHECK(entry.grad[0] == Approx(x[i].grad[0] * y[j].w).margin(1e-14));
            CHECK(entry.grad[1] == Approx(x[i].w * y[j].grad[0]).margin(1e-14));
        }
    }
}

TEST_CASE("cpdi: weights and gradients are the published formulas of the plane", "[unit]") {
    const auto grid = unit_grid<2>();
    const Vec<2> x(0.47, 0.52), r1(0.11, 0.04), r2(-0.03, 0.09);
    Tensor<2> R;
    R << r1, r2;
    Stencils<2> stencils;
    add_cpdi<2>(grid, x, R, stencils);
    stencils.close_row();
    const Row<2> row(grid, stencils, 0);
    const double V = 4 * cross(r1, r2);
    for (int i = 0; i < grid.nodes(); ++i) {
        const double N1 = tent(grid, i, x - r1 - r2), N2 = tent(grid, i, x + r1 - r2);
        const double N3 = tent(grid, i, x + r1 + r2), N4 = tent(grid, i, x - r1 + r2);
        CHECK(row[i].w == Approx((N1 + N2 + N3 + N4) / 4).margin(1e-15));
        const Vec<2> grad =
            ((N1 - N3) * Vec<2>(r1[1] - r2[1], r2[0] - r1[0]) + (N2 - N4) * Vec<2>(r1[1] + r2[1], -r1[0] - r2[0])) / V;
        CHECK((row[i].grad - grad).norm() < 1e-13);
    }
    check_linear_fields<2>(row, x, h);
}

TEST_CASE("cpdi: a corner beyond the grid is moved onto it", "[unit]") {
    const auto grid = unit_grid<1>();
    Stencils<1> stencils;
    add_cpdi<1>(grid, Vec<1>(0.05), Tensor<1>(0.1), stencils);  // corners at -0.05 and 0.15
    stencils.close_row();
    const Row<1> row(grid, stencils, 0);
    CHECK(row.w == Approx(1).epsilon(1e-15));
    CHECK(row[0].w == Approx(0.5 + 0.5 * 0.4));
    CHECK(row[1].w == Approx(0.5 * 0.6));
}

TEST_CASE("cpdi2: weights and gradients are the published formulas of a quadrilateral", "[unit]") {
    const auto grid = unit_grid<2>();
    const auto row = row_of_corners<2>(grid, axis_0_fastest);
    const auto& x = counter_clockwise;
    const double V = 0.5 * cross(x[2] - x[0], x[3] - x[1]);
    const auto d = [&](int i, int j) { return Vec<2>(x[std::size_t(i - 1)] - x[std::size_t(j - 1)]); };
    const double a = d(4, 1)[0] * d(2, 3)[1] - d(2, 3)[0] * d(4, 1)[1];
    const double b = d(3, 4)[0] * d(1, 2)[1] - d(1, 2)[0] * d(3, 4)[1];
    const std::array weight{6 * V - a - b, 6 * V - a + b, 6 * V + a + b, 6 * V + a - b};
    const std::array slope{Vec<2>(d(2, 4)[1], d(4, 2)[0]), Vec<2>(d(3, 1)[1], d(1, 3)[0]),
                           Vec<2>(d(4, 2)[1], d(2, 4)[0]), Vec<2>(d(1, 3)[1], d(3, 1)[0])};
    for (int i = 0; i < grid.nodes(); ++i) {
        double w = 0;
        Vec<2> grad = Vec<2>::Zero();
        for (std::size_t c = 0; c < 4; ++c) {
            w += weight[c] / (24 * V) * tent(grid, i, x[c]);
            grad += slope[c] / (2 * V) * tent(grid, i, x[c]);
        }
        CHECK(row[i].w == Approx(w).margin(1e-15));
        CHECK((row[i].grad - grad).norm() < 1e-13);
    }
}

TEST_CASE("cpdi2: they are the means over the quadrilateral, by 6 x 6 Gauss points", "[unit]") {
    const auto grid = unit_grid<2>();
    const auto row = row_of_corners<2>(grid, axis_0_fastest);
    const auto& x = axis_0_fastest;
    double V = 0;
    std::array<double, 4> w{};
    std::array<Vec<2>, 4> grad;
    grad.fill(Vec<2>::Zero());
    const Gauss6 rule;
    for (std::size_t q = 0; q < 36; ++q) {
        const double s = rule.x[q % 6], t = rule.x[q / 6], share = rule.w[q % 6] * rule.w[q / 6];
        const std::array phi{(1 - s) * (1 - t) / 4, (1 + s) * (1 - t) / 4, (1 - s) * (1 + t) / 4,
                             (1 + s) * (1 + t) / 4};
        const std::array along_s{-(1 - t) / 4, (1 - t) / 4, -(1 + t) / 4, (1 + t) / 4};
        const std::array along_t{-(1 - s) / 4, -(1 + s) / 4, (1 - s) / 4, (1 + s) / 4};
        Vec<2> e = Vec<2>::Zero(), f = Vec<2>::Zero();
        for (std::size_t c = 0; c < 4; ++c) {
            e += along_s[c] * x[c];
            f += along_t[c] * x[c];
        }
        const double J = cross(e, f);
        V += share * J;
        for (std::size_t c = 0; c < 4; ++c) {
            w[c] += share * J * phi[c];
            grad[c] += share * Vec<2>(f[1] * along_s[c] - e[1] * along_t[c], e[0] * along_t[c] - f[0] * along_s[c]);
        }
    }
    for (int i = 0; i < grid.nodes(); ++i) {
        double weight = 0;
        Vec<2> slope = Vec<2>::Zero();
        for (std::size_t c = 0; c < 4; ++c) {
            weight += w[c] / V * tent(grid, i, x[c]);
            slope += tent(grid, i, x[c]) / V * grad[c];
        }
        CHECK(row[i].w == Approx(weight).margin(1e-14));
        CHECK((row[i].grad - slope).norm() < 1e-12);
    }
}

TEST_CASE("cpdi2: over a parallelepiped it is cpdi", "[unit]") {
    const auto grid = unit_grid<3>();
    const Vec<3> x(0.45, 0.55, 0.4);
    Tensor<3> R;
    R << 0.11, 0.02, -0.03, 0.01, 0.12, 0.04, 0.03, -0.02, 0.09;
    std::vector<Vec<3>> corners;
    for (int k = 0; k < 8; ++k) corners.push_back(x + R * Vec<3>(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
    const auto row = row_of_corners<3>(grid, corners);
    Stencils<3> stencils;
    add_cpdi<3>(grid, x, R, stencils);
    stencils.close_row();
    const Row<3> parallelepiped(grid, stencils, 0);
    for (int i = 0; i < grid.nodes(); ++i) {
        CHECK(row[i].w == Approx(parallelepiped[i].w).margin(1e-14));
        CHECK((row[i].grad - parallelepiped[i].grad).norm() < 1e-12);
    }
    check_linear_fields<3>(row, x, h);
}

TEST_CASE("cpdi2: a twisted brick still gives linear fields their gradient, and the mean of the brick", "[unit]") {
    const auto grid = unit_grid<3>();
    std::vector<Vec<3>> corners;
    for (int k = 0; k < 8; ++k) {
        const Vec<3> s(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
        const Tensor<3> R = Eigen::AngleAxisd(0.2 * s[2], Vec<3>::UnitZ()).toRotationMatrix();
        corners.push_back(Vec<3>(0.5, 0.5, 0.5) + R * (0.12 * s));
    }
    const auto row = row_of_corners<3>(grid, corners);
    CHECK(std::abs(row.w - 1) < 1e-14);
    CHECK(row.grad.norm() * h < 1e-14);
    CHECK((row.slope - Tensor<3>::Identity()).norm() < 1e-13);
    CHECK((row.x - Vec<3>::Constant(0.5)).norm() < 1e-14);  // the twist keeps the centre
}

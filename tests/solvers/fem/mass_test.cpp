#include "solvers/fem/mass.hpp"

#include <Eigen/LU>

#include "tests/catch.hpp"
#include "tests/solvers/fem/bodies.hpp"

using namespace ordo::solvers::fem;

namespace {

/// The same matrix put together element by element, m_e/6 [2 1; 1 2] or m_e/2 [1 0; 0 1].
Eigen::MatrixXd assembled(int cells, double element_mass, bool lumped) {
    const Eigen::Matrix2d element = lumped ? Eigen::Matrix2d{{3, 0}, {0, 3}} : Eigen::Matrix2d{{2, 1}, {1, 2}};
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(cells + 1, cells + 1);
    for (int e = 0; e < cells; ++e) M.block<2, 2>(e, e) += element_mass / 6 * element;
    return M;
}

}  // namespace

TEST_CASE("fem mass: the accelerations solve M a = f + r, with r at held nodes only", "[unit]") {
    const auto cells = GENERATE(1, 2, 3, 9);
    const auto lumped = GENERATE(true, false);
    const auto lower = GENERATE(true, false);
    const auto upper = GENERATE(true, false);
    CAPTURE(cells, lumped, lower, upper);
    const Mass mass(cells, 0.7, lumped, {lower, upper});
    const Eigen::MatrixXd M = assembled(cells, 0.7, lumped);
    Eigen::VectorXd f(cells + 1);
    for (int i = 0; i <= cells; ++i) f[i] = std::sin(2.0 * i) + 0.3 * i;
    Eigen::VectorXd a = Eigen::VectorXd::Constant(cells + 1, std::nan(""));
    if (lower) a[0] = 0.4;
    if (upper) a[cells] = -1.1;
    const std::array<ordo::solvers::Stretch, 1> nodes{{{0, static_cast<std::size_t>(f.size())}}};
    const double reactions = mass.accelerate({f.data(), f.data() + f.size()}, {a.data(), a.data() + a.size()}, nodes);
    Eigen::VectorXd r = M * a - f;
    // Condition number at most 6 (consistent), values near 10.
    CHECK(reactions == Approx(r.sum()).margin(1e-13));
    if (lower) {
        CHECK(a[0] == 0.4);
        r[0] = 0;
    }
    if (upper) {
        CHECK(a[cells] == -1.1);
        r[cells] = 0;
    }
    CHECK(r.cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE("fem mass: both have the body's mass, and the same row sums", "[unit]") {
    const Mass lumped(9, 0.7, true, {false, true});
    const Mass consistent(9, 0.7, false, {true, false});
    CHECK(lumped.total() == Approx(9 * 0.7).epsilon(1e-15));
    CHECK(consistent.total() == Approx(9 * 0.7).epsilon(1e-15));
    const Eigen::VectorXd sums = assembled(9, 0.7, false).rowwise().sum();
    for (int i = 0; i <= 9; ++i) {
        CHECK(lumped.row_sums()[i] == Approx(sums[i]).epsilon(1e-15));
        CHECK(consistent.row_sums()[i] == Approx(sums[i]).epsilon(1e-15));
    }
}

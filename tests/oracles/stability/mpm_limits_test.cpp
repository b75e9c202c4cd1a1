// Closed forms of the largest stable Courant number against matrices that are put together here from tents alone.
#include "oracles/stability/mpm_limits.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/catch.hpp"

using namespace ordo::oracles;

namespace {

using Matrix = Eigen::MatrixXd;

/// Tents and their slopes at particles of unit cells, by nodes; on a ring of nodes, or with node 0 held.
struct Body {
    Matrix S, G;
    bool ring = true;

    Body(int cells, const std::vector<double>& xi, bool on_ring) : ring(on_ring) {
        const int nodes = cells + (ring ? 0 : 1);
        const auto count = static_cast<int>(xi.size());
        S = G = Matrix::Zero(cells * count, nodes);
        for (int c = 0; c < cells; ++c) {
            for (int k = 0; k < count; ++k) {
                const int p = c * count + k;
                const int right = (c + 1) % nodes;
                S(p, c) += 1 - xi[static_cast<std::size_t>(k)];
                S(p, right) += xi[static_cast<std::size_t>(k)];
                G(p, c) -= 1;
                G(p, right) += 1;
            }
        }
    }

    /// Inverse of the grid's mass for particles of mass m; held nodes have none.
    Matrix inverse_mass(bool consistent, double m) const {
        const Matrix M = consistent ? Matrix(m * S.transpose() * S) : Matrix((m * S.colwise().sum()).asDiagonal());
        if (ring) return M.inverse();
        Matrix inverse = Matrix::Zero(M.rows(), M.cols());
        const auto n = M.rows() - 1;
        inverse.bottomRightCorner(n, n) = M.bottomRightCorner(n, n).inverse();
        return inverse;
    }

    /// One step of (v, strain) with E = rho = h = 1 and dt = C: USL, or MUSL.
    Matrix step(bool consistent, bool remapped, double C, double m) const {
        const auto P = S.rows();
        const Matrix inverse = inverse_mass(consistent, m);
        const Matrix one = Matrix::Identity(P, P);
        const Matrix map = inverse * S.transpose() * m;        // v_i of v_p
        const Matrix pull = -C * inverse * G.transpose() * m;  // dv_i of strain
        Matrix out(2 * P, 2 * P);
        out << one, S * pull, C * G * map, one + C * G * (remapped ? Matrix(map * S * pull) : pull);
        return out;
    }

    double radius(bool consistent, bool remapped, double C, double m) const {
        return Eigen::EigenSolver<Matrix>(step(consistent, remapped, C, m), false).eigenvalues().cwiseAbs().maxCoeff();
    }
};

/// Stable 0.1 % below the limit, unstable 0.1 % above it: a radius of 1 to the root of round-off, at double
/// eigenvalues.
void check_limit(double limit, const std::function<double(double)>& radius) {
    CHECK(radius(0.999 * limit) < 1 + 1e-6);
    CHECK(radius(1.001 * limit) > 1 + 1e-4);
}

const std::vector<std::vector<double>> places{{0.5},        {0.3},           {0.9},
                                              {0.25, 0.75}, {0.4, 0.6},      {0.11, 0.97},
                                              {0.1, 0.9},   {0.2, 0.5, 0.7}, {0.125, 0.375, 0.625, 0.875}};

}  // namespace

TEST_CASE("limits of tents: the matrix of one step passes 1 there, for every mass, order and place", "[gate]") {
    for (const auto& xi : places) {
        const Body body(16, xi, true);
        const double m = 1.0 / static_cast<double>(xi.size());
        for (const bool consistent : {false, true}) {
            if (consistent && xi == std::vector{0.5}) continue;  // no inverse
            for (const bool remapped : {false, true}) {
                const TentScheme scheme{consistent, remapped ? TentScheme::Order::stress_first_or_remapped
                                                             : TentScheme::Order::stress_last};
                INFO(xi.size() << " particles, first at " << xi[0] << (consistent ? ", consistent" : ", lumped")
                               << (remapped ? ", MUSL" : ", USL"));
                check_limit(largest_courant(scheme, xi, 16),
                            [&](double C) { return body.radius(consistent, remapped, C, m); });
            }
        }
    }
}

TEST_CASE("limits of tents: the gate rings for a limit that is 1 % off", "[alarm]") {
    const Body body(16, places[4], true);
    const double limit = largest_courant({}, places[4], 16);
    CHECK(body.radius(false, false, 0.999 * 1.01 * limit, 0.5) > 1 + 1e-6);
    CHECK(body.radius(false, false, 1.001 * 0.99 * limit, 0.5) < 1 + 1e-6);
}

TEST_CASE("limits of tents: the saw-tooth share of 1 to 4 centred particles, and what is printed for it",
          "[published]") {
    CHECK(saw_tooth_share(std::vector{0.5}) == 0);
    CHECK(saw_tooth_share(std::vector{0.25, 0.75}) == Approx(1.0 / 4).epsilon(1e-15));
    CHECK(saw_tooth_share(std::vector{1.0 / 6, 0.5, 5.0 / 6}) == Approx(8.0 / 27).epsilon(1e-15));
    CHECK(saw_tooth_share(places.back()) == Approx(5.0 / 16).epsilon(1e-15));
    CHECK(largest_courant({}, std::vector{0.25, 0.75}) == Approx(0.7559).margin(5e-5));
    CHECK(largest_courant({.consistent = true}, std::vector{0.25, 0.75}) == Approx(0.5).epsilon(1e-15));
    // Exact places, shares of a third: finite elements, 1 / sqrt 3.
    const double third = 0.5 / std::sqrt(3.0);
    CHECK(largest_courant({.consistent = true}, std::vector{0.5 - third, 0.5 + third}) ==
          Approx(1 / std::sqrt(3.0)).epsilon(1e-14));
}

TEST_CASE("limits of tents: more cells hold more waves, and an endless bar all of them", "[property]") {
    const TentScheme musl{.order = TentScheme::Order::stress_first_or_remapped};
    for (const auto& xi : places) {
        double before = largest_courant(musl, xi, 2);
        for (const int cells : {4, 8, 16, 32, 64}) {
            const double now = largest_courant(musl, xi, cells);
            CHECK(now <= before);
            before = now;
        }
        CHECK(largest_courant(musl, xi) <= before);
        CHECK(largest_courant(musl, xi) ==
              Approx(before).epsilon(2e-3));  // the next wave is pi / 64 away, at a minimum
    }
}

TEST_CASE("limit of one cell: the matrix of one step passes 1 there", "[gate]") {
    for (const double xi : {1.0, 0.5, 0.25, 0.1, 0.01}) {
        const Body body(1, {xi}, false);
        for (const bool remapped : {false, true}) {
            const auto order = remapped ? TentScheme::Order::stress_first_or_remapped : TentScheme::Order::stress_last;
            check_limit(largest_courant_of_one_cell(order, xi),
                        [&](double C) { return body.radius(false, remapped, C, 1); });
        }
    }
    CHECK(largest_courant_of_one_cell(TentScheme::Order::stress_last, 0.25) == Approx(0.756).margin(5e-4));
    CHECK(largest_courant_of_one_cell(TentScheme::Order::stress_last, 0.1) == Approx(0.459).margin(5e-4));
}

TEST_CASE("limit of finite elements: dt = 2 / omega of the largest frequency, by eigenvalues", "[gate]") {
    for (const bool free_end : {true, false}) {
        for (const int elements : {2, 3, 10, 31}) {
            const int nodes = free_end ? elements : elements - 1;  // that move
            Matrix K = Matrix::Zero(nodes, nodes);
            Eigen::VectorXd m = Eigen::VectorXd::Ones(nodes);
            for (int i = 0; i < nodes; ++i) {
                K(i, i) = 2;
                if (i > 0) K(i, i - 1) = K(i - 1, i) = -1;
            }
            if (free_end) {
                K(nodes - 1, nodes - 1) = 1;
                m[nodes - 1] = 0.5;
            }
            const Eigen::VectorXd root = m.cwiseSqrt().cwiseInverse();
            const Matrix A = root.asDiagonal() * K * root.asDiagonal();
            const double omega2 = Eigen::SelfAdjointEigenSolver<Matrix>(A).eigenvalues().maxCoeff();
            CHECK(largest_courant_of_elements(elements, free_end) == Approx(2 / std::sqrt(omega2)).epsilon(1e-12));
        }
    }
}

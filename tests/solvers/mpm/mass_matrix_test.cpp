#include "solvers/mpm/mass_matrix.hpp"

#include <Eigen/LU>
#include <numeric>
#include <random>
#include <string>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/rows.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

/// A grid with its points' stencils and masses, and the dense matrix that they mean.
template <int dim>
struct Body {
    Grid<dim> grid;
    Particles<dim> p;
    Stencils<dim> stencils;
    Eigen::MatrixXd M;

    Body(const std::string& basis, Face face, double ppc, int cells = 4)
        : Body(options_of({{"basis", basis}}), face, {.cells = cells, .ppc = ppc, .h = 1.0 / cells, .dt = 1}) {}

    Body(const Options& options, Face face, const Resolution& resolution)
        : grid(scene(face), options, resolution), p(seeded<dim>(scene(face), options, resolution, false)) {
        std::mt19937 bits(5);
        std::uniform_real_distribution<double> any(-0.04, 0.04);
        if (resolution.ppc > 1) {
            for (auto& x : p.x) {
                for (int axis = 0; axis < dim; ++axis) x[axis] += any(bits) * resolution.h;
            }
        }
        REQUIRE(fill<dim>(grid, options, p, stencils).rows == p.size());
        scatter();
    }

    static SolidScene<dim> scene(Face face) { return box<dim>(Vec<dim>::Ones(), face, uniform<dim>(Vec<dim>::Zero())); }
    void scatter() {
        const auto count = static_cast<Eigen::Index>(grid.nodes());
        M = Eigen::MatrixXd::Zero(count, count);
        for (std::size_t i = 0; i < p.size(); ++i) {
            Eigen::VectorXd S = Eigen::VectorXd::Zero(count);
            stencils.row(i, [&](int node, double w, const Vec<dim>&) { S[node] += w; });
            M += p.m[i] * S * S.transpose();
        }
        const Eigen::VectorXd rows = M.rowwise().sum();
        for (int i = 0; i < grid.nodes(); ++i) grid.m[static_cast<std::size_t>(i)] = rows[i];
    }
    std::vector<Vec<dim>> some_load(unsigned seed = 3) const {
        std::mt19937 bits(seed);
        std::uniform_real_distribution<double> any(-1, 1);
        std::vector<Vec<dim>> b(grid.m.size());
        for (std::size_t i = 0; i < b.size(); ++i) {
            for (int axis = 0; axis < dim; ++axis) b[i][axis] = grid.m[i] > 0 ? any(bits) : 0;
        }
        return b;
    }
    std::vector<double> some_held_values() const {
        std::vector<double> values(grid.held.size());
        std::iota(values.begin(), values.end(), 0.5);
        return values;
    }
    bool is_held(int node, int axis) const {
        for (const auto& held : grid.held) {
            if (held.node == node && held.axis == axis) return true;
        }
        return false;
    }
};

Options with(Mass mass, int terms = 4, Transfer transfer = Transfer::flip) {
    return {.mass = mass, .transfer = transfer, .terms = terms};
}

template <int dim>
Eigen::VectorXd component(const std::vector<Vec<dim>>& f, int axis) {
    Eigen::VectorXd line(static_cast<Eigen::Index>(f.size()));
    for (std::size_t i = 0; i < f.size(); ++i) line[static_cast<Eigen::Index>(i)] = f[i][axis];
    return line;
}

/// Solves by Eigen's full pivoting what holding and empty nodes leave of M x = b.
template <int dim>
Eigen::VectorXd reference(const Body<dim>& body, const Eigen::VectorXd& b, std::span<const double> held, int axis) {
    Eigen::MatrixXd A = body.M;
    Eigen::VectorXd right = b;
    const auto fix = [&](Eigen::Index i, double value) {
        A.row(i).setZero();
        A(i, i) = 1;
        right[i] = value;
    };
    for (int i = 0; i < body.grid.nodes(); ++i) {
        if (!(body.grid.m[static_cast<std::size_t>(i)] > 0)) fix(i, 0);
    }
    for (std::size_t k = 0; k < body.grid.held.size(); ++k) {
        if (body.grid.held[k].axis == axis) fix(body.grid.held[k].node, held.empty() ? 0 : held[k]);
    }
    return A.fullPivLu().solve(right);
}

}  // namespace

TEST_CASE("mass: banded factors solve what the dense matrix solves", "[unit]") {
    std::mt19937 bits(1);
    std::uniform_real_distribution<double> any(-1, 1);
    for (const int band : {0, 1, 3, 8}) {
        const int n = 9;
        Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
        BandedMatrix banded;
        banded.reset(n, band);
        for (int i = 0; i < n; ++i) {
            for (int j = std::max(0, i - band); j <= i; ++j) {
                const double value = i == j ? 2 * band + 1.5 : any(bits);  // rows dominated by their diagonals
                banded.add(i, j, 0.25 * value);
                banded.add(i, j, 0.75 * value);
                dense(i, j) = dense(j, i) = value;
            }
        }
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) CHECK(banded.at(i, j) == Approx(dense(i, j)).margin(1e-15));
        }
        banded.isolate(4);
        dense.row(4).setZero();
        dense.col(4).setZero();
        dense(4, 4) = 1;
        Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2);
        const Eigen::VectorXd expected = dense.fullPivLu().solve(b);
        REQUIRE(banded.factor() == -1);
        banded.solve({b.data(), static_cast<std::size_t>(n)});
        CHECK((b - expected).norm() < 1e-14);
    }
}

TEST_CASE("mass: a matrix without an inverse, or not positive, is found at its row", "[unit]") {
    BandedMatrix M;
    M.reset(3, 1);
    for (int i = 0; i < 3; ++i) M.add(i, i, i == 1 ? 2 : 1);
    M.add(1, 0, 1);
    M.add(2, 1, 1);  // det = 0
    CHECK(M.factor() == 2);
    M.reset(2, 1);
    M.add(0, 0, -1);
    CHECK(M.factor() == 0);
    M.reset(2, 1);
    M.add(0, 0, std::nan(""));
    CHECK(M.factor() == 0);
}

TEMPLATE_TEST_CASE_SIG("mass: the consistent solve is the dense one, whatever is held", "[unit]", ((int dim), dim), 1,
                       2) {
    const auto basis = GENERATE(as<std::string>{}, "linear", "quadratic", "cubic", "ddmp");
    const auto face = GENERATE(Face::fixed, Face::roller, Face::free);
    const bool moving = GENERATE(false, true);
    INFO(basis << ", face " << static_cast<int>(face) << (moving ? ", moving" : ""));
    Body<dim> body(basis, face, 4, 2);
    MassMatrix<dim> mass(with(Mass::consistent));
    mass.assemble(body.grid, body.stencils, body.p.m);
    const auto f = body.some_load();
    auto x = f;
    const auto held = moving ? body.some_held_values() : std::vector<double>{};
    mass.solve(body.grid, x, held);
    for (int axis = 0; axis < dim; ++axis) {
        const Eigen::VectorXd expected = reference(body, component<dim>(f, axis), held, axis);
        const double scale = 1 + expected.cwiseAbs().maxCoeff();
        // The smallest eigenvalues are 1e-5 of the largest (cubic, ends): errors of 1e-16 grow by as much.
        CHECK((component<dim>(x, axis) - expected).cwiseAbs().maxCoeff() < 1e-9 * scale);
        // Held components' reactions close the balance, row by row; elsewhere nothing is missing.
        const Eigen::VectorXd needed = body.M * component<dim>(x, axis) - component<dim>(f, axis);
        for (int i = 0; i < body.grid.nodes(); ++i) {
            const double lacks = needed[i];
            CHECK(mass.reaction(body.grid, i, axis, x, f) == Approx(lacks).margin(1e-12 * scale));
            if (!body.is_held(i, axis)) CHECK(std::abs(lacks) < 1e-9 * scale);
        }
    }
}

TEST_CASE("mass: one particle amid each cell under tents leaves a saw-tooth without mass, which is told", "[unit]") {
    Body<1> body("linear", Face::free, 1);
    MassMatrix<1> mass(with(Mass::consistent));
    CHECK_THROWS_AS(mass.assemble(body.grid, body.stencils, body.p.m), Diverged);
    CHECK_THROWS_WITH(mass.assemble(body.grid, body.stencils, body.p.m), ContainsSubstring("singular"));
    Body<1> held("linear", Face::fixed, 1);  // a held end takes the saw-tooth out
    CHECK_NOTHROW(mass.assemble(held.grid, held.stencils, held.p.m));
}

TEST_CASE("mass: lumped divides by the node's mass, and holds", "[unit]") {
    Body<2> body("linear", Face::roller, 2);
    MassMatrix<2> mass(with(Mass::lumped));
    mass.assemble(body.grid, body.stencils, body.p.m);
    const auto f = body.some_load();
    auto x = f;
    const auto held = body.some_held_values();
    mass.solve(body.grid, x, held);
    for (int i = 0; i < body.grid.nodes(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        for (int axis = 0; axis < 2; ++axis) {
            if (!body.is_held(i, axis)) CHECK(x[k][axis] == f[k][axis] / body.grid.m[k]);
            CHECK(mass.reaction(body.grid, i, axis, x, f) ==
                  Approx(body.grid.m[k] * x[k][axis] - f[k][axis]).margin(1e-15));
        }
    }
    for (std::size_t k = 0; k < held.size(); ++k)
        CHECK(x[static_cast<std::size_t>(body.grid.held[k].node)][body.grid.held[k].axis] == held[k]);
}

TEST_CASE("mass: the series is the binomial form of FMPM(k), and tends to the consistent solution", "[unit]") {
    // v(k) = sum_l (-1)^(l+1) C(k, l) (m^-1 M)^(l-1) m^-1 p, every node free.
    Body<1> body("quadratic", Face::free, 3);
    // Nodes without mass are left out of the dense form.
    const auto count = static_cast<Eigen::Index>(body.grid.nodes());
    Eigen::VectorXd inverse(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double m = body.grid.m[static_cast<std::size_t>(i)];
        inverse[i] = m > 0 ? 1 / m : 0;
    }
    const auto f = body.some_load();
    const Eigen::VectorXd p = component<1>(f, 0);
    const auto series = [&](int k) {
        MassMatrix<1> mass(with(Mass::fmpm, k));
        mass.assemble(body.grid, body.stencils, body.p.m);
        auto x = f;
        mass.solve(body.grid, x, {});
        return component<1>(x, 0);
    };
    for (const int k : {1, 2, 3, 5, 8}) {
        Eigen::VectorXd sum = Eigen::VectorXd::Zero(count);
        Eigen::VectorXd power = inverse.cwiseProduct(p);
        double binomial = 1;
        for (int l = 1; l <= k; ++l) {
            binomial *= double(k - l + 1) / l;
            sum += (l % 2 == 1 ? 1 : -1) * binomial * power;
            power = inverse.cwiseProduct(body.M * power);
        }
        CHECK((series(k) - sum).cwiseAbs().maxCoeff() < 1e-13 * sum.cwiseAbs().maxCoeff() * std::pow(2, k));
    }
    const Eigen::VectorXd limit = reference(body, p, {}, 0);
    const auto distance = [&](int k) { return (series(k) - limit).cwiseAbs().maxCoeff(); };
    CHECK(distance(16) < distance(4));
    CHECK(distance(64) < distance(16));
    CHECK(distance(4000) < 1e-6 * limit.cwiseAbs().maxCoeff());
}

TEST_CASE("mass: XPIC's recursion gives the same velocities as the series", "[unit]") {
    // v = k (v_1 - v*), v* = sum from r = 2 to k of (-1)^r v_r, v_1 = m^-1 p, v_r = (k - r + 1) / r S+ S v_(r-1).
    // source [Hammerquist2017]
    Body<1> body("linear", Face::free, 2);
    const auto count = static_cast<Eigen::Index>(body.grid.nodes());
    Eigen::VectorXd m(count);
    for (Eigen::Index i = 0; i < count; ++i) m[i] = body.grid.m[static_cast<std::size_t>(i)];
    const auto f = body.some_load();
    for (const int k : {1, 2, 5}) {
        MassMatrix<1> mass(with(Mass::lumped, k, Transfer::xpic));
        mass.assemble(body.grid, body.stencils, body.p.m);
        auto x = f;
        mass.solve_by_series(body.grid, x, {});
        const auto over_mass = [&](const Eigen::VectorXd& b) {
            return Eigen::VectorXd((m.array() > 0).select(b.array() / m.array().max(1e-300), 0).matrix());
        };
        Eigen::VectorXd v = over_mass(component<1>(f, 0));
        Eigen::VectorXd sum = k * v;
        for (int r = 2; r <= k; ++r) {
            v = double(k - r + 1) / r * over_mass(body.M * v);
            sum -= k * (r % 2 == 0 ? 1 : -1) * v;
        }
        CHECK((component<1>(x, 0) - sum).cwiseAbs().maxCoeff() < 1e-12 * sum.cwiseAbs().maxCoeff());
    }
}

TEST_CASE("mass: what held nodes take up closes the balance of the series, at rest and moving", "[property]") {
    // sum m_i x_i = sum b_i + sum of reactions, since the rows of M add up to m.
    const int terms = GENERATE(1, 2, 7);
    const bool moving = GENERATE(false, true);
    INFO("k = " << terms << (moving ? ", moving" : ""));
    Body<2> body("linear", Face::roller, 2);
    MassMatrix<2> mass(with(Mass::fmpm, terms));
    mass.assemble(body.grid, body.stencils, body.p.m);
    const auto f = body.some_load();
    auto x = f;
    mass.solve(body.grid, x, moving ? body.some_held_values() : std::vector<double>{});
    Vec<2> balance = Vec<2>::Zero();
    for (std::size_t i = 0; i < x.size(); ++i) balance += body.grid.m[i] * x[i] - f[i];
    for (const auto& [node, axis] : body.grid.held) balance[axis] -= mass.reaction(body.grid, node, axis, x, f);
    CHECK(balance.norm() < 1e-13);  // a few dozen sums of order one
}

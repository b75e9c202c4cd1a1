// The generic solver on materials that have a theory of their own: the ideal gas and linear elasticity.
#include <limits>

#include "oracles/riemann/elastic_laws.hpp"
#include "oracles/riemann/riemann_linear_elastic.hpp"
#include "oracles/riemann/riemann_nonlinear_elastic.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/fuzz.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::elastic;

namespace {

/// No strain energy: with heat c_v lambda^-k T, c_v = rho0 = 1, an ideal gas of p = (gamma - 1) T lambda^-gamma.
struct Nothing {
    double value(const Stretch&) const { return 0; }
    Jet at(const Stretch&) const { return {0, 0, 0}; }
    double slope_rise(const Change&, const Jet&) const { return 0; }
    double trapezoid_excess(const Change&) const { return 0; }
    double low() const { return std::numeric_limits<double>::infinity(); }
    double high() const { return -std::numeric_limits<double>::infinity(); }
};

using IdealGas = Material<Nothing, PowerHeat>;
constexpr double heat_ratio = 1.4;

State gas(double rho, double v, double p) { return {1 / rho, v, p * std::pow(rho, -heat_ratio) / (heat_ratio - 1)}; }

RiemannNonlinearElastic<IdealGas> gas_problem(const State& left, const State& right) {
    return {IdealGas{{}, {1, heat_ratio - 1}, 1}, left, right};
}

}  // namespace

TEST_CASE("elastic Riemann solver: an ideal gas is a special material", "[published]") {
    struct Row {
        State left, right;
        double p, v, rho_L, rho_R, head, tail, shock;  // NaN where the wave is of the other kind
    };
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Row> table{
        {gas(1, 0, 1), gas(0.125, 0, 0.1), 0.30313018, 0.92745262, 0.4263194, 0.2655737, -1.18322, -0.07027, 1.75216},
        {gas(1, 0.75, 1), gas(0.125, 0, 0.1), 0.46629357, 1.3609055, 0.5798667, 0.3397002, -0.43322, 0.29987, 2.15323},
        {gas(1, -2, 0.4), gas(1, 2, 0.4), 0.0018938734, 0, 0.02185212, 0.02185212, -2.74833, -0.34833, none},
        {gas(1, 0, 1000), gas(1, 0, 0.01), 460.89379, 19.597451, 0.5750623, 5.999241, -37.4166, -13.8996, 23.5175},
        {gas(5.99924, 19.5975, 460.894), gas(5.99242, -6.19633, 46.095), 1691.647, 8.6897744, 14.28235, 31.0426,
         0.789594, 0.789594, 12.2508}};
    for (const auto& row : table) {
        const auto problem = gas_problem(row.left, row.right);
        INFO("p* = " << row.p);
        // As many digits as are printed: half a unit of the last one is at most 5e-7 of any of them.
        CHECK(-problem.star().sigma == Approx(row.p).epsilon(3e-8));
        CHECK(problem.star().v == Approx(row.v).epsilon(3e-8).margin(1e-15));
        CHECK(1 / problem.star_left().lambda == Approx(row.rho_L).epsilon(5e-7));
        CHECK(1 / problem.star_right().lambda == Approx(row.rho_R).epsilon(5e-7));
        CHECK(problem.speeds()[0] == Approx(row.head).epsilon(2e-5));
        CHECK(problem.speeds()[1] == Approx(row.tail).epsilon(1e-4));
        if (!std::isnan(row.shock)) CHECK(problem.speeds()[4] == Approx(row.shock).epsilon(5e-6));
    }
    const auto sod = gas_problem(table[0].left, table[0].right);
    CHECK(-sod.star().sigma == Approx(0.30313017805064682).epsilon(1e-15));
    CHECK(sod.star().v == Approx(0.92745262004895057).epsilon(1e-15));
}

TEST_CASE("elastic Riemann solver: a law that carries no tension has a vacuum, which is refused", "[unit]") {
    const double limit =
        2 * 2 * std::sqrt(heat_ratio * 0.4) / (heat_ratio - 1);  // v_R - v_L >= 2 (a_L + a_R) / (gamma - 1)
    CHECK_NOTHROW(gas_problem(gas(1, -0.495 * limit, 0.4), gas(1, 0.495 * limit, 0.4)));
    CHECK_THROWS_WITH(gas_problem(gas(1, -0.501 * limit, 0.4), gas(1, 0.501 * limit, 0.4)),
                      ContainsSubstring("vacuum"));
}

TEST_CASE("elastic Riemann solver: without curvature and coupling it is the closed form of linear elasticity",
          "[gate]") {
    gate::Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const double E = random.log_uniform(1e-3, 1e3);
        const double rho0 = random.log_uniform(1e-3, 1e3);
        const double c_v = random.log_uniform(1e-2, 1e2);
        const double c0 = std::sqrt(E / rho0);
        const auto state = [&] {
            return State{random.log_uniform(0.2, 5), random.uniform(-1, 1) * c0 * 0.15, random.uniform(0, 2) * E / c_v};
        };
        const State left = state();
        const State right = state();
        const RiemannLinearElastic closed(E, rho0, c_v, left, right);
        const RiemannNonlinearElastic<Material<Linear, PowerHeat>> generic({{E}, {c_v, 0}, rho0}, left, right);
        const double speed = c0 * (left.lambda + right.lambda);
        CHECK(std::abs(generic.star().v - closed.v_star()) <= 1e-14 * speed);
        CHECK(std::abs(generic.star().sigma - closed.sigma_star()) <= 1e-14 * E * (left.lambda + right.lambda));
        CHECK(std::abs(generic.speeds()[0] - closed.speeds()[0]) <= 1e-14 * speed);
        CHECK(std::abs(generic.speeds()[4] - closed.speeds()[2]) <= 1e-14 * speed);
        CHECK((generic.star_left().T == left.T && generic.star_right().T == right.T));
    }
}

// The gate of free flight: Newton's second law by differences and the initial data, in every dimension.
#include "oracles/free_flight.hpp"

#include <functional>

#include "tests/catch.hpp"
#include "tests/oracles/differences.hpp"

using namespace ordo;
using namespace ordo::oracles;

namespace {

using OfTime = std::function<double(int axis, double t)>;

/// What is true of a body that is thrown along the first axis and pulled along the last one.
gate::Defect newton(int dim, double v0, double g, const OfTime& displacement, const OfTime& velocity) {
    const double scale = 1 + std::abs(v0) + std::abs(g);
    gate::Defect defect;
    for (int axis = 0; axis < dim; ++axis) {
        const double pull = axis == dim - 1 ? g : 0;
        for (const double t : {0.3, 1.0, 7.3}) {
            const double noise = 1e-16 * scale * (1 + t) * (1 + t);
            const auto u = [&](double s) { return displacement(axis, s); };
            const auto u_t = gate::first_derivative(u, t, 0.5, noise);
            const auto u_tt = gate::second_derivative(u, t, 0.5, noise);
            defect.add(velocity(axis, t) - u_t.value, u_t.error + noise, scale);
            defect.add(u_tt.value - pull, u_tt.error, scale);
        }
        defect.add(displacement(axis, 0), 0, scale);
        defect.add(velocity(axis, 0) - (axis == 0 ? v0 : 0), 0, scale);
    }
    return defect;
}

gate::Defect newton(const FreeFlight& flight) {
    return newton(flight.dim, flight.v0, flight.g, [&](int axis, double t) { return flight.displacement(axis, t); },
                  [&](int axis, double t) { return flight.velocity(axis, t); });
}

}  // namespace

TEST_CASE("free flight obeys Newton's second law from its initial data", "[gate]") {
    const int dim = GENERATE(1, 2, 3);
    CHECK(newton({.dim = dim}).holds());
    CHECK(newton({.dim = dim, .v0 = -2.7, .g = 9.81}).holds());
}

TEST_CASE("the gate of free flight rings", "[alarm]") {
    const FreeFlight flight{.dim = 2, .v0 = 0.7, .g = -1.3};
    const auto u = [&](int axis, double t) { return flight.displacement(axis, t); };
    const auto v = [&](int axis, double t) { return flight.velocity(axis, t); };
    REQUIRE(newton(2, 0.7, -1.3, u, v).holds());
    CHECK_FALSE(newton(2, 0.7, -1.3, [&](int axis, double t) { return u(axis, t) + 1e-6 * t * t; }, v).holds());
    CHECK_FALSE(newton(2, 0.7, -1.3, u, [&](int axis, double t) { return v(axis, t) * (1 + 1e-6); }).holds());
    CHECK_FALSE(newton(2, 0.7, -1.3, [&](int axis, double t) { return u(1 - axis, t); }, v).holds());
    CHECK_FALSE(newton(2, 0.7, -1.3, [&](int axis, double t) { return u(axis, t) + 1e-6; }, v).holds());
}

TEST_CASE("nothing deforms in free flight, and every component is bound", "[gate]") {
    const Oracle oracle = free_flight();
    const auto exact = oracle.bind(resolve(oracle.parameters, {{"dim", 3.0}, {"g", -2.0}}, "test", "free_flight"));
    REQUIRE(exact.dim == 3);
    const std::vector<double> x{0.1, 0.2, 0.3};
    std::vector<double> values(exact.width(), 1.0);
    exact.sample(x, 2.0, values);
    std::vector<double> expected(24, 0.0);
    expected[*exact.offset("displacement")] = 2;
    expected[*exact.offset("displacement") + 2] = -4;
    expected[*exact.offset("velocity")] = 1;
    expected[*exact.offset("velocity") + 2] = -4;
    CHECK(values == expected);
}

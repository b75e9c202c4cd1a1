// Errors in tests of Toro against those of an independent implementation, digits as it printed them; and orders.
#include <array>

#include "tests/solvers/godunov/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::godunov;
using namespace ordo::solvers::godunov::test;

namespace {

using Three = std::array<double, 3>;  // density, velocity, pressure

struct Row {
    GasPair pair;
    double t;
    double cells;
    Three error;
    Three last_digit;
};

const std::vector<Row> printed{
    {sod, 1.5, 400, {1.3e-2, 2.3e-2, 9.0e-3}, {1e-3, 1e-3, 1e-4}},
    {sod, 1.5, 1600, {4.0e-3, 6.1e-3, 2.3e-3}, {1e-4, 1e-4, 1e-4}},
    {toro_3, 0.04, 1600, {5.3e-2, 0.11, 2.1}, {1e-3, 1e-2, 0.1}},
    {toro_4, 0.15, 1600, {0.25, 7.8e-2, 11}, {1e-2, 1e-3, 1}},
    {toro_4, 0.15, 3200, {0.17, 5.7e-2, 9.0}, {1e-2, 1e-3, 0.1}},
};

Three errors(const GasPair& pair, double t, double cells, const Given& options) {
    const auto shot = at(pair.scene(), t, options, {{"cells", cells}});
    const oracles::RiemannGas exact(pair.left, pair.right);
    return {l1(shot, "density", [&](double x) { return exact.at(x, t).density; }),
            l1(shot, "velocity", [&](double x) { return exact.at(x, t).velocity; }),
            l1(shot, "pressure", [&](double x) { return exact.at(x, t).pressure; })};
}

/// Largest distance from a row, in units of what is allowed: 5 percent and half of the last printed digit.
double distance(const Row& row, const Given& options) {
    const Three found = errors(row.pair, row.t, row.cells, options);
    double worst = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double allowed = 0.05 * row.error[k] + 0.5 * row.last_digit[k];
        worst = std::max(worst, std::abs(found[k] - row.error[k]) / allowed);
    }
    return worst;
}

}  // namespace

TEST_CASE("godunov: MUSCL-Hancock with HLLC has the errors of an independent implementation", "[convergence]") {
    for (const Row& row : printed) {
        CAPTURE(row.cells, row.t);
        CHECK(distance(row, {}) < 1);
    }
}

TEST_CASE("godunov: those errors tell limiters, speeds and orders apart", "[alarm]") {
    CHECK(distance(printed[1], {{"order", "first"}}) > 10);
    for (const std::string limiter : {"minmod", "van_leer", "superbee"})
        CHECK(distance(printed[1], {{"limiter", limiter}}) > 1.5);
    CHECK(distance(printed[3], {{"speeds", "davis"}}) > 1.5);
}

TEST_CASE("godunov: shock tubes converge with the orders of shocks and contacts", "[convergence]") {
    // Density has a contact, which spreads over h^(p/(p+1)) for a scheme of order p; in pressure the fan's corners and
    // the shock remain.
    const auto order = [](const std::string& scheme, std::size_t field) {
        const Given options{{"order", scheme}};
        const double ratio = errors(sod, 1.5, 200, options)[field] / errors(sod, 1.5, 1600, options)[field];
        return std::log(ratio) / std::log(8);
    };
    CHECK(std::abs(order("first", 0) - 0.6) < 0.15);
    CHECK(std::abs(order("first", 2) - 0.75) < 0.15);
    CHECK(std::abs(order("second", 0) - 0.85) < 0.15);
    CHECK(std::abs(order("second", 2) - 0.97) < 0.15);
}

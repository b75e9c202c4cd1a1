#include "oracles/manufactured/bar_mms.hpp"

#include <cmath>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/manufactured/motion_fuzz.hpp"
#include "tests/oracles/manufactured/motion_gate.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::manufactured;

namespace {

ElasticConstants solid(double E, double nu) { return elastic_constants({Elastic::E, E}, {Elastic::nu, nu}, ""); }

Motion<1> motion_of(const BarMms& bar) {
    std::vector<Place<1>> points;
    for (const double share : {0.0, 0.083, 0.214, 0.385, 0.502, 0.668, 0.813, 1.0}) points.push_back({share * bar.L});
    return {.at = [bar](const Place<1>& X, double t) { return bar.at(X, t); },
            .elastic = bar.elastic,
            .rho = bar.rho,
            .length = bar.L / pi * 0.7,
            .omega = pi / bar.L * std::sqrt(bar.elastic.E / bar.rho),
            .points = points};
}

std::vector<BarMms> bars() {
    return {{},
            {.A = 0.05},
            {.L = 3, .A = -0.4, .rho = 1.3, .elastic = solid(7, 0.3)},
            {.L = 0.02, .A = 0.003, .rho = 7850, .elastic = solid(2.1e11, -0.4)}};
}

}  // namespace

TEST_CASE("bar_mms: deformation, velocity, law and balance of momentum follow from the motion", "[gate]") {
    for (const auto& bar : bars()) CHECK(ringing(motion_of(bar)) == "");
}

TEST_CASE("bar_mms: starts undeformed, its ends are held, a quarter period on the middle has moved by A", "[gate]") {
    for (const auto& bar : bars()) {
        const double quarter = pi / 2 / bar.omega();
        for (const double t : {0.0, 0.3 * quarter, quarter, 5.7 * quarter}) {
            CHECK((bar.at({0}, t).u[0] == 0 && bar.at({bar.L}, t).u[0] == 0));
            CHECK((bar.at({0}, t).v[0] == 0 && bar.at({bar.L}, t).v[0] == 0));
        }
        for (const double share : {0.1, 0.5, 0.9}) {
            const auto start = bar.at({share * bar.L}, 0);
            CHECK((start.u[0] == 0 && start.P[0] == 0 && start.b[0] == 0 && start.F[0] == 1));
        }
        CHECK(std::abs(bar.at({bar.L / 2}, quarter).u[0] / bar.A - 1) < 8 * eps);
        CHECK(std::abs(bar.at({bar.L / 2}, 0).v[0] / (bar.A * bar.omega()) - 1) < 8 * eps);
        // One round trip of a wave at sqrt(E / rho) is one period.
        CHECK(std::abs(bar.omega() * 2 * bar.L / std::sqrt(bar.elastic.E / bar.rho) / (2 * pi) - 1) < 8 * eps);
    }
}

TEST_CASE("bar_mms: small motions of a bar without Poisson's effect need no force, others the difference of M and E",
          "[gate]") {
    const BarMms free{.A = 1e-9};
    const BarMms held{.A = 1e-9, .elastic = solid(1e7, 0.3)};
    const auto force = [](const BarMms& bar) { return bar.at({0.3}, 0.7 / bar.omega()); };
    const double linear = pi * pi * force(free).u[0] / 1000;  // pi^2 u / (rho L^2): linear theory to A / L
    CHECK(std::abs(force(free).b[0]) < 1e7 * linear * 1e-8);
    CHECK(std::abs(force(held).b[0] / (linear * (held.elastic.M - held.elastic.E)) - 1) < 1e-7);
}

TEST_CASE("bar_mms: what turns the bar inside out, or is no solid, is refused", "[unit]") {
    const auto bound = [](const Given& given) {
        const Oracle oracle = bar_mms();
        return oracle.bind(resolve(oracle.parameters, given, "", "bar_mms"));
    };
    CHECK_THROWS_WITH(bound({{"A", 0.32}}),
                      ContainsSubstring("oracle bar_mms: A = 0.32 m turns the bar inside out (det F <= 0); must be"));
    CHECK_THROWS_WITH(bound({{"A", -1.0}, {"L", 3.0}}), ContainsSubstring("below L/pi = 0.95"));
    CHECK_THROWS_WITH(bound({{"E", 3.0}}), ContainsSubstring("exactly two of"));
    CHECK_THROWS_WITH(bound({{"E", 3.0}, {"G", 1.0}}), ContainsSubstring("0 < E < 3 G"));
    CHECK_THROWS_WITH(bound({{"rho", 1e-300}}), ContainsSubstring("rates <= 1e75"));
    CHECK_NOTHROW(bound({{"A", 0.3183}}));
    const Exact exact = bound({});
    const double X = 0.5;
    CHECK_THROWS_AS(exact.check({&X, 1}, 1e12, ""), InputError);  // omega t = 3e14
    CHECK_THROWS_AS(exact.check({&X, 1}, -1e-9, ""), InputError);
}

TEST_CASE("bar_mms: random bars keep the balance of momentum, or are inside out", "[property]") {
    Random random(1);
    Tally tally;
    for (int round = 0; round < fuzz_rounds(300); ++round) {
        const double L = random.log_uniform(1e-6, 1e6);
        const double share = random.uniform(-1.3, 1.3);
        Given given = random_solid(random);
        given.insert({{"L", L}, {"A", share * L / pi}, {"rho", random.log_uniform(1e-6, 1e6)}});
        const auto place = [&](Random& r) { return Place<1>{L * r.uniform(0, 1)}; };
        fuzz<1>(bar_mms(), given, std::abs(share) < 1, {L / pi, 1 - std::abs(share)}, place, random, tally);
    }
    CHECK(tally.mostly_checked());
}

TEST_CASE("bar_mms: the gate rings for seeded faults", "[alarm]") {
    const BarMms bar{.A = 0.05, .elastic = solid(1e7, 0.3)};
    const Motion<1> good = motion_of(bar);
    CHECK(ringing(good) == "");
    using Point = MaterialPoint<1>;
    const auto rings = [&](auto fault, const std::string& gate) {
        CHECK_THAT(ringing(with(good, fault)), ContainsSubstring(gate));
    };
    rings([](Point& p, auto, double) { p.u[0] *= 1 + 1e-6; }, "balance");
    rings([](Point& p, auto, double) { p.v[0] *= 1 + 1e-6; }, "velocity");
    rings([](Point& p, auto, double) { p.strain[0] *= 1 + 1e-6; }, "deformation");
    rings([](Point& p, auto, double) { p.F[0] += 1e-6; }, "deformation");
    rings([](Point& p, auto, double) { p.P[0] *= 1 + 1e-6; }, "law");
    rings([](Point& p, auto, double) { p.stress[0] *= p.F[0]; }, "law");
    rings([](Point& p, auto, double) { p.b[0] *= 1 + 1e-6; }, "balance");
    rings([](Point& p, auto, double) { p.b[0] = -p.b[0]; }, "balance");
    rings([](Point& p, auto, double) { p.b[0] = std::nan(""); }, "balance");
    // The force without its 1 / F^2, and the force of another Poisson's ratio.
    rings([&](Point& p, auto, double) { p.b[0] = pi * pi * p.u[0] * (bar.elastic.M - bar.elastic.E) / 1000; },
          "balance");
    auto other = bar;
    other.elastic = solid(1e7, 0.3 + 1e-6);
    rings([&](Point& p, const Place<1>& X, double t) { p.b = other.at(X, t).b; }, "balance");
}

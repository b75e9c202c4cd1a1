#include "oracles/manufactured/periodic_bar_mms.hpp"

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

Motion<1> motion_of(const PeriodicBarMms& bar) {
    std::vector<Place<1>> points;
    for (const double share : {0.0, 0.083, 0.214, 0.385, 0.502, 0.668, 0.813, 1.0}) points.push_back({share * bar.L});
    return {.at = [bar](const Place<1>& X, double t) { return bar.at(X, t); },
            .elastic = elastic_constants({Elastic::lambda, 0}, {Elastic::G, bar.E / 2}, ""),
            .rho = bar.rho,
            .length = bar.L / (2 * pi) * 0.7,
            .omega = pi / bar.L * std::sqrt(bar.E / bar.rho),
            .points = points};
}

std::vector<PeriodicBarMms> bars() {
    return {{}, {.A = -0.05}, {.L = 50, .A = 3, .rho = 1.3, .E = 7}, {.L = 0.02, .A = 0.001, .rho = 7850, .E = 2.1e11}};
}

}  // namespace

TEST_CASE("periodic_bar_mms: deformation, velocity, law and balance of momentum follow from the motion", "[gate]") {
    for (const auto& bar : bars()) CHECK(ringing(motion_of(bar)) == "");
}

TEST_CASE("periodic_bar_mms: one end is the other, the start is deformed and at rest", "[gate]") {
    for (const auto& bar : bars()) {
        const double period = 2 * bar.L / std::sqrt(bar.E / bar.rho);
        for (const double share : {0.0, 0.11, 0.37}) {
            const double t = share * period;
            const auto left = bar.at({0}, t), right = bar.at({bar.L}, t);
            CHECK((left.u[0] == 0 && right.u[0] == 0 && left.F[0] == right.F[0] && left.P[0] == right.P[0]));
            // Half a period later everything has changed sign; F about 1 too.
            const auto now = bar.at({0.3 * bar.L}, t), later = bar.at({0.3 * bar.L}, t + period / 2);
            CHECK(std::abs(now.u[0] + later.u[0]) < 32 * eps * std::abs(bar.A));
            CHECK(std::abs(now.strain[0] + later.strain[0]) < 32 * eps * 2 * pi * std::abs(bar.A) / bar.L);
        }
        const auto start = bar.at({bar.L / 4}, 0);
        CHECK(std::abs(start.u[0] / bar.A - 1) < 4 * eps);
        CHECK(bar.at({0.2 * bar.L}, 0).v[0] == 0);
    }
}

TEST_CASE("periodic_bar_mms: E may come from any two constants, the law stays without Poisson's effect", "[unit]") {
    const Oracle oracle = periodic_bar_mms();
    const auto bound = [&](const Given& given) {
        return oracle.bind(resolve(oracle.parameters, given, "", "periodic_bar_mms"));
    };
    const auto stress = [&](const Given& given) {
        const Exact exact = bound(given);
        std::vector<double> row(exact.width());
        const double X = 0.1;
        exact.sample({&X, 1}, 0.2, row);
        return row[2];
    };
    CHECK(stress({{"E", 5.0}}) == stress({{"nu", 0.25}, {"G", 2.0}}));
    CHECK_THROWS_WITH(bound({{"A", 0.16}}), ContainsSubstring("must be below L/(2 pi) = 0.159"));
    CHECK_THROWS_WITH(bound({{"G", 2.0}}), ContainsSubstring("only G = 2 is given"));
}

TEST_CASE("periodic_bar_mms: random bars keep the balance of momentum, or are inside out", "[property]") {
    Random random(2);
    Tally tally;
    for (int round = 0; round < fuzz_rounds(300); ++round) {
        const double L = random.log_uniform(1e-6, 1e6);
        const double share = random.uniform(-1.3, 1.3);
        Given given = random_solid(random);
        given.insert({{"L", L}, {"A", share * L / (2 * pi)}, {"rho", random.log_uniform(1e-6, 1e6)}});
        const auto place = [&](Random& r) { return Place<1>{L * r.uniform(0, 1)}; };
        fuzz<1>(periodic_bar_mms(), given, std::abs(share) < 1, {L / (2 * pi), 1 - std::abs(share)}, place, random,
                tally);
    }
    CHECK(tally.mostly_checked());
}

TEST_CASE("periodic_bar_mms: the gate rings for seeded faults", "[alarm]") {
    const PeriodicBarMms bar{.L = 2, .A = 0.1, .rho = 3, .E = 70};
    const Motion<1> good = motion_of(bar);
    CHECK(ringing(good) == "");
    using Point = MaterialPoint<1>;
    const auto rings = [&](auto fault, const std::string& gate) {
        CHECK_THAT(ringing(with(good, fault)), ContainsSubstring(gate));
    };
    rings([](Point& p, auto, double) { p.u[0] *= 1 + 1e-6; }, "balance");
    rings([](Point& p, auto, double) { p.v[0] = -p.v[0]; }, "velocity");
    rings([](Point& p, auto, double) { p.strain[0] *= 1 + 1e-6; }, "deformation");
    rings([](Point& p, auto, double) { p.P[0] *= 1 + 1e-6; }, "law");
    rings([&](Point& p, auto, double) { p.b[0] = 3 * bar.omega() * bar.omega() * p.u[0]; }, "balance");  // F forgotten
    rings([&](Point& p, auto, double) { p.b[0] = bar.omega() * bar.omega() * p.u[0] * (1 + 2 / p.F[0]); }, "balance");
    // The helper in circulation that drops the length from the time's argument: right for L = 1 only.
    rings([&](Point& p, const Place<1>& X, double t) { p.b = bar.at(X, t * bar.L).b; }, "balance");
}

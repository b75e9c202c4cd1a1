#include "oracles/manufactured/ring_mms.hpp"

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

Place<2> polar(double R, double angle) { return {R * std::cos(angle), R * std::sin(angle)}; }

Motion<2> motion_of(const RingMms& ring) {
    const double width = ring.r_o - ring.r_i;
    std::vector<Place<2>> points;
    for (const auto& [share, angle] : {std::array{0.16, 0.3}, {0.31, 2.2}, {0.52, -1.1}, {0.84, 4.0}})
        points.push_back(polar(ring.r_i + width * share, angle));
    return {.at = [ring](const Place<2>& X, double t) { return ring.at(X, t); },
            .elastic = ring.elastic,
            .rho = ring.rho,
            .length = std::min(0.7 * width, ring.r_i),
            .omega = pi / (ring.r_i + ring.r_o) * std::sqrt(ring.elastic.E / ring.rho),
            .points = points};
}

std::vector<RingMms> rings() {
    return {{},
            {.A = -0.2},
            {.r_i = 2, .r_o = 3.1, .A = 0.5, .rho = 7, .elastic = solid(3, 0.37)},
            {.r_i = 0.01, .r_o = 0.05, .A = 0.01, .rho = 7850, .elastic = solid(2.1e11, -0.3)}};
}

/// e_R^T tensor e_R and e_O^T tensor e_R at X.
std::array<double, 2> on_circle(const std::array<double, 4>& tensor, const Place<2>& X) {
    const double R = std::hypot(X[0], X[1]), c = X[0] / R, s = X[1] / R;
    const double x = tensor[0] * c + tensor[1] * s, y = tensor[2] * c + tensor[3] * s;
    return {c * x + s * y, c * y - s * x};
}

/// The cubic c1 R + c2 R^2 + c3 R^3 from what it must do: no slope on the rims, 1 on the outer one.
struct Cubic {
    double r_i, r_o;
    double value(double R) const {
        // f' = q (R - r_i)(r_o - R), f(0) = 0, f(r_o) = 1.
        const auto area = [&](double to) { return to * to * (r_i + r_o) / 2 - to * to * to / 3 - r_i * r_o * to; };
        return area(R) / area(r_o);
    }
};

}  // namespace

TEST_CASE("ring_mms: deformation, velocity, law and balance of momentum follow from the motion", "[gate]") {
    for (const auto& ring : rings()) CHECK(ringing(motion_of(ring)) == "");
}

TEST_CASE("ring_mms: rims are not stretched across and free of traction without Poisson's effect", "[gate]") {
    for (const auto& ring : rings()) {
        for (const double phase : {0.0, 0.4, 2.2, 5.0}) {
            for (const double R : {ring.r_i, ring.r_o}) {
                const auto X = polar(R, 1 + phase);
                const auto p = ring.at(X, phase / ring.omega());
                const auto F = on_circle(p.F, X), P = on_circle(p.P, X), stress = on_circle(p.stress, X);
                const double F_O = p.F[0] + p.F[3] - F[0];
                const double rim = ring.elastic.lambda * std::log(F_O);
                const double error = 32 * eps * ring.elastic.M * (1 + phase);
                CHECK((std::abs(F[0] - 1) < 16 * eps && std::abs(F[1]) < 16 * eps));
                CHECK((std::abs(P[0] - rim) < error && std::abs(P[1]) < error));
                CHECK((std::abs(stress[0] - rim / F_O) < error && std::abs(stress[1]) < error));
            }
        }
    }
}

TEST_CASE("ring_mms: circles stay circles, the outer rim moves by A sin(omega t), all points by the cubic", "[gate]") {
    for (const auto& ring : rings()) {
        const Cubic f{ring.r_i, ring.r_o};
        const double t = 0.6 / ring.omega();
        for (const double share : {0.0, 0.3, 0.77, 1.0}) {
            const double R = ring.r_i + share * (ring.r_o - ring.r_i);
            for (const double angle : {0.0, 0.9, 3.3}) {
                const auto X = polar(R, angle);
                const auto u = ring.at(X, t).u;
                const double u_R = ring.A * std::sin(0.6) * f.value(R);
                CHECK(std::abs(u[0] - u_R * X[0] / R) < 64 * eps * std::abs(ring.A));
                CHECK(std::abs(u[1] - u_R * X[1] / R) < 64 * eps * std::abs(ring.A));
            }
        }
        CHECK(f.value(ring.r_o) == 1);
        CHECK(ring.at({ring.r_i, 0}, 0).u[0] == 0);
    }
}

TEST_CASE("ring_mms: points off the ring, a crushed ring and r_o = 3 r_i are refused", "[unit]") {
    const Oracle oracle = ring_mms();
    const auto bound = [&](const Given& given) {
        return oracle.bind(resolve(oracle.parameters, given, "", "ring_mms"));
    };
    const Exact exact = bound({});
    std::vector<double> row(exact.width());
    const auto sample = [&](double x, double y) { exact.sample(std::array{x, y}, 0.001, row); };
    CHECK_THROWS_WITH(sample(0.1, 0.2), ContainsSubstring("oracle ring_mms: (0.1, 0.2) lies at R = 0.2236") &&
                                            ContainsSubstring("off the ring: R must be in [0.4, 0.6]"));
    CHECK_THROWS_AS(sample(0.6, 0.6), InputError);
    CHECK_THROWS_AS(sample(0, 0), InputError);
    CHECK_NOTHROW(sample(0.6, 0));
    for (double angle = 0; angle < 7; angle += 0.01) {  // a rim's points, however they round
        CHECK_NOTHROW(sample(0.6 * std::cos(angle), 0.6 * std::sin(angle)));
        CHECK_NOTHROW(sample(0.4 * std::cos(angle), 0.4 * std::sin(angle)));
    }
    CHECK_THROWS_WITH(bound({{"r_i", 0.7}}), ContainsSubstring("r_i = 0.7 m, but must be below r_o = 0.6"));
    CHECK_THROWS_WITH(bound({{"r_i", 0.25}, {"r_o", 0.75}}), ContainsSubstring("r_o = 3 r_i"));
    CHECK_THROWS_WITH(bound({{"A", 0.5}}), ContainsSubstring("turns the ring inside out (det F <= 0); must be below"));
}

TEST_CASE("ring_mms: random rings keep the balance of momentum, or are inside out", "[property]") {
    Random random(4);
    Tally tally;
    for (int round = 0; round < fuzz_rounds(150); ++round) {
        const double r_i = random.log_uniform(1e-6, 1e6), r_o = r_i * (1 + random.log_uniform(0.05, 8));
        // Whether it is crushed, by looking at F along a radius; amplitudes that leave the answer to round-off are
        // moved.
        const Cubic f{r_i, r_o};
        double most = 0;
        for (int n = 0; n <= 4000; ++n) {
            const double R = r_i + (r_o - r_i) * n / 4000;
            const double slope = 6 * (R - r_i) * (r_o - R) / (r_o * r_o * (r_o - 3 * r_i));
            most = std::max({most, std::abs(f.value(R) / R), std::abs(slope)});
        }
        double share = random.uniform(-1.3, 1.3);
        if (std::abs(std::abs(share) - 1) < 1e-5) share = 0.5;
        Given given = random_solid(random);
        given.insert({{"r_i", r_i}, {"r_o", r_o}, {"A", share / most}, {"rho", random.log_uniform(1e-6, 1e6)}});
        const double width = r_o - r_i;
        const auto place = [&](Random& r) { return polar(r_i + width * r.uniform(0.16, 0.84), r.uniform(0, 7)); };
        fuzz<2>(ring_mms(), given, std::abs(share) < 1, {std::min(0.7 * width, r_i), 1 - std::abs(share)}, place,
                random, tally);
    }
    CHECK(tally.mostly_checked());
}

TEST_CASE("ring_mms: the gate rings for seeded faults", "[alarm]") {
    const RingMms ring{.r_i = 2, .r_o = 3.1, .A = 0.5, .rho = 7, .elastic = solid(3, 0.37)};
    const Motion<2> good = motion_of(ring);
    CHECK(ringing(good) == "");
    using Point = MaterialPoint<2>;
    const auto rings = [&](auto fault, const std::string& gate) {
        CHECK_THAT(ringing(with(good, fault)), ContainsSubstring(gate));
    };
    rings([](Point& p, auto, double) { p.v[1] *= 1 + 1e-6; }, "velocity");
    rings([](Point& p, auto, double) { p.F[1] += 1e-6; }, "deformation");
    rings([](Point& p, auto, double) { p.P[0] *= 1 + 1e-6; }, "law");
    rings([](Point& p, auto, double) { p.stress = p.P; }, "law");
    rings([](Point& p, auto, double) { p.b[0] = -p.b[0]; }, "balance");
    // The force without the stress that turns with the circle, (P_R - P_O) / R.
    rings(
        [](Point& p, const Place<2>& X, double) {
            const double R = std::hypot(X[0], X[1]), P_R = on_circle(p.P, X)[0], P_O = p.P[0] + p.P[3] - P_R;
            for (std::size_t i = 0; i < 2; ++i) p.b[i] += (P_R - P_O) / R / 7 * X[i] / R;
        },
        "balance");
    auto other = ring;
    other.elastic.lambda *= 1 + 1e-6;
    rings([other](Point& p, const Place<2>& X, double t) { p.b = other.at(X, t).b; }, "balance");
    other = ring;
    other.r_i *= 1 + 1e-6;
    rings([other](Point& p, const Place<2>& X, double t) { p.b = other.at(X, t).b; }, "balance");
}

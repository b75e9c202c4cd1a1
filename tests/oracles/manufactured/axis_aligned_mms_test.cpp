#include "oracles/manufactured/axis_aligned_mms.hpp"

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

constexpr double third = 2 * pi / 3;

ElasticConstants solid(double E, double nu) { return elastic_constants({Elastic::E, E}, {Elastic::nu, nu}, ""); }

template <std::size_t dim>
Motion<dim> motion_of(const AxisAlignedMms& body) {
    std::vector<Place<dim>> points(4);
    for (std::size_t n = 0; n < points.size(); ++n) {
        for (std::size_t a = 0; a < dim; ++a)
            points[n][a] = body.L * std::array{0.0, 0.183, 0.414, 0.668, 0.913, 1.0}[n + a];
    }
    const double c = body.speed ? *body.speed : std::sqrt(body.elastic.E / body.rho);
    return {.at = [body](const Place<dim>& X, double t) { return body.at(X, t); },
            .elastic = body.elastic,
            .rho = body.rho,
            .length = body.L / (body.k * pi) * 0.7,
            .omega = pi / body.L * c,
            .points = points};
}

// The set-ups of the literature, each under the name of its code.
const double rim_c = std::sqrt(0.4);
const AxisAlignedMms uintah{.rho = 1, .phase = {0, third, 2 * third}, .elastic = solid(1e4, 0.3)};
const AxisAlignedMms mpmat{.A = 0.1, .phase = {0, pi, 0}};
const AxisAlignedMms karamelo{.A = 1e-4, .rho = 7.75e-6, .phase = {0, pi, pi}, .elastic = solid(211, 0.33)};
const AxisAlignedMms bsmpm{.A = 0.005, .rho = 100, .k = 2, .phase = {0, pi, 0}, .elastic = solid(100, 0)};
const AxisAlignedMms rim{.A = 0.01 / (rim_c * pi),
                         .rho = 1,
                         .speed = rim_c,
                         .elastic = elastic_constants({Elastic::lambda, 0.3}, {Elastic::G, 0.4}, "")};
const AxisAlignedMms large{.L = 3, .A = -0.25, .rho = 2, .k = 2, .phase = {0.3, 1, 5}, .elastic = solid(7, 0.41)};

}  // namespace

TEST_CASE("axis_aligned_mms: deformation, velocity, law and balance of momentum follow from the motion", "[gate]") {
    for (const auto& body : {AxisAlignedMms{}, mpmat, bsmpm, rim, large}) CHECK(ringing(motion_of<2>(body)) == "");
    for (const auto& body : {AxisAlignedMms{}, uintah, karamelo, large}) CHECK(ringing(motion_of<3>(body)) == "");
}

TEST_CASE("axis_aligned_mms: normal displacement is 0 on every face and there is no shear", "[gate]") {
    for (const auto& body : {uintah, large}) {
        for (const double t : {0.0, 0.7 / body.omega(), 5 / body.omega()}) {
            for (const double face : {0.0, body.L}) {
                CHECK(body.at(Place<2>{face, 0.3 * body.L}, t).u[0] == 0);
                CHECK(body.at(Place<2>{0.3 * body.L, face}, t).v[1] == 0);
                CHECK(body.at(Place<3>{0.3 * body.L, 0.2 * body.L, face}, t).u[2] == 0);
            }
            const auto p = body.at(Place<3>{0.3 * body.L, 0.9 * body.L, 0.1 * body.L}, t);
            for (std::size_t i = 0; i < 3; ++i) {
                for (std::size_t J = 0; J < 3; ++J) CHECK((i == J || (p.F[3 * i + J] == 0 && p.P[3 * i + J] == 0)));
            }
        }
    }
}

TEST_CASE("axis_aligned_mms: the body force with c^2 = mu / rho is the published closed form", "[published]") {
    // b_a = (c0^2 - mu) f'_a + (lambda ln(f_x f_y) - (lambda + mu)) f'_a / f_a^2, f_a = F_aa, rho = 1, c0^2 = mu.
    for (const double t : {0.0, 0.4, 1.3, 3.1}) {
        for (const auto& X : {Place<2>{0.2, 0.7}, Place<2>{0.45, 0.11}, Place<2>{0.9, 0.5}}) {
            const auto p = rim.at(X, t);
            const double wave = 0.01 / rim_c * std::sin(rim_c * pi * t);
            for (std::size_t a = 0; a < 2; ++a) {
                const double slope = -pi * wave * std::sin(pi * X[a]);
                const double f = 1 + wave * std::cos(pi * X[a]);
                const double ln_J = std::log((1 + wave * std::cos(pi * X[0])) * (1 + wave * std::cos(pi * X[1])));
                const double b = (rim_c * rim_c - 0.4) * slope + (0.3 * ln_J - 0.7) * slope / (f * f);
                CHECK(std::abs(p.b[a] - b) < 1e-14);
            }
        }
    }
}

TEST_CASE("axis_aligned_mms: along one axis it is the bar that is held at its sides", "[gate]") {
    // phase_y such that sin(omega t + phase_y) = 0 at one time: then y does not move, and F_yy = 1.
    const double t = 0.3 / mpmat.omega();
    auto body = mpmat;
    body.phase = {0, -0.3, 0};
    const auto p = body.at(Place<2>{0.4, 0.2}, t);
    const double F = p.F[0], lambda = body.elastic.lambda, mu = body.elastic.G;
    CHECK(std::abs(p.u[1]) < 1e-16);
    CHECK(p.stress[0] == Approx(lambda * std::log(F) / F + mu * (F - 1 / F)).epsilon(1e-13));
    CHECK(p.stress[3] == Approx(lambda * std::log(F) / F).epsilon(1e-12));
}

TEST_CASE("axis_aligned_mms: what turns the body inside out is refused, and c stands for itself", "[unit]") {
    const Oracle oracle = axis_aligned_mms();
    const auto bound = [&](const Given& given) {
        return oracle.bind(resolve(oracle.parameters, given, "", "axis_aligned_mms"));
    };
    CHECK_THROWS_WITH(bound({{"A", 0.16}, {"k", 2.0}}),
                      ContainsSubstring("A = 0.16 m with k = 2 turns the body inside"));
    CHECK_THROWS_WITH(bound({{"dim", 1.0}}), ContainsSubstring("'dim' is 1, but must be a whole number in [2, 3]"));
    CHECK_THROWS_AS(bound({{"c", 0.0}}), InputError);
    CHECK(bound({{"dim", 3.0}}).width() == 3 * 3 + 4 * 9);
    CHECK(std::get<double>(bound({{"c", 7.0}}).constants(std::nullopt).at(6).value) == 7);
}

TEST_CASE("axis_aligned_mms: random bodies keep the balance of momentum, or are inside out", "[property]") {
    Random random(3);
    Tally tally;
    for (int round = 0; round < fuzz_rounds(150); ++round) {
        const double L = random.log_uniform(1e-6, 1e6), share = random.uniform(-1.2, 1.2);
        const int k = random.whole(1, 12);
        Given given = random_solid(random);
        given.insert({{"L", L}, {"A", share * L / (k * pi)}, {"rho", random.log_uniform(1e-6, 1e6)}});
        given.insert({{"k", double(k)}, {"phase_x", random.uniform(0, 6)}, {"phase_y", random.uniform(0, 6)}});
        const Grain grain{L / (k * pi), 1 - std::abs(share)};
        const bool possible = std::abs(share) < 1;
        if (random.coin()) {
            const auto place = [&](Random& r) { return Place<2>{L * r.uniform(0, 1), L * r.uniform(0, 1)}; };
            fuzz<2>(axis_aligned_mms(), given, possible, grain, place, random, tally);
        } else {
            given["dim"] = 3.0;
            const auto place = [&](Random& r) {
                return Place<3>{L * r.uniform(0, 1), L * r.uniform(0, 1), L * r.uniform(0, 1)};
            };
            fuzz<3>(axis_aligned_mms(), given, possible, grain, place, random, tally);
        }
    }
    CHECK(tally.mostly_checked());
}

TEST_CASE("axis_aligned_mms: the gate rings for seeded faults", "[alarm]") {
    const Motion<2> good = motion_of<2>(large);
    CHECK(ringing(good) == "");
    using Point = MaterialPoint<2>;
    const auto rings = [&](auto fault, const std::string& gate) {
        CHECK_THAT(ringing(with(good, fault)), ContainsSubstring(gate));
    };
    const auto force_of = [&](const AxisAlignedMms& other) {
        return [other](Point& p, const Place<2>& X, double t) { p.b = other.at(X, t).b; };
    };
    rings([](Point& p, auto, double) { p.u[1] *= 1 + 1e-6; }, "balance");
    rings([](Point& p, auto, double) { p.P[3] *= 1 + 1e-6; }, "law");
    rings([](Point& p, auto, double) { p.stress = p.P; }, "law");
    rings([](Point& p, auto, double) { std::swap(p.b[0], p.b[1]); }, "balance");
    rings([](Point& p, auto, double) { std::swap(p.strain[0], p.strain[3]); }, "deformation");
    // ln F_aa where ln J is right.
    const double wave = large.k * pi / large.L;
    rings(
        [&](Point& p, auto, double) {
            p.b[0] -= wave * wave * p.u[0] * large.elastic.lambda * (std::log(p.F[0]) - std::log(p.F[0] * p.F[3])) /
                      (large.rho * p.F[0] * p.F[0]);
        },
        "balance");
    auto other = large;
    other.k = 1;
    rings(force_of(other), "balance");
    other = large;
    other.speed = large.c() * (1 + 1e-6);
    rings([other](Point& p, const Place<2>& X, double t) { p.b = other.at(X, t * (1 - 1e-6)).b; }, "balance");
    other = large;
    other.elastic.lambda *= 1 + 1e-6;
    rings(force_of(other), "balance");
}

#include "oracles/manufactured/vortex_mms.hpp"

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

Motion<2> motion_of(const VortexMms& vortex) {
    const double width = vortex.r_o - vortex.r_i;
    std::vector<Place<2>> points;
    for (const auto& [share, angle] : {std::array{0.16, 0.3}, {0.31, 2.2}, {0.52, -1.1}, {0.84, 4.0}})
        points.push_back(polar(vortex.r_i + width * share, angle));
    // Shear over a circle's turn: the motion changes faster where it turns far.
    const double fine = 1 + std::abs(vortex.A);
    return {.at = [vortex](const Place<2>& X, double t) { return vortex.at(X, t); },
            .elastic = vortex.elastic,
            .rho = vortex.rho,
            .length = std::min(0.4 * width, vortex.r_i),
            .omega = vortex.omega(),
            .points = points,
            .digits = 8 * eps * fine * vortex.r_o / width,
            .share = 0.1 / fine};
}

// The set-ups of the literature, and others.
const VortexMms uintah{};
const VortexMms karamelo{.rho = 1050, .pulse = pi, .elastic = solid(1e6, 0.3)};
const VortexMms tesserae{.A = pi, .pulse = pi, .elastic = solid(1e6, 0.3)};
const VortexMms wide{.r_i = 0.4, .r_o = 3, .A = -0.6, .rho = 1.3, .pulse = 1.7, .elastic = solid(8, -0.2)};
const VortexMms published{
    .A = 0.9, .rho = 1.3, .pulse = 1.1 * pi, .elastic = elastic_constants({Elastic::G, 3}, {Elastic::nu, 0.3}, "")};

/// The force in the polar basis of X, as it stands in public codes; the `sign` in its second component is +1 there and
/// must be -1.
Place<2> circulating_force(const VortexMms& vortex, const Place<2>& X, double t, double sign) {
    const double m = vortex.elastic.G / vortex.rho, R = std::hypot(X[0], X[1]);
    const double g = vortex.A * std::sin(vortex.omega() * t),
                 g1 = vortex.A * vortex.omega() * std::cos(vortex.omega() * t);
    const double g2 = -vortex.omega() * vortex.omega() * g;
    const double h = 1 - 32 * std::pow(R - 1, 2) + 256 * std::pow(R - 1, 4);
    const double h1 = -64 * (R - 1) + 1024 * std::pow(R - 1, 3), h2 = -64 + 3072 * std::pow(R - 1, 2);
    const double s = std::sin(g * h), c = std::cos(g * h);
    const double turning = m * (3 * g * h1 + R * g * h2) - R * g2 * h;
    const double pull = m * R * g * h1 * g * h1, swing = R * g1 * h * g1 * h;
    const double b_R = turning * s + (pull - swing) * c, b_O = -turning * c + (pull + sign * swing) * s;
    return {b_R * X[0] / R - b_O * X[1] / R, b_R * X[1] / R + b_O * X[0] / R};
}

}  // namespace

TEST_CASE("vortex_mms: deformation, velocity, law and balance of momentum follow from the motion", "[gate]") {
    for (const auto& vortex : {uintah, karamelo, tesserae, wide, published}) CHECK(ringing(motion_of(vortex)) == "");
}

TEST_CASE("vortex_mms: the rims are at rest and free of traction, volume and distance stay", "[gate]") {
    for (const auto& vortex : {uintah, tesserae, wide}) {
        for (const double phase : {0.0, 0.4, 2.2, 5.0}) {
            const double t = phase / vortex.omega();
            for (const auto& X : {Place<2>{vortex.r_i, 0}, Place<2>{0, -vortex.r_o}}) {
                const auto p = vortex.at(X, t);
                CHECK((p.u[0] == 0 && p.u[1] == 0 && p.v[0] == 0 && p.v[1] == 0));
                for (const double component : p.P) CHECK(component == 0);
                for (const double component : p.stress) CHECK(component == 0);
            }
            for (const double share : {0.1, 0.43, 0.8}) {
                const auto X = polar(vortex.r_i + share * (vortex.r_o - vortex.r_i), 1 + phase);
                const auto p = vortex.at(X, t);
                const double shear = std::abs(p.F[0] * p.F[3]) + std::abs(p.F[1] * p.F[2]);
                CHECK(std::abs(determinant<2>(p.F) - 1) < 8 * eps * shear);
                const double R = std::hypot(X[0], X[1]);
                CHECK(std::abs(std::hypot(X[0] + p.u[0], X[1] + p.u[1]) - R) < 4 * eps * R);
            }
        }
    }
}

TEST_CASE("vortex_mms: the circle half-way turns by A sin(omega t)", "[gate]") {
    for (const auto& vortex : {uintah, wide, published}) {
        const double R = (vortex.r_i + vortex.r_o) / 2;
        const auto p = vortex.at({R, 0}, 0.7 / vortex.omega());
        const double alpha = vortex.A * std::sin(0.7);
        CHECK(std::abs(R + p.u[0] - R * std::cos(alpha)) < 8 * eps * R);
        CHECK(std::abs(p.u[1] - R * std::sin(alpha)) < 8 * eps * R);
    }
    CHECK(std::abs(uintah.omega() - pi) < 4 * eps);  // T = sin(c pi t), c = 1
}

TEST_CASE("vortex_mms: the exact force at a point, and the one that circulates", "[published]") {
    // 40-digit differentiation of the motion at X = (0.7, 0.6), A = 0.9, c = 1.1, mu = 3, rho = 1.3, t = 0.2.
    const auto b = published.at({0.7, 0.6}, 0.2).b;
    CHECK(std::abs(b[0] - -25.62439543903746) < 1e-13);
    CHECK(std::abs(b[1] - 22.28956358172248) < 1e-13);
    const auto right = circulating_force(published, {0.7, 0.6}, 0.2, -1);
    CHECK((std::abs(right[0] - b[0]) < 1e-12 && std::abs(right[1] - b[1]) < 1e-12));
    const auto wrong = circulating_force(published, {0.7, 0.6}, 0.2, 1);
    CHECK((std::abs(wrong[0] + 27.68) < 0.005 && std::abs(wrong[1] - 24.69) < 0.005));
}

TEST_CASE("vortex_mms: only the shear modulus matters once omega is given", "[gate]") {
    auto stiff = published;
    stiff.elastic = elastic_constants({Elastic::G, 3}, {Elastic::K, 1e9}, "");
    const auto a = published.at({0.7, 0.6}, 0.2), b = stiff.at({0.7, 0.6}, 0.2);
    CHECK((a.u == b.u && a.stress == b.stress && a.P == b.P && a.b == b.b));
}

TEST_CASE("vortex_mms: points off the ring and impossible rings are refused", "[unit]") {
    const Oracle oracle = vortex_mms();
    const auto bound = [&](const Given& given) {
        return oracle.bind(resolve(oracle.parameters, given, "", "vortex_mms"));
    };
    const Exact exact = bound({});
    std::vector<double> row(exact.width());
    CHECK_THROWS_WITH(exact.sample(std::array{0.5, 0.5}, 0.1, row), ContainsSubstring("off the ring"));
    CHECK_NOTHROW(exact.sample(std::array{0.75, 0.0}, 0.1, row));
    CHECK_THROWS_WITH(bound({{"r_i", 1.25}}), ContainsSubstring("must be below r_o = 1.25"));
    CHECK_THROWS_WITH(bound({{"omega", -1.0}}), ContainsSubstring("'omega' is -1"));
    CHECK_THROWS_WITH(bound({{"nu", 0.3}}), ContainsSubstring("only nu = 0.3 is given"));
}

TEST_CASE("vortex_mms: random vortices keep the balance of momentum", "[property]") {
    Random random(5);
    Tally tally;
    for (int round = 0; round < fuzz_rounds(150); ++round) {
        const double r_i = random.log_uniform(1e-6, 1e6), width = r_i * random.log_uniform(0.05, 8);
        const double A = random.uniform(-3, 3);
        const bool turned = random.whole(0, 9) == 0;  // rims the wrong way round
        Given given = random_solid(random);
        given.insert({{"r_i", turned ? r_i + width : r_i}, {"r_o", turned ? r_i : r_i + width}, {"A", A}});
        given.insert({{"rho", random.log_uniform(1e-6, 1e6)}});
        if (random.coin()) given["omega"] = random.log_uniform(1e-6, 1e6);
        const auto place = [&](Random& r) { return polar(r_i + width * r.uniform(0.16, 0.84), r.uniform(0, 7)); };
        const Grain grain{std::min(0.7 * width, r_i), 1 / (1 + std::abs(A))};
        fuzz<2>(vortex_mms(), given, !turned, grain, place, random, tally);
    }
    CHECK(tally.mostly_checked());
}

TEST_CASE("vortex_mms: the gate rings for seeded faults", "[alarm]") {
    const Motion<2> good = motion_of(published);
    CHECK(ringing(good) == "");
    using Point = MaterialPoint<2>;
    const auto rings = [&](auto fault, const std::string& gate) {
        CHECK_THAT(ringing(with(good, fault)), ContainsSubstring(gate));
    };
    rings([](Point& p, const Place<2>& X, double t) { p.b = circulating_force(published, X, t, 1); }, "balance");
    CHECK(ringing(with(good, [](Point& p, const Place<2>& X, double t) {
              p.b = circulating_force(published, X, t, -1);
          })) == "");
    rings([](Point& p, auto, double) { p.b[0] *= 1 + 1e-6; }, "balance");
    rings([](Point& p, auto, double) { p.P[1] *= 1 + 1e-6; }, "law");
    rings([](Point& p, auto, double) { std::swap(p.F[1], p.F[2]); }, "deformation");
    rings([](Point& p, auto, double) { p.stress = p.P; }, "law");
    rings([](Point& p, auto, double) { p.v[0] *= 1 + 1e-6; }, "velocity");
    auto other = published;
    other.rho *= 1 + 1e-6;
    rings([other](Point& p, const Place<2>& X, double t) { p.b = other.at(X, t).b; }, "balance");
    // The other way round in time only: alpha for -alpha in F, with everything else right.
    rings([](Point& p, const Place<2>& X, double t) { p.F = published.at(X, -t).F; }, "deformation");
}

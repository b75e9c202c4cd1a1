#include "oracles/plasticity/j2_rotating_stress.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/fuzz.hpp"
#include "tests/oracles/plasticity/j2_rotating_stress_gate.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::spinning_axes;

namespace {

/// Slow and fast, neutral, in shear and in tension along e3, under pressure, the other way round.
std::vector<Spinning> cases() {
    return {spinning({}), spinning({.spin = -3, .plastic_rate = 0.002, .share = 0.4, .pressure = 7e8}),
            spinning({.K = 5, .G = 0.4, .Y0 = 0.01, .spin = 0.2, .plastic_rate = 0, .share = -0.8, .pressure = -0.02}),
            spinning({.K = 2, .G = 1.5, .Y0 = 0.3, .spin = 1e-9, .plastic_rate = 0.5, .share = 0.1}),
            spinning({.spin = 2, .plastic_rate = 0.1, .share = 1})};
}

double error_of_backward_euler(const Spinning& claimed, int steps, double end) {
    Point point{claimed.stress(0), 0};
    for (int n = 0; n < steps; ++n) {
        const Tensor step = combined(1, claimed.strain(end * (n + 1) / steps), -1, claimed.strain(end * n / steps));
        point = backward_euler(claimed.metal(), point, step);
    }
    const Tensor off = combined(1, point.stress, -1, claimed.stress(end));
    return std::sqrt(inner(off, off)) / claimed.solid.Y0;
}

}  // namespace

TEST_CASE("j2_rotating_stress: flow rule and resting principal stresses hold", "[gate]") {
    for (const auto& claimed : cases()) {
        for (const auto& gate : {flow_rule, turning}) {
            const Defect defect = gate(claimed);
            INFO("spin " << claimed.solid.spin << ", share " << claimed.solid.share << ": defect " << defect.found
                         << ", allowed " << defect.allowed);
            CHECK(defect.holds());
        }
    }
}

// Second route: given the strain alone (its rate by differences), the flow rule leads to the stress. Classical
// Runge-Kutta with 400 steps over an angle of 1.5: the fourth power of 0.004 is 2e-10.
TEST_CASE("j2_rotating_stress: the flow rule integrated from the strain gives the stress", "[gate]") {
    for (const auto& claimed : cases()) {
        const double end = 1.5 / std::max(1.0, std::abs(claimed.solid.spin));
        constexpr int steps = 400;
        const double h = end / steps;
        const auto rate = [&](double t, const Tensor& stress) {
            double error = 0;
            return flowing(claimed.metal(), stress, rate_of(claimed.strain, t, 0.02 * end, 0, error));
        };
        Tensor stress = claimed.stress(0);
        for (int n = 0; n < steps; ++n) {
            const double t = n * h;
            const Tensor a = rate(t, stress), b = rate(t + h / 2, combined(1, stress, h / 2, a));
            const Tensor c = rate(t + h / 2, combined(1, stress, h / 2, b)), d = rate(t + h, combined(1, stress, h, c));
            stress = combined(1, stress, h / 6, combined(1, combined(1, a, 1, d), 2, combined(1, b, 1, c)));
        }
        const Tensor off = combined(1, stress, -1, claimed.stress(end));
        CHECK(std::sqrt(inner(off, off)) <= 1e-8 * claimed.scale());
    }
}

TEST_CASE("j2_rotating_stress: radial return converges to the stress with order 1", "[convergence]") {
    for (const auto& claimed :
         {cases()[0], cases()[1], spinning({.K = 3, .G = 1, .Y0 = 0.1, .spin = 0.2, .plastic_rate = 0.4})}) {
        const double end = 1.0 / std::abs(claimed.solid.spin);
        double before = error_of_backward_euler(claimed, 200, end);
        for (const int steps : {400, 800, 1600, 3200}) {
            const double now = error_of_backward_euler(claimed, steps, end);
            INFO("spin " << claimed.solid.spin << ", " << steps << " steps, error " << now);
            CHECK(std::log2(before / now) == Approx(1).margin(0.03));
            before = now;
        }
    }
}

// Where the axes rest, the deviator keeps its direction, and one step is exact; so it is in neutral loading, where the
// elastic trial ends on the yield surface.
TEST_CASE("j2_rotating_stress: radial return is exact where nothing spins or nothing flows", "[gate]") {
    CHECK(error_of_backward_euler(spinning({.spin = 0, .share = 0.3}), 1, 0.7) < 64 * eps);
    CHECK(error_of_backward_euler(spinning({.spin = 2, .plastic_rate = 0.1, .share = -1}), 3, 0.7) < 64 * eps);
    CHECK(error_of_backward_euler(spinning({.spin = 2, .plastic_rate = 0, .share = 0.2}), 3, 0.7) < 64 * eps);
}

// G 79 GPa, yield in shear 165 MPa, strain in unit times from 0 to (-0.003, -0.003, 0.006), then to (-0.0103923, 0,
// 0.0103923): another exact solution, example 2 of the paper, two of its signs corrected. Its coefficients have four
// digits: 6e-4 of the stress; its exponent 12.33 t matters to a by 0.5 % t only, and to the stress the less the later.
TEST_CASE("j2: the tests' own integrator meets the printed solution of Brannon and Leelavanichkul", "[published]") {
    const Metal metal{79e9 * 8 / 3, 79e9, 165e6 * std::sqrt(3.0), 0};
    Point point = backward_euler(metal, {}, {-0.003, 0, 0, 0, -0.003, 0, 0, 0, 0.006});
    CHECK(point.stress[0] == Approx(-95.26e6).margin(5e3));
    CHECK(point.stress[8] == Approx(190.5e6).margin(5e4));
    constexpr int steps = 20000;
    for (int n = 1; n <= steps; ++n) {
        point = backward_euler(metal, point, {-0.0073923 / steps, 0, 0, 0, 0.003 / steps, 0, 0, 0, 0.0043923 / steps});
        const double t = 1 + double(n) / steps;
        if (n % (steps / 4) != 0) continue;
        const double a = std::exp(12.33 * t), b = std::sqrt(a), sum = 1e-6 + 0.00001712e-6 * a;
        const double margin = 6e-4 * 190e6 + (n < steps ? 1e6 : 0);
        INFO("t = " << t);
        CHECK(point.stress[0] == Approx((189.4 + 0.1704 * b - 0.003242 * a) / sum).margin(margin));
        CHECK(point.stress[4] == Approx(-(76.87 + 1.443 * b - 0.001316 * a) / sum).margin(margin));
        CHECK(point.stress[8] == Approx((-112.5 + 1.272 * b + 0.001926 * a) / sum).margin(margin));
    }
}

TEST_CASE("j2_rotating_stress: the declaration binds the same numbers to the same bits", "[unit]") {
    const Oracle oracle = j2_rotating_stress();
    const J2RotatingStress solid{7e10, 2.6e10, 3e8, -2, 0.05, 0.3, 1e7};
    const Exact exact = oracle.bind(resolve(oracle.parameters,
                                            {{"K", 7e10},
                                             {"G", 2.6e10},
                                             {"Y0", 3e8},
                                             {"spin", -2.0},
                                             {"plastic_rate", 0.05},
                                             {"share", 0.3},
                                             {"pressure", 1e7}},
                                            "", "x"));
    REQUIRE((exact.dim == 3 && exact.width() == 20 && exact.jumps(1).empty()));
    for (const double t : times) {
        std::vector<double> row(40);
        exact.sample(std::array{0.0, 0.0, 0.0, 1.0, -2.0, 3e5}, t, row);
        const auto strain = solid.strain(t), stress = solid.stress(t);
        CHECK((std::equal(strain.begin(), strain.end(), row.begin()) &&
               std::equal(stress.begin(), stress.end(), row.begin() + 9)));
        CHECK((row[18] == 0.05 * t && row[19] == 3e8 * (0.05 * t)));
        CHECK(std::equal(row.begin(), row.begin() + 20, row.begin() + 20));
    }
    const auto constants = exact.constants({});
    REQUIRE(constants.size() == 5);
    CHECK(std::get<double>(constants[2].value) == Approx(solid.stress(0)[0]).epsilon(4 * eps));
    CHECK(std::get<double>(constants[4].value) == solid.stress(0)[8]);
    CHECK_THROWS_AS(oracle.bind(resolve(oracle.parameters, {{"share", 1.01}}, "", "x")), InputError);
    CHECK_THROWS_AS(oracle.bind(resolve(oracle.parameters, {{"plastic_rate", -1.0}}, "", "x")), InputError);
    CHECK((!exact.times.contains(1e16) && exact.times.contains(1e14)));
}

// Between two random times: yield, mean stress, resting e3, and the plastic strain (strain less the elastic one) does
// no more work than Y0 per equivalent plastic strain, with equality while the axes rest.
TEST_CASE("j2_rotating_stress: random solids stay at yield and dissipate", "[property]") {
    Random random(19);
    Tally tally;
    const Oracle oracle = j2_rotating_stress();
    for (int round = 0; round < fuzz_rounds(4000); ++round) {
        const double K = random.log_uniform(1e-3, 1e12), G = K * random.log_uniform(1e-3, 1e2);
        const double Y0 = G * random.log_uniform(1e-6, 1), pressure = Y0 * random.uniform(-3, 3);
        const double spin = random.log_uniform(1e-6, 1e6) * (random.coin() ? 1 : -1);
        const double plastic_rate = random.coin() ? 0 : std::abs(spin) * random.log_uniform(1e-6, 1e2);
        const Exact exact = oracle.bind(resolve(oracle.parameters,
                                                {{"K", K},
                                                 {"G", G},
                                                 {"Y0", Y0},
                                                 {"spin", spin},
                                                 {"plastic_rate", plastic_rate},
                                                 {"share", random.uniform(-1, 1)},
                                                 {"pressure", pressure}},
                                                "", "x"));
        const double t = random.log_uniform(1e-3, 1e3) / std::abs(spin);
        std::array<double, 20> row{}, later{};
        exact.sample(std::array{0.0, 0.0, 0.0}, t, row);
        const double dt = 1e-3 * t;
        exact.sample(std::array{0.0, 0.0, 0.0}, t + dt, later);
        Tensor strain{}, stress{}, next{};
        std::copy_n(row.begin(), 9, strain.begin());
        std::copy_n(row.begin() + 9, 9, stress.begin());
        std::copy_n(later.begin() + 9, 9, next.begin());
        const double slack = 64 * eps * (Y0 + std::abs(pressure)) * (1 + std::abs(spin) * t);
        const double strain_slack =
            64 * eps * (Y0 / G + std::abs(pressure) / K + plastic_rate * t) * (1 + std::abs(spin) * t);
        // |plastic strain| sqrt(2/3) is at most the accumulated one.
        const Tensor plastic = combined(1, deviator(strain), -1 / (2 * G), deviator(stress));
        const double norm = std::sqrt(2.0 / 3 * inner(plastic, plastic));
        const bool good = std::abs(von_mises(stress) - Y0) <= slack && std::abs(von_mises(next) - Y0) <= slack &&
                          std::abs(trace(stress) / 3 + pressure) <= slack && stress[8] == next[8] &&
                          std::abs(trace(strain) * K + pressure) <= 3 * K * strain_slack &&
                          norm <= row[18] + strain_slack &&
                          norm >= row[18] * std::abs(std::sin(spin * t) / (spin * t)) * 0.999 - strain_slack;
        if (!good) FAIL("round " << round << ", spin t = " << spin * t << ", norm " << norm << ", p " << row[18]);
        ++tally.checked;
    }
    CHECK(tally.mostly_checked());
}

TEST_CASE("j2_rotating_stress: the gate rings for seeded faults", "[alarm]") {
    for (const auto& good : {cases()[0], cases()[1]}) {
        CHECK(ringing(good).empty());
        const auto& solid = good.solid;
        const auto with_strain = [&](std::function<Tensor(double)> strain) {
            Spinning claimed = good;
            claimed.strain = std::move(strain);
            return claimed;
        };
        const auto with_stress = [&](std::function<Tensor(double)> stress) {
            Spinning claimed = good;
            claimed.stress = std::move(stress);
            return claimed;
        };
        auto faulty = solid;
        faulty.plastic_rate *= 1 + 1e-5;
        CHECK(ringing(with_strain(spinning(faulty).strain)) == "flow rule; ");
        faulty = solid;
        faulty.spin *= 1 + 1e-6;
        CHECK_THAT(ringing(with_strain(spinning(faulty).strain)), ContainsSubstring("flow rule"));
        CHECK_THAT(ringing(with_stress(spinning(faulty).stress)), ContainsSubstring("turning"));
        faulty = solid;
        faulty.G *= 1 + 1e-6;
        CHECK_THAT(ringing(with_strain(spinning(faulty).strain)), ContainsSubstring("turning"));
        CHECK_THAT(ringing(with_stress([good](double t) { return combined(1 + 1e-6, good.stress(t), 0, {}); })),
                   ContainsSubstring("turning"));
        // Axes that spin the other way; stress at rest; plastic strain along the first axes only; engineering shear.
        CHECK_THAT(ringing(with_stress([good](double t) { return good.stress(-t); })), ContainsSubstring("turning"));
        CHECK_THAT(ringing(with_stress([good](double) { return good.stress(0); })), ContainsSubstring("flow rule"));
        CHECK_THAT(ringing(with_strain([good](double t) {
                       const auto& s = good.solid;
                       const Tensor elastic = combined(1 / (2 * s.G), deviator(good.stress(t)), 0, {});
                       return combined(1, elastic, 1.5 * s.plastic_rate * t / s.Y0, deviator(good.stress(0)));
                   })),
                   ContainsSubstring("flow rule"));
        CHECK_THAT(ringing(with_strain([good](double t) {
                       Tensor strain = good.strain(t);
                       strain[1] *= 2;
                       strain[3] *= 2;
                       return strain;
                   })),
                   ContainsSubstring("flow rule"));
        CHECK_THAT(ringing(with_stress([](double) { return Tensor{std::nan("")}; })),
                   ContainsSubstring("flow rule") && ContainsSubstring("turning"));
    }
}

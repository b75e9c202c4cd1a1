// Waves of no width: jump conditions, entropy, and star states against exact solvers.
#include "solvers/rrm/jumps.hpp"

#include "tests/oracles/fuzz.hpp"
#include "tests/solvers/rrm/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::rrm;
using namespace ordo::solvers::rrm::test;
using oracles::gate::fuzz_rounds;
using oracles::gate::Random;

namespace {

template <class M>
State state(const M& medium, const Contents& q) {
    return {q, medium.flow(q)};
}

/// Largest defect of [flux] = speed [contents], relative to the fluxes' size in the frame of the state ahead.
double defect(const State& a, const State& b, double speed) {
    const Contents left = flux(a.q, a.f) - speed * a.q;
    const Contents right = flux(b.q, b.f) - speed * b.q;
    const Contents off = left - right;
    const double m = a.f.rho * (a.f.a + std::abs(speed) + std::abs(a.f.v)) + b.f.rho * std::abs(b.f.v);
    const double p = m * (a.f.a + b.f.a + std::abs(speed) + std::abs(a.f.v)) + std::abs(a.f.p) + std::abs(b.f.p);
    const double e = std::abs(speed) * (std::abs(a.q.energy) + std::abs(b.q.energy)) + p * (std::abs(b.f.v) + a.f.a);
    return std::max({std::abs(off.mass) / m, std::abs(off.momentum) / p, std::abs(off.energy) / e});
}

template <class M>
void balanced(const M& medium, const Contents& q) {
    for (const Toward toward : {Toward::left, Toward::right}) {
        for (const double ratio : {0.5, 0.9, 1 - 1e-6, 1 - 1e-12, 1.0, 1 + 1e-10, 1.1, 1.4}) {
            const State ahead = state(medium, q);
            const Jump jump = through_jump(medium, ahead, ratio * q.mass, toward);
            CAPTURE(ratio, int(toward));
            CHECK(jump.behind.f.rho == Approx(ratio * q.mass));
            CHECK(defect(ahead, jump.behind, jump.speed) < 1e-14);
            CHECK(static_cast<int>(toward) * (jump.speed - ahead.f.v) > 0);
        }
    }
}

}  // namespace

TEST_CASE("rrm jumps: each jump balances mass, momentum and energy", "[unit]") {
    balanced(IdealGas{}, IdealGas{}.contents(0.7, -3, 1.2));
    const ElasticMedium<HookeEnergy> hooke{.E = 2, .rho0 = 1.5, .c_v = 0.7};
    balanced(hooke, hooke.contents(1.1, 0.4, 0.5));
    const ElasticMedium<RubberEnergy> rubber{.E = 2, .rho0 = 1.5, .c_v = 0.7, .k = 1};
    balanced(rubber, rubber.contents(1.1, 0.4, 0.5));
    const ElasticMedium<LogarithmicEnergy> logarithmic{.k = 2};
    balanced(logarithmic, logarithmic.contents(0.8, 0.4, 0.5));
}

TEST_CASE("rrm jumps: a shock of an ideal gas has the densities of Rankine and Hugoniot", "[unit]") {
    const IdealGas gas;
    const State ahead = state(gas, gas.contents(1, 0, 1));
    for (const double z : {1.5, 10.0, 1e4}) {  // p2 / p1
        const double ratio = (6 * z + 1) / (z + 6);
        const Jump jump = through_jump(gas, ahead, ratio, Toward::right);
        CHECK(jump.behind.f.p == Approx(z).epsilon(1e-11));
        CHECK(jump.speed == Approx(std::sqrt(1.4) * std::sqrt((6 * z + 1) / 7)).epsilon(1e-11));
    }
}

TEST_CASE("rrm jumps: entropy along a fan of n jumps is lost as 1 / n^2", "[unit]") {
    const IdealGas gas;
    const State ahead = state(gas, gas.contents(1, 0, 1));
    const auto entropy = [&](int jumps) {
        const Flow f = through_wave(gas, ahead, {-0.8, jumps}, Toward::left).behind.f;
        return std::log(f.p) - 1.4 * std::log(f.rho);
    };
    CHECK(entropy(10) / entropy(20) == Approx(4).epsilon(0.02));
    CHECK(std::abs(entropy(1000)) < 1e-5);
    std::vector<Jump> row;
    through_wave(gas, ahead, {-0.8, 10}, Toward::left, &row);
    REQUIRE(row.size() == 10);
    for (std::size_t i = 0; i + 1 < row.size(); ++i) CHECK(row[i].speed < row[i + 1].speed);
}

TEST_CASE("rrm jumps: two gases that meet have the exact solver's star state", "[property]") {
    Random random(11);
    int found = 0, missed = 0;
    for (int i = 0; i < fuzz_rounds(2000); ++i) {
        const IdealGas gas{random.uniform(1.1, 2)};
        const auto side = [&] {
            oracles::Gas g{
                .rho = random.log_uniform(1e-3, 1e3), .p = random.log_uniform(1e-3, 1e3), .gamma = gas.gamma};
            g.v = random.uniform(-3, 1) * std::sqrt(gas.gamma * g.p / g.rho);
            return g;
        };
        oracles::Gas l = side(), r = side();
        l.v = -l.v;
        const oracles::RiemannGas exact(l, r);
        if (!(exact.star().p > 1e-3 * std::min(l.p, r.p))) continue;
        const State left = state(gas, gas.contents(l.rho, l.v, l.p)), right = state(gas, gas.contents(r.rho, r.v, r.p));
        auto meeting = met(gas, left, right);
        if (!meeting) {
            ++missed;
            continue;
        }
        ++found;
        const bool fan = meeting->left.y < 0 || meeting->right.y < 0;
        meeting->left.jumps = meeting->right.jumps = 400;
        meeting = met(gas, left, right, *meeting);
        REQUIRE(meeting);
        const Flow a = through_wave(gas, left, meeting->left, Toward::left).behind.f;
        const Flow b = through_wave(gas, right, meeting->right, Toward::right).behind.f;
        CAPTURE(l.rho, l.v, l.p, r.rho, r.v, r.p, gas.gamma, fan);
        // Shocks are exact; 400 jumps over a decade of density lose 1e-5 of the entropy.
        CHECK(a.p == Approx(exact.star().p).epsilon(fan ? 1e-3 : 1e-9));
        CHECK(std::abs(a.v - b.v) < 1e-9 * (left.f.a + right.f.a + std::abs(l.v - r.v)));
        CHECK(std::abs(a.p - b.p) < 1e-9 * (a.rho * a.a * a.a + b.rho * b.a * b.a));
    }
    CAPTURE(found, missed);
    CHECK(missed <= 0.001 * found);
}

TEST_CASE("rrm jumps: a free end takes the pressure away", "[unit]") {
    const ElasticMedium<RubberEnergy> rubber{.E = 2, .k = 1};
    for (const double lambda : {0.6, 1.0, 1.7}) {
        const State inner = state(rubber, rubber.contents(lambda, 0.3, 0.4));
        const auto wave = released(rubber, inner, Toward::left, {first_strength(rubber, inner.f, -inner.f.p), 8});
        REQUIRE(wave);
        CHECK(std::abs(through_wave(rubber, inner, *wave, Toward::left).behind.f.p) < 1e-14);
    }
}

TEST_CASE("rrm jumps: gases that part into a vacuum do not meet", "[unit]") {
    const IdealGas gas;
    CHECK_FALSE(met(gas, state(gas, gas.contents(1, -8, 1)), state(gas, gas.contents(1, 8, 1))));
}

#include "oracles/lines/gas_piston.hpp"

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/fuzz.hpp"
#include "tests/oracles/lines/line_gate.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::line;

namespace {

struct Piston {
    double rho, v, p, gamma, V, x0;
    double a() const { return std::sqrt(gamma * p / rho); }
    double M() const { return std::abs(V - v) / a(); }
    double reach() const { return std::abs(v) + std::abs(V) + 3 * a(); }
};

/// Pushed, hard and gently; a stream against a wall at rest; drawn, slowly and fast; a wall that moves with the gas.
const std::vector<Piston> pistons{{1, 0, 1, 1.4, 0.5, 0},          {1.3, -0.7, 2.1, 1.67, 0, 0.4},
                                  {0.02, 3, 40, 1.2, 700, -2},     {1.3, 0.2, 2.1, 1.67, 0.2001, 0.4},
                                  {1.3, -0.7, 2.1, 1.67, -1.5, 0}, {5, 0.3, 0.8, 3, -0.2, 1},
                                  {1.3, 0.6, 2.1, 1.4, 0.6, 0.4}};

Given given(const Piston& piston) {
    const auto& [rho, v, p, gamma, V, x0] = piston;
    return {{"rho", rho}, {"v", v}, {"p", p}, {"gamma", gamma}, {"V", V}, {"x0", x0}};
}

Claim claim_of(const Piston& piston) {
    const Exact exact = bound(gas_piston(), given(piston));
    // Cells beside the wall, over the wave and inside a fan.
    std::vector<double> places{piston.V};
    for (const double edge : wave_edges(exact, 1)) {
        const double ahead = edge - piston.x0;
        places.push_back(0.3 * places.back() + 0.7 * ahead);
    }
    places.push_back(piston.v + piston.reach());
    const auto gas_law = [gamma = piston.gamma](const Exact& exact, double x, double t) {
        const double p = at(exact, "pressure", x, t);
        return (gamma - 1) * at(exact, "density", x, t) * at(exact, "energy", x, t) / p - 1;
    };
    return {exact, piston.x0, piston.rho, piston.reach(), places, gas_law};
}

/// The wall's condition and the data: the gas goes with the wall, and ahead of the wave nothing has changed.
Defect ends(const Claim& claim, const Piston& piston) {
    Defect defect;
    for (const double t : times) {
        const double wall = piston.x0 + piston.V * t;
        const double ahead = piston.x0 + (piston.v + piston.reach()) * t;
        defect.add(at(claim.exact, "velocity", wall, t) - piston.V, 1e-13 * claim.speed, claim.speed);
        defect.add(at(claim.exact, "velocity", ahead, t) - piston.v, 0, claim.speed);
        defect.add(at(claim.exact, "density", ahead, t) - piston.rho, 0, piston.rho);
        defect.add(at(claim.exact, "pressure", ahead, t) - piston.p, 0, piston.p);
    }
    return defect;
}

std::string ringing_of(const Claim& claim, const Piston& piston) {
    return ringing(claim) + (ends(claim, piston).holds() ? "" : "ends; ");
}

double closed_form(const Piston& piston) {
    const auto& [rho, v, p, g, V, x0] = piston;
    const double M = piston.M();
    if (V < v) return p * std::pow(1 - (g - 1) / 2 * M, 2 * g / (g - 1));
    const double q = (g + 1) / 4 * M;
    return p * (1 + g * M * (q + std::sqrt(1 + q * q)));
}

}  // namespace

TEST_CASE("gas piston: balances, jumps, means, gas law and ends hold", "[gate]") {
    for (const auto& piston : pistons) {
        INFO("V = " << piston.V << ", v = " << piston.v);
        CHECK(ringing_of(claim_of(piston), piston) == "");
    }
}

TEST_CASE("gas piston: the pressure on the wall has a closed form", "[gate]") {
    for (const auto& piston : pistons) {
        INFO("V = " << piston.V << ", v = " << piston.v);
        const Exact exact = bound(gas_piston(), given(piston));
        CHECK(constant(exact, "p_wall") == Approx(closed_form(piston)).epsilon(1e-12));
        CHECK(constant(exact, "x_wall", 2) == piston.x0 + 2 * piston.V);
    }
}

TEST_CASE("gas piston: random gases and walls agree with the closed form", "[property]") {
    Random random(71);
    for (int i = 0; i < fuzz_rounds(2000); ++i) {
        Piston piston{random.log_uniform(1e-3, 1e3), 0, random.log_uniform(1e-3, 1e3), random.uniform(1.05, 4), 0, 0};
        piston.v = random.uniform(-3, 3) * piston.a();
        piston.V = piston.v + piston.a() * random.uniform(-0.9 * 2 / (piston.gamma - 1), 8);
        const Exact exact = bound(gas_piston(), given(piston));
        // d ln p / dM is 2 gamma / ((gamma - 1) c) in a fan that cools to c a >= 0.1 a
        REQUIRE(constant(exact, "p_wall") == Approx(closed_form(piston)).epsilon(1e-11));
    }
}

TEST_CASE("gas piston: behind a wall that outruns the gas is nothing", "[gate]") {
    const Piston fast{1.3, -0.7, 2.1, 1.67, -9, 0.4};
    const Exact exact = bound(gas_piston(), given(fast));
    CHECK(constant(exact, "p_wall") == 0);
    const double edge = fast.v - 2 / (fast.gamma - 1) * fast.a();  // the gas expands at most so fast
    REQUIRE(edge > fast.V);
    CHECK(at(exact, "density", fast.x0 + edge - 1e-6, 1) == 0);
    CHECK(at(exact, "density", fast.x0 + edge + 1e-3, 1) > 0);
    CHECK(std::isnan(at(exact, "velocity", fast.x0 + fast.V, 1)));
    CHECK(wave_edges(exact, 1).front() == Approx(fast.x0 + edge).epsilon(1e-12));
    CHECK((exact.jumps(1).empty() && exact.waves(1).size() == 1));
    Claim claim = claim_of(fast);
    claim.places = {fast.V, 0.5 * (fast.V + edge), edge + 0.3, 0, fast.reach()};
    CHECK(balance(claim).holds());
}

TEST_CASE("gas piston: what is behind the wall is refused, round-off is not", "[unit]") {
    const Exact exact = bound(gas_piston(), {{"V", 0.5}, {"x0", 1.0}});
    CHECK_NOTHROW(row_at(exact, 1.5 * (1 - 1e-15), 1));
    CHECK_THROWS_WITH(row_at(exact, 1.49, 1),
                      ContainsSubstring("behind the wall") && ContainsSubstring("nearest: x = 1.5"));
    CHECK_THROWS_AS(mean_over(exact, 1.2, 1.7, 1), InputError);
    CHECK_THAT(refusal(gas_piston(), {{"rho", 0.0}}), ContainsSubstring("rho"));
    CHECK((exact.jumps(0).empty() && exact.jumps(1).size() == 1));
    const Exact still = bound(gas_piston(), {{"V", 0.0}});
    CHECK((still.waves(1).empty() && still.jumps(1).empty()));
}

TEST_CASE("alarm: gas piston: the gates ring for seeded faults", "[alarm]") {
    for (const auto& piston : pistons) {
        if (piston.V == piston.v || std::abs(piston.V - piston.v) < 1e-3) continue;  // nothing happens there
        INFO("V = " << piston.V << ", v = " << piston.v);
        const Claim good = claim_of(piston);
        const auto flow_of = [&](Piston other) {
            Claim claim = good;
            claim.exact = claim_of(other).exact;
            return claim;
        };
        // Cells begin at the given wall, which a slower one allows.
        Claim shifted = good;
        shifted.exact =
            claim_of({piston.rho, piston.v, piston.p, piston.gamma, piston.V - 1e-6 * good.speed, piston.x0}).exact;
        CHECK_THAT(ringing_of(shifted, piston), ContainsSubstring("ends"));
        Piston other = piston;
        other.gamma *= 1 + 1e-6;
        CHECK_THAT(ringing_of(flow_of(other), piston), ContainsSubstring("law"));
        other = piston;
        other.p *= 1 + 1e-6;
        CHECK_THAT(ringing_of(flow_of(other), piston), ContainsSubstring("ends"));

        const auto pressed = changed(good, [&](auto row, double, double) {
            if (row[2] != piston.p) row[2] *= 1 + 1e-6;
        });
        CHECK_THAT(ringing_of(pressed, piston), ContainsSubstring("balance") && ContainsSubstring("law"));
        const auto dense = changed(good, [&](auto row, double, double) {
            if (row[0] != piston.rho) row[0] *= 1 + 1e-6;
        });
        CHECK_THAT(ringing_of(dense, piston), ContainsSubstring("balance"));
        Claim late = good;  // its wall is where the cells begin, or behind that
        late.exact.averages = [given = good.exact.averages, V = piston.V](auto edges, double t, auto rows) {
            given(edges, t * (V > 0 ? 1 - 1e-6 : 1 + 1e-6), rows);
        };
        CHECK_THAT(ringing_of(late, piston), ContainsSubstring("balance") && ContainsSubstring("means"));
    }
}

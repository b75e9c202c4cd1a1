#include "oracles/blasts/noh.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/blasts/noh_gate.hpp"
#include "tests/oracles/fuzz.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::implosion;

namespace {

const std::vector geometries{Noh::Geometry::planar, Noh::Geometry::cylindrical, Noh::Geometry::spherical};
const std::vector<std::string> words{"planar", "cylindrical", "spherical"};

/// Default and off-default gases, soft and stiff, in SI too.
std::vector<Noh> gases() {
    std::vector<Noh> list;
    for (const auto geometry : geometries) {
        list.push_back({.geometry = geometry});
        list.push_back({.geometry = geometry, .gamma = 1.4, .rho0 = 1.29, .v0 = 340});
        list.push_back({.geometry = geometry, .gamma = 1.07, .rho0 = 3e-5, .v0 = 0.02});
        list.push_back({.geometry = geometry, .gamma = 3, .rho0 = 19300, .v0 = 4e5});
        list.push_back({.geometry = geometry, .gamma = 9.3, .rho0 = 0.7, .v0 = 2});
    }
    return list;
}

std::string name_of(const Noh& gas) {
    return words[static_cast<std::size_t>(gas.geometry) - 1] + ", gamma = " + std::to_string(gas.gamma);
}

}  // namespace

TEST_CASE("noh: data, equation of state, jumps, Euler equations, balances, means and similarity hold", "[gate]") {
    for (const auto& gas : gases()) {
        for (const auto& [name, gate] : gates) {
            const Defect defect = gate(flow_of(gas));
            INFO(name << ": " << name_of(gas) << ": defect " << defect.found << ", allowed " << defect.allowed);
            CHECK(defect.holds());
        }
    }
}

TEST_CASE("noh: values of the sphere and the cylinder", "[published]") {
    const auto sphere = Noh{}.at(0.1, 0.6);
    CHECK(sphere.density == Approx(64).epsilon(8 * eps));
    CHECK(sphere.pressure == Approx(64.0 / 3).epsilon(8 * eps));
    CHECK(sphere.energy == 0.5);
    CHECK(Noh{}.shock_speed() * 0.6 == Approx(0.2).epsilon(2 * eps));
    const Noh cylinder{.geometry = Noh::Geometry::cylindrical};
    CHECK(cylinder.at(0.1, 0.6).density == Approx(16).epsilon(8 * eps));
    CHECK(cylinder.at(0.1, 0.6).pressure == Approx(16.0 / 3).epsilon(8 * eps));
    CHECK(cylinder.shock_speed() == Approx(1.0 / 3).epsilon(2 * eps));
}

// Two streams of gas at the pressure p0 = 1e-6 collide: p*, rho*, shock speed, 17 digits. Toward p0 = 0 the
// strong-shock relations differ by the relative delta = 2 / ((gamma - 1) M^2) of the density, M^2 = rho0 (v0 + S)^2 /
// (gamma p0); mass, rho (v0 + S) = rho* S, and momentum, p* - p0 = rho0 (v0 + S) v0, hand it on. What is left is
// O(delta^2) < 1e-10.
TEST_CASE("noh: the limit of two colliding streams of little pressure", "[published]") {
    struct Collision {
        double gamma, p, rho, speed;
    };
    for (const auto& [gamma, p, rho, speed] :
         {Collision{5.0 / 3, 1.3333355833321615, 3.9999887500527341, 0.33333458333216},
          Collision{1.4, 1.2000021666655324, 5.9999708335318273, 0.20000116666553}}) {
        const Noh gas{.geometry = Noh::Geometry::planar, .gamma = gamma};
        const auto [u, rho_cold, p_cold, e] = gas.post_shock();
        const double S = gas.shock_speed();
        const double delta = 2 * gamma * 1e-6 / ((gamma - 1) * (1 + S) * (1 + S));
        CHECK(rho == Approx(rho_cold * (1 - delta)).epsilon(1e-10));
        const double S_warm = S * (1 + delta * rho_cold / (rho_cold - 1));
        CHECK(speed == Approx(S_warm).epsilon(1e-10));
        CHECK(p - 1e-6 == Approx(p_cold + (S_warm - S)).epsilon(1e-10));
        CHECK(p == Approx(p_cold).epsilon(3e-6));
    }
}

TEST_CASE("noh: the shock itself belongs to the state ahead, and t = 0 to the data", "[unit]") {
    for (const auto& gas : gases()) {
        const double s = gas.shock_speed() * 2.5;
        CHECK(gas.at(s, 2.5).velocity == -gas.v0);
        CHECK(gas.at(std::nextafter(s, 0), 2.5).velocity == 0);
        CHECK(gas.at(0, 2.5).velocity == 0);
        CHECK((gas.at(0, 0).density == gas.rho0 && gas.at(0, 0).velocity == -gas.v0));
        CHECK(
            (gas.mean(0, 1, 0).density == Approx(gas.rho0).epsilon(4 * eps) && gas.mean(0, 1, 0).velocity == -gas.v0));
    }
}

TEST_CASE("noh: the declaration binds the same numbers to the same bits", "[unit]") {
    const Oracle oracle = noh();
    for (const auto& gas : gases()) {
        const Given given{{"geometry", words[static_cast<std::size_t>(gas.geometry) - 1]},
                          {"gamma", gas.gamma},
                          {"rho0", gas.rho0},
                          {"v0", gas.v0}};
        const Exact exact = oracle.bind(resolve(oracle.parameters, given, "", "noh"));
        CHECK((exact.dim == 1 && exact.coordinates == Coordinates::spatial && exact.lower == std::vector{0.0}));
        CHECK((exact.jumps(0).empty() && exact.jumps(0.3) == std::vector{gas.shock_speed() * 0.3}));
        at_samples(flow_of(gas), [&](double r, double t) {
            std::vector<double> row(4), cell(4);
            exact.sample({&r, 1}, t, row);
            exact.averages(std::array{r, 1.5 * r}, t, cell);
            const auto [u, rho, p, e] = gas.at(r, t);
            const auto [u_mean, rho_mean, p_mean, e_mean] = gas.mean(r, 1.5 * r, t);
            REQUIRE(row == std::vector{u, rho, p, e});
            REQUIRE(cell == std::vector{u_mean, rho_mean, p_mean, e_mean});
        });
        const auto constants = exact.constants(0.3);
        REQUIRE(constants.size() == 5);
        CHECK((constants.back().name == "r_shock" && exact.constants({}).size() == 4));
        CHECK(std::get<double>(constants.back().value) == exact.jumps(0.3).front());
    }
}

TEST_CASE("noh: refuses a gas that its post-shock state leaves the doubles for", "[unit]") {
    const Oracle oracle = noh();
    const auto refusal = [&](const Given& given) -> std::string {
        try {
            oracle.bind(resolve(oracle.parameters, given, "", "noh"));
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    CHECK_THAT(refusal({{"gamma", 1.0}}), ContainsSubstring("gamma") && ContainsSubstring("> 1"));
    CHECK_THAT(refusal({{"v0", 0.0}}), ContainsSubstring("v0"));
    CHECK_THAT(refusal({{"rho0", 1e100}, {"v0", 1e100}, {"gamma", 1 + 1e-15}}),
               ContainsSubstring("move gamma away from 1"));
    CHECK(refusal({{"gamma", 1 + 1e-10}}).empty());
}

// Ahead of the shock, mass between r and the place it came from, r + v0 t, is what was there at t = 0; behind it the
// three jump conditions hold across the front. No refusal in this range.
TEST_CASE("noh: random gases obey their identities", "[property]") {
    Random random(7);
    const Oracle oracle = noh();
    Tally tally;
    for (int round = 0; round < fuzz_rounds(3000); ++round) {
        const int j = random.whole(1, 3);
        const Given given{{"geometry", words[static_cast<std::size_t>(j) - 1]},
                          {"gamma", 1 + random.log_uniform(1e-6, 1e3)},
                          {"rho0", random.log_uniform(1e-12, 1e12)},
                          {"v0", random.log_uniform(1e-9, 1e9)}};
        const Exact exact = oracle.bind(resolve(oracle.parameters, given, "", "noh"));
        const double v0 = std::get<double>(given.at("v0"));
        const double rho0 = std::get<double>(given.at("rho0"));
        const double t = random.log_uniform(1e-12, 1e12);
        const double front = exact.jumps(t).front();
        const double r = random.coin() ? front : front * random.log_uniform(1, 1e6);
        const std::array x{std::nextafter(front, 0), front, r, random.uniform(0, front)};
        std::array<double, 16> row{};
        exact.sample(x, t, row);
        const auto state = [&](int k) {
            return Noh::State{row[4 * k], row[4 * k + 1], row[4 * k + 2], row[4 * k + 3]};
        };
        const auto [behind, ahead] = std::pair{state(0), state(1)};
        bool good = state(3).density == behind.density && state(3).pressure == behind.pressure;
        for (std::size_t k = 0; k < 3; ++k) {
            const double S = front / t;
            const double sum = S * (densities(behind)[k] - densities(ahead)[k]) - fluxes(behind)[k] + fluxes(ahead)[k];
            const double scale = std::abs(fluxes(ahead)[k]) + S * densities(behind)[0] * std::pow(v0, double(k));
            good = good && std::abs(sum) <= 32 * eps * scale;
        }
        // Lagrange: a thin shell at r + v0 t at t = 0 is as thick at r at time t.
        const double mass = state(2).density * std::pow(r / (r + v0 * t), j - 1);
        good = good && std::abs(mass - rho0) <= 16 * eps * rho0 && state(2).velocity == -v0;
        std::array<double, 4> mean{};
        exact.averages(std::array{0.0, 2 * front}, t, mean);
        const double swept = rho0 * std::pow(1 + v0 * t / (2 * front), j);
        good = good && std::abs(mean[1] - swept) <= 64 * eps * swept;
        if (!good) FAIL("round " << round << ", j = " << j << ", r = " << r << ", t = " << t << ", v0 = " << v0);
        ++tally.checked;
    }
    CHECK(tally.mostly_checked());
}

TEST_CASE("noh: the gate rings for seeded faults", "[alarm]") {
    for (const auto& gas : gases()) {
        const Flow good = flow_of(gas);
        INFO(name_of(gas));
        CHECK(ringing(good).empty());

        const auto with = [&](auto change) {
            Flow flow = good;
            flow.at = [good, change](double r, double t) {
                auto s = good.at(r, t);
                change(s, r, t);
                return s;
            };
            return flow;
        };
        const auto pressed = [](const Noh::State& s) { return s.pressure > 0; };

        // The pressure 4^j / 3 of gamma = 5/3 for every gas.
        const Flow four_thirds = with([&](Noh::State& s, double, double) {
            if (pressed(s)) s.pressure = gas.rho0 * gas.v0 * gas.v0 * std::pow(4, good.j()) / 3;
        });
        if (gas.gamma != 5.0 / 3)
            CHECK_THAT(ringing(four_thirds),
                       ContainsSubstring("equation of state") && ContainsSubstring("jump conditions"));

        // Density one part in a million off behind the shock; ahead of it.
        const Flow dense = with([&](Noh::State& s, double, double) { s.density *= pressed(s) ? 1 + 1e-6 : 1; });
        CHECK_THAT(ringing(dense), ContainsSubstring("jump conditions") && ContainsSubstring("balances"));
        const Flow thin =
            with([&](Noh::State& s, double, double t) { s.density *= pressed(s) || t == 0 ? 1 : 1 + 1e-6; });
        CHECK_THAT(ringing(thin), ContainsSubstring("jump conditions") && ContainsSubstring("balances"));

        // Energy and pressure both too high; only the balance of energy and the jump can see it.
        const Flow hot = with([&](Noh::State& s, double, double) {
            s.energy *= 1 + 1e-6;
            s.pressure *= 1 + 1e-6;
        });
        CHECK_THAT(ringing(hot), ContainsSubstring("jump conditions") && ContainsSubstring("balances"));

        // The front one part in a million too fast; gas that flows outwards; a density that forgets the convergence.
        Flow fast = good;
        fast.front = [good](double t) { return (1 + 1e-6) * good.front(t); };
        fast.at = [good](double r, double t) { return good.at(r / (1 + 1e-6), t); };
        CHECK_THAT(ringing(fast), ContainsSubstring("jump conditions") && ContainsSubstring("balances"));
        CHECK_THAT(ringing(with([](Noh::State& s, double, double) { s.velocity = -s.velocity; })),
                   ContainsSubstring("data") && ContainsSubstring("jump conditions"));
        if (good.j() > 1) {
            const Flow straight =
                with([&](Noh::State& s, double, double) { s.density = pressed(s) ? s.density : gas.rho0; });
            CHECK_THAT(ringing(straight), ContainsSubstring("Euler equations") && ContainsSubstring("jump conditions"));
        }

        // Means without the weight r^(j-1); NaN.
        Flow unweighted = good;
        unweighted.mean = Flow{flow_of({Noh::Geometry::planar, gas.gamma, gas.rho0, gas.v0})}.mean;
        if (good.j() > 1) CHECK(ringing(unweighted) == "means; ");
        CHECK_THAT(ringing(with([](Noh::State& s, double, double) { s.density = std::nan(""); })),
                   ContainsSubstring("Euler equations") && ContainsSubstring("balances"));
    }
}

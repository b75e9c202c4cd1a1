// Seeded faults, each of which a gate must find.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/oracles/riemann/riemann_gas_data.hpp"
#include "tests/oracles/riemann/riemann_gas_gate.hpp"

using namespace ordo::oracles;
using namespace ordo::oracles::gate;

namespace {

/// Names of the gates that a claim does not pass, joined.
std::string ringing(const GasClaim& claim) {
    std::string names;
    for (const auto& [name, defect] : gas_gates) {
        if (!defect(claim).holds()) names += name + "; ";
    }
    return names;
}

struct Fault {
    std::string name;
    std::string rings;  ///< the gate that must find it
    std::function<void(GasClaim&)> seed;
};

/// Changes what is sampled.
std::function<void(GasClaim&)> sampled(std::function<GasFields(const GasClaim& good, double xi)> at) {
    return [at](GasClaim& claim) { claim.at = [good = claim, at](double xi) { return at(good, xi); }; };
}

bool between_fan_and_shock(const GasClaim& claim, double xi) {
    return claim.waves.front().tail <= xi && xi < claim.waves.back().head;
}

/// Faults for a fan on the left and a shock on the right.
const std::vector<Fault> faults{
    {"p* off by 1e-6", "jump conditions", sampled([](const GasClaim& good, double xi) {
         auto f = good.at(xi);
         if (between_fan_and_shock(good, xi)) f.pressure *= 1 + 1e-6;
         return f;
     })},
    {"v* off by 1e-6", "jump conditions", sampled([](const GasClaim& good, double xi) {
         auto f = good.at(xi);
         if (between_fan_and_shock(good, xi)) f.velocity *= 1 + 1e-6;
         return f;
     })},
    {"density behind the shock off by 1e-6", "jump conditions", sampled([](const GasClaim& good, double xi) {
         auto f = good.at(xi);
         if (xi >= good.waves[1].head && xi < good.waves.back().head) f.density *= 1 + 1e-6;
         return f;
     })},
    {"all waves 1e-6 too fast", "equations in fans",
     sampled([](const GasClaim& good, double xi) { return good.at(xi / (1 + 1e-6)); })},
    {"fan with linear density", "equations in fans", sampled([](const GasClaim& good, double xi) {
         auto f = good.at(xi);
         const auto& fan = good.waves.front();
         if (xi <= fan.head || xi >= fan.tail) return f;
         const double share = (xi - fan.head) / (fan.tail - fan.head);
         f.density = good.left.rho + share * (good.at(fan.tail).density - good.left.rho);
         return f;
     })},
    {"expansion shock for the fan", "jump conditions",
     [](GasClaim& claim) {
         const double middle = 0.5 * (claim.waves[0].head + claim.waves[0].tail);
         claim.at = [good = claim, middle](double xi) {
             if (!(good.waves[0].head <= xi && xi < good.waves[0].tail)) return good.at(xi);
             return good.at(xi < middle ? 2 * good.waves[0].head : good.waves[0].tail);
         };
         claim.waves[0].head = claim.waves[0].tail = middle;
     }},
    {"energy of the ideal gas with gamma 1e-6 off", "gas law", sampled([](const GasClaim& good, double xi) {
         auto f = good.at(xi);
         f.energy *= 1 + 1e-6;
         return f;
     })},
    {"momentum of the other sign", "gas law", sampled([](const GasClaim& good, double xi) {
         auto f = good.at(xi);
         f.momentum = -f.momentum;
         return f;
     })},
    {"data swapped", "admissible", [](GasClaim& claim) { std::swap(claim.left, claim.right); }},
    {"waves out of order", "admissible", [](GasClaim& claim) { std::swap(claim.waves[0], claim.waves[1]); }},
    {"mean by the midpoint", "cell balance",
     [](GasClaim& claim) { claim.mean = [good = claim](double a, double b) { return good.at(0.5 * (a + b)); }; }},
    {"mean of the pressure 1e-6 off", "mean of samples",
     [](GasClaim& claim) {
         claim.mean = [good = claim](double a, double b) {
             auto mean = good.mean(a, b);
             mean.pressure *= 1 + 1e-6;
             return mean;
         };
     }},
    {"NaN", "jump conditions", sampled([](const GasClaim& good, double xi) {
         auto f = good.at(xi);
         if (between_fan_and_shock(good, xi)) f.pressure = std::nan("");
         return f;
     })}};

}  // namespace

TEST_CASE("riemann_gas: the gates ring for seeded faults", "[alarm]") {
    const std::vector<GasPair> pairs{{{1, 0, 1}, {0.125, 0, 0.1}},
                                     {{1, 0, 1000}, {1, 0, 0.01}},
                                     {{1, 0.3, 2, 2}, {0.125, 0, 0.1, 1.4}},
                                     {{1000, 0, 1e9, 4.4, 6e8}, {50, 0, 1e5, 1.4, 0}}};
    for (const auto& pair : pairs) {
        CHECK(ringing(claim_of(pair)).empty());
        for (const auto& fault : faults) {
            GasClaim claim = claim_of(pair);
            fault.seed(claim);
            INFO(text_of(pair) << ": " << fault.name);
            CHECK_THAT(ringing(claim), ContainsSubstring(fault.rings));
        }
    }
}

TEST_CASE("riemann_gas: the solution of slightly other data is not one of the data given", "[alarm]") {
    const GasPair pair{{1, 0.1, 1, 1.6}, {0.125, -0.2, 0.1, 1.4}};
    for (double Gas::*number : {&Gas::rho, &Gas::v, &Gas::p, &Gas::gamma}) {
        Gas other = pair.second;
        other.*number *= 1 + 1e-6;
        GasClaim claim = claim_of({pair.first, other});
        claim.right = pair.second;
        CHECK_FALSE(ringing(claim).empty());
    }
}

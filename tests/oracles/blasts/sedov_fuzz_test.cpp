#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "oracles/blasts/sedov.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/blasts/sedov_gate.hpp"
#include "tests/oracles/fuzz.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::point_blast;

namespace {

/// Anything from gamma - 1 = 1e-4 to 1e3 and omega from -6 to a little above j; every other one on a special exponent
/// or the singular one, or beside it by 1e-16 to 1e-2.
Given random_blast(Random& random) {
    const int j = random.whole(1, 3);
    const double gamma = random.whole(1, 30) == 1 ? random.uniform(0, 1) : 1 + random.log_uniform(1e-4, 1e3);
    double omega = random.coin() ? random.uniform(-2, j) : random.uniform(-6, j + 0.5);
    if (random.coin()) {
        const double specials[] = {j * (2 - gamma), (2 * (gamma - 1) + j) / gamma,
                                   (3 * j - 2 + gamma * (2 - j)) / (gamma + 1), j / gamma};
        omega = specials[random.whole(0, 3)];
        if (random.coin()) omega += (random.coin() ? 1 : -1) * random.log_uniform(1e-16, 1e-2);
        if (std::abs(omega) > 50) omega = 0;
    }
    return {{"geometry", std::string(j == 1   ? "planar"
                                     : j == 2 ? "cylindrical"
                                              : "spherical")},
            {"gamma", gamma},
            {"omega", omega},
            {"energy", random.log_uniform(1e-6, 1e6)},
            {"rho0", random.log_uniform(1e-3, 1e3)}};
}

struct Numbers {
    double j, gamma, omega;
};

/// The steepest power of lambda in any field.
double steepest(const Numbers& n) {
    return 1 + (n.j + std::abs(n.omega) * n.gamma) / (n.gamma - 1) + n.j + std::abs(n.omega);
}

/// At one place inside: the equation of state, the energy that flows as it stays, the entropy along particles (see
/// identities in the gate), and d(ln m)/d(ln lambda) = (j - omega) (gamma + 1)/(gamma - 1) g lambda^j / m: together all
/// that the similarity solution is. Returns the largest defect over what round-off allows.
double worst_identity(const Exact& exact, const Numbers& n, double t, double lambda, double r_shock, double r_core) {
    const double D = 2 / (n.j + 2 - n.omega) * r_shock / t;
    std::array<double, 4> behind{}, here{};
    const double last = r_shock * (1 - eps / 2);
    exact.sample({&last, 1}, t, behind);
    const auto log_mass = [&](double log_lambda) {
        const double r = r_shock * std::exp(log_lambda);
        std::array<double, 4> s{};
        exact.sample({&r, 1}, t, s);
        const double slip = (std::exp(log_lambda) * D - s[0]) / (D - behind[0]);
        return std::log(s[1] / behind[1] * slip) + (n.j - 1) * log_lambda;
    };
    const double r = r_shock * lambda;
    exact.sample({&r, 1}, t, here);
    const auto& [u, rho, p, e] = here;
    const double slip = 1 - u / (lambda * D);  // what is left of 1 after a difference
    const double noise = 0.5 * eps * steepest(n) * (1 + std::abs(std::log(lambda))) * r / (r - r_core) /
                         std::min(1.0, slip) * (1 + n.gamma) / (n.gamma - 1) * n.gamma;
    const double inside = rho * u * u / 2 + p / (n.gamma - 1);
    const double m = log_mass(std::log(lambda));
    const double entropy = std::log(p / behind[2]) - n.gamma * std::log(rho / behind[1]);
    double worst = std::abs(p / ((n.gamma - 1) * rho * e) - 1) / noise;
    const auto also = [&](double defect, double allowed) {
        if (!(defect / allowed <= worst)) worst = defect / allowed;  // keeps NaN
    };
    also(std::abs((lambda * D - u) * inside / (p * u) - 1), noise);
    also(std::abs(entropy + (n.j - n.gamma * n.omega) / (n.j - n.omega) * m),
         noise * (n.gamma + std::abs(n.j - n.gamma * n.omega) / (n.j - n.omega)));
    const double step = 0.02 * std::min({1.0, -std::log(lambda), std::log(r / r_core), 1 / steepest(n)});
    const auto slope = first_derivative(log_mass, std::log(lambda), step, noise);
    const double wanted =
        (n.j - n.omega) * (n.gamma + 1) / (n.gamma - 1) * rho / behind[1] * std::exp(n.j * std::log(lambda) - m);
    also(std::abs(slope.value - wanted), slope.error + noise * wanted);
    return worst;
}

double constant(const Exact& exact, double t, const std::string& name) {
    for (const auto& [known, value] : exact.constants(t)) {
        if (known == name) return std::get<double>(value);
    }
    return 0;
}

/// Density and pressure are always numbers inside the shock, and finite; in a core they are 0 and the others empty.
void check_row(std::span<const double> row, bool in_core) {
    REQUIRE((std::isfinite(row[1]) && std::isfinite(row[2]) && row[1] >= 0 && row[2] >= 0));
    REQUIRE(std::isnan(row[0]) == in_core);
    if (in_core) REQUIRE((row[1] == 0 && row[2] == 0 && std::isnan(row[3])));
}

}  // namespace

TEST_CASE("sedov: random gamma, omega, geometry: identities hold, refusals are theory's", "[property]") {
    const Oracle oracle = sedov();
    Random random(20260711);
    Tally tally;
    for (int round = 0; round < fuzz_rounds(600); ++round) {
        const Given given = random_blast(random);
        const double gamma = std::get<double>(given.at("gamma")), omega = std::get<double>(given.at("omega"));
        const auto& word = std::get<std::string>(given.at("geometry"));
        const double j = word == "planar" ? 1 : word == "cylindrical" ? 2 : 3;
        INFO(word << ", gamma = " << gamma << ", omega = " << omega << ", round " << round);
        std::optional<Exact> exact;
        try {
            exact = oracle.bind(resolve(oracle.parameters, given, "", "oracle sedov"));
        } catch (const InputError&) {
            REQUIRE((gamma <= 1 || omega >= j));
            ++tally.refused;
            continue;
        }
        REQUIRE((gamma > 1 && omega < j));
        const double t = random.log_uniform(1e-3, 1e3);
        const double r_shock = constant(*exact, t, "r_shock"), r_core = constant(*exact, t, "r_vacuum");
        const std::vector<double> x{0.4 * r_core, r_core + random.uniform(1e-3, 1) * (r_shock - r_core),
                                    r_core + random.log_uniform(1e-9, 1) * (r_shock - r_core), r_shock};
        std::vector<double> rows(16);
        exact->sample(x, t, rows);
        check_row({rows.data() + 4, 4}, false);
        check_row({rows.data() + 8, 4}, false);
        if (r_core > 0) check_row({rows.data(), 4}, true);
        REQUIRE((rows[12] == 0 && rows[14] == 0 && rows[15] == 0 && rows[13] > 0));
        const Numbers numbers{j, gamma, omega};
        const double outer = std::exp(-300 / steepest(numbers));  // inside, the density may be below 1e-130
        const double inner = std::max(r_core / r_shock, outer);
        const double lambda = inner + random.uniform(0.02, 0.98) * (1 - inner);
        const double off = worst_identity(*exact, numbers, t, lambda, r_shock, r_core);
        CHECK(off <= 1);
        ++tally.checked;
    }
    CHECK(tally.mostly_checked());
}

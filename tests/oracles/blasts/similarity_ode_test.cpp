#include "oracles/blasts/similarity_ode.hpp"

#include <cmath>
#include <vector>

#include "oracles/blasts/energy_integrals.hpp"
#include "tests/catch.hpp"

using namespace ordo::oracles;

namespace {

struct Case {
    int j;
    double gamma, omega;
};

/// Among them both special exponents, gamma = 2, the singular cases and what lies 1e-12 beside them.
std::vector<Case> cases() {
    return {{1, 1.4, 0},
            {2, 1.4, 0},
            {3, 1.4, 0},
            {1, 2, 0},
            {2, 2, 0},
            {3, 2, 0},
            {1, 1.4, 0.6},
            {2, 1.4, 1.2 + 1e-12},
            {3, 1.4, 1.8},
            {3, 1.4, 19.0 / 7},
            {3, 1.4, 2.4},
            {2, 1.4, 1.7},
            {3, 1.4, 7.0 / 3},
            {3, 7, 0},
            {3, 1.1, 0},
            {2, 1.4, 5.0 / 3},
            {3, 5.0 / 3, 1 - 1e-12},
            {2, 3, -1.5},
            {3, 1.02, 1.5},
            {3, 40, 0.5}};
}

/// How an error made at the shock has grown at lambda. Inwards, w leaves its value at the centre as lambda^-(j + 2) at
/// most (the mass within lambda, over its volume and the work done on it), and near the singular case a little faster.
double growth(int j, double lambda) { return std::pow(lambda, -(j + 2)); }

}  // namespace

TEST_CASE("sedov: the similarity equations, integrated inwards, give the same profiles", "[gate]") {
    for (const auto& c : cases()) {
        const Similarity profiles(c.j, c.gamma, c.omega);
        SimilarityOde equations(c.j, c.gamma, c.omega);
        for (const double lambda : {0.99, 0.9, 0.75, 0.5, 0.3, 0.2, 0.1, 0.05}) {
            if (lambda < 1.03 * profiles.core() || growth(c.j, lambda) > 1e4) break;
            const auto found = profiles.profile(lambda);
            const auto wanted = equations.inwards_to(lambda);
            INFO("j = " << c.j << ", gamma = " << c.gamma << ", omega = " << c.omega << ", lambda = " << lambda);
            // Steps keep 1e-13; the density's power multiplies what comes of it.
            const double allowed = 1e-13 * growth(c.j, lambda) * (1 + c.j / (c.gamma - 1)) + 1e-13;
            CHECK(allowed < 1e-7);
            CHECK(std::abs(found.velocity / wanted.velocity - 1) <= allowed);
            CHECK(std::abs(found.density / wanted.density - 1) <= allowed);
            CHECK(std::abs(found.pressure / wanted.pressure - 1) <= allowed);
        }
    }
}

TEST_CASE("sedov: the similarity equations give the same J1, J2 and alpha", "[gate]") {
    for (const auto& c : cases()) {
        const Similarity profiles(c.j, c.gamma, c.omega);
        if (profiles.kind() == BlastKind::vacuum) continue;  // the integrals end at the core, where w = 1
        SimilarityOde equations(c.j, c.gamma, c.omega);
        const auto found = energy_integrals(profiles, c.j, c.gamma, c.omega);
        const bool singular = profiles.kind() == BlastKind::singular;
        const double lambda = 0.03;
        const auto shell = equations.inwards_to(lambda);
        INFO("j = " << c.j << ", gamma = " << c.gamma << ", omega = " << c.omega);
        // The pressure further in is uniform up to the work of f ~ lambda, or falls as lambda^j; J1 ends with the mass.
        const double n = c.j + 2 - c.omega;
        const double volume = std::pow(lambda, c.j) / (singular ? 2 * c.j : c.j);
        const double J2 = shell.J2 + 8 / ((c.gamma + 1) * n * n) * shell.pressure * volume;
        const double rest = std::pow(lambda, c.j + 2 - std::max(c.omega, 0.0));
        CHECK(std::abs(found.J2 / J2 - 1) <= 1e-11 + rest);
        CHECK(std::abs(found.J1 / shell.J1 - 1) <= 1e-11 + rest);
        CHECK(found.J1 >= shell.J1 * (1 - 1e-12));
    }
}

TEST_CASE("sedov: the second route says where it cannot go", "[unit]") {
    SimilarityOde vacuum(3, 1.4, 2.4);
    CHECK(std::isnan(vacuum.inwards_to(0.2).density));
    SimilarityOde standard(3, 1.4, 0);
    CHECK(std::isnan(standard.inwards_to(std::nan("")).density));
    CHECK(standard.inwards_to(1).density == 1);
}

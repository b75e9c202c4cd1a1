#include "solvers/mpm/particles.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo::solvers;
using namespace ordo::solvers::mpm;

namespace {

/// Integral of s^degree over (0, 1) by the seeds, minus the exact 1 / (degree + 1).
double integration_error(const std::vector<Seed>& seeds, int degree) {
    double sum = 0;
    for (const auto& [xi, share] : seeds) sum += share * std::pow(xi, degree);
    return sum - 1.0 / (degree + 1);
}

}  // namespace

TEST_CASE("placement: particles sit where the formulas say, inside the cell, with shares that sum to 1", "[unit]") {
    for (int ppc = 1; ppc <= 16; ++ppc) {
        for (const auto placement : {Placement::cell_centred, Placement::even_interior, Placement::gauss}) {
            const auto line = seeds(placement, ppc);
            REQUIRE(line.size() == static_cast<std::size_t>(ppc));
            double sum = 0;
            for (int k = 1; k <= ppc; ++k) {
                const auto& [xi, share] = line[static_cast<std::size_t>(k - 1)];
                sum += share;
                CHECK((xi > 0 && xi < 1 && share > 0));
                // Symmetric about the middle of the cell, to the round-off of an eigenvalue.
                CHECK(xi + line[static_cast<std::size_t>(ppc - k)].xi == Approx(1).epsilon(1e-14));
                if (placement == Placement::cell_centred)
                    CHECK(xi == Approx((2.0 * k - 1) / (2.0 * ppc)).epsilon(1e-15));
                if (placement == Placement::even_interior) CHECK(xi == Approx(k / (ppc + 1.0)).epsilon(1e-15));
                if (placement != Placement::gauss) CHECK(share == 1.0 / ppc);
            }
            CHECK(sum == Approx(1).epsilon(1e-14));
        }
    }
}

TEST_CASE("placement: n Gauss points integrate degree 2n - 1 exactly, and degree 2n not", "[unit]") {
    for (int n = 1; n <= 16; ++n) {
        const auto line = seeds(Placement::gauss, n);
        for (int degree = 0; degree < 2 * n; ++degree) CHECK(std::abs(integration_error(line, degree)) < 1e-14);
        if (n <= 6)
            CHECK(std::abs(integration_error(line, 2 * n)) > 1e-8);  // (n!)^4 / ((2n + 1) ((2n)!)^2) is 2e-8 at n = 6
    }
    // Not so the other placements: the middle rule errs in degree 2.
    CHECK(std::abs(integration_error(seeds(Placement::cell_centred, 2), 2)) > 1e-3);
}

TEMPLATE_TEST_CASE_SIG("particles: a body is filled with its own mass, at rest stress-free, with the scene's velocity",
                       "[unit]", ((int dim), dim), 1, 2, 3) {
    const Vec<dim> edges = Vec<dim>(Vec<3>(1.0, 0.5, 0.75).head<dim>());
    const auto field = [](const Vec<dim>& X, double t) { return Vec<dim>(2 * X.array() + t + 1); };
    const auto scene = test::box<dim>(edges, Face::free, test::pointwise<dim>(field));
    const auto placement = GENERATE(Placement::cell_centred, Placement::even_interior, Placement::gauss);
    const Resolution resolution{.cells = 4, .ppc = 3, .h = 0.25, .dt = 1};
    const auto p = seeded<dim>(scene, {.placement = placement}, resolution, true);
    REQUIRE(p.size() == static_cast<std::size_t>(std::lround(edges.prod() / std::pow(0.25, dim) * std::pow(3, dim))));
    double mass = 0;
    double volume = 0;
    Vec<dim> moment = Vec<dim>::Zero();
    for (std::size_t i = 0; i < p.size(); ++i) {
        mass += p.m[i];
        volume += p.volume[i];
        moment += p.m[i] * p.x[i];
        CHECK(((p.X[i] - scene.lower).array() > 0).all());
        CHECK(((scene.upper - p.X[i]).array() > 0).all());
        CHECK(p.v[i] == field(p.X[i], 0));
        CHECK((p.x[i] == p.X[i] && p.sigma[i].isZero(0) && p.F[i].isIdentity(0)));
    }
    CHECK(volume == Approx(edges.prod()).epsilon(1e-13));
    CHECK(mass == Approx(scene.rho * edges.prod()).epsilon(1e-13));
    // Symmetric placement: the centre of mass is the middle of the box.
    CHECK((moment / mass - 0.5 * (scene.lower + scene.upper)).norm() < 1e-13);
    CHECK(seeded<dim>(scene, {.placement = placement}, resolution, false).F.empty());
}

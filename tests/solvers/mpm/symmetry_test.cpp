// What must not matter: left or right, the units, a common velocity.
#include <algorithm>
#include <string>

#include "oracles/bars/bar_vibration.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/mpm/variants.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

/// Data of a bar, and how long to run it in how many steps.
struct Bar {
    double L = 1, E = 1, rho = 1, v0 = 0.2, t = 1.5;
    double dt() const { return t / 256; }
    Law law() const { return NominalLaw{{.lambda = 0, .mu = E / 2}}; }
};

Snapshot run(const SolidScene<1>& scene, const Bar& bar, const Variant& variant) {
    const auto simulation =
        started(scene, variant.with({{"margin", 1.0}}), {{"cells", 16.0}, {"ppc", 2.0}, {"dt", bar.dt()}});
    simulation->advance_to(bar.t, never);
    return simulation->snapshot();
}

/// Displacement over length, particle by particle.
std::vector<double> dimensionless(const Bar& bar, const Variant& variant) {
    auto u = run(fixed_free_bar(bar.L, bar.rho, bar.v0, bar.law()), bar, variant).field("displacement").values;
    for (double& value : u) value /= bar.L;
    return u;
}

const std::vector<Variant> every_variant = joined({updated_variants, total_variants, line_variants});

/// The same problem in other units of length, stress and density; times follow.
Bar rescaled(double length, double stress, double density) {
    const Bar bar;
    const double speed = std::sqrt(stress / density);
    return {bar.L * length, bar.E * stress, bar.rho * density, bar.v0 * speed, bar.t * length / speed};
}

}  // namespace

TEST_CASE("symmetry: the mirrored bar has the same displacement error", "[property]") {
    const auto variant = GENERATE(from_range(every_variant));
    INFO(variant.name());
    const Bar bar;
    const oracles::BarVibration exact{.L = bar.L, .E = bar.E, .rho = bar.rho, .v0 = bar.v0, .mode = 1};
    const auto scene = fixed_free_bar(bar.L, bar.rho, bar.v0, bar.law());
    auto mirrored = scene;
    mirrored.faces = {{{Face::free, Face::fixed}}};
    mirrored.velocity = [&scene](std::span<const Vec<1>> X, double t, std::span<Vec<1>> out) {
        std::vector<Vec<1>> image(X.begin(), X.end());
        for (auto& x : image) x[0] = scene.upper[0] - x[0];
        scene.velocity(image, t, out);
        for (auto& v : out) v = -v;
    };
    const Snapshot shot = run(scene, bar, variant);
    const Snapshot image = run(mirrored, bar, variant);
    double squares = 0;
    double image_squares = 0;
    for (std::size_t i = 0; i < shot.points(); ++i) {
        const double e = shot.field("displacement").values[i] - exact.displacement(shot.X[i], bar.t);
        const double f = image.field("displacement").values[i] + exact.displacement(bar.L - image.X[i], bar.t);
        squares += e * e;
        image_squares += f * f;
    }
    CHECK(squares > 1e-12);  // there is an error to compare
    // The margin is for variants so accurate that positions near 1, rounded 256 times, show in their error.
    CHECK(std::sqrt(image_squares) == Approx(std::sqrt(squares)).epsilon(1e-12).margin(1e-14));
}

TEST_CASE("symmetry: other units give the same dimensionless displacement", "[property]") {
    const auto variant = GENERATE(from_range(every_variant));
    INFO(variant.name());
    const auto reference = dimensionless({}, variant);
    CHECK(*std::max_element(reference.begin(), reference.end()) > 0.05);
    // Powers of 2 change exponents only (the wave speed must be one too): the same bits.
    CHECK(dimensionless(rescaled(1 << 5, 1 << 16, 1 << 6), variant) == reference);
    CHECK(dimensionless(rescaled(1.0 / 8, 1.0 / 1024, 1 << 10), variant) == reference);
    // Powers of 10 round once more at every operation; 256 steps let an ulp grow a little.
    for (const auto& other : {rescaled(1e3, 1e9, 1e-3), rescaled(1e-6, 1e2, 1e4)}) {
        const auto found = dimensionless(other, variant);
        for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == Approx(reference[i]).epsilon(1e-11));
    }
}

TEST_CASE("symmetry: a free bar that flies along vibrates as at rest", "[property]") {
    // The grid stands still, so that only flights of whole cells a step show the particles the same grid again; any
    // other speed changes the error (not the order) of the method.
    const auto stress_update = GENERATE(from_range(stress_updates));
    const auto whole_cells = GENERATE(1, -1);
    INFO(stress_update << ", " << whole_cells << " cell a step");
    const double h = 1.0 / 16;
    const double dt = 1.0 / 64;
    const int steps = 100;
    const auto displacements = [&](double V) {
        SolidScene<1> scene = fixed_free_bar(1, 1, 0.2, NominalLaw{{.lambda = 0, .mu = 0.5}});
        scene.faces = all_faces<1>(Face::free);
        scene.velocity = pointwise<1>(
            [V](const Vec<1>& X, double) { return Vec<1>(V + 0.2 * std::cos(4 * std::atan(1.0) * X[0])); });
        const auto bar = started(scene, {{"stress_update", stress_update}, {"margin", 8.0}},
                                 {{"cells", 16.0}, {"ppc", 2.0}, {"dt", dt}});
        bar->advance_to(steps * dt, never);
        return bar->snapshot().field("displacement").values;
    };
    const double V = whole_cells * h / dt;
    const auto resting = displacements(0);
    const auto flying = displacements(V);
    CHECK(*std::max_element(resting.begin(), resting.end()) > 0.01);
    for (std::size_t i = 0; i < flying.size(); ++i) {
        // Positions near 7 and speeds near 4 round `steps` times.
        CHECK(flying[i] - V * steps * dt == Approx(resting[i]).margin(1e-12));
    }
}

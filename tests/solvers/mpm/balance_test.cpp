// Mass and momentum to round-off, with the impulses of walls, loads and damping, for every variant that claims them.
#include <algorithm>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/variants.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

bool claims(const Given& options, const std::string& quantity) {
    const Solver& mpm = solver_named("mpm", "");
    const auto kept = mpm.claim(resolve(mpm.options, options, "", "mpm")).conserves;
    return std::find(kept.begin(), kept.end(), quantity) != kept.end();
}

/// A box that is held at one end and turns, stretches, falls and is slowed down.
template <int dim>
SolidScene<dim> busy_box() {
    auto scene = box<dim>(Vec<dim>(Vec<3>(1.0, 0.5, 0.5).head<dim>()), Face::free, [](auto X, double, auto out) {
        for (std::size_t i = 0; i < X.size(); ++i) {
            out[i] = Vec<dim>::Constant(0.05);
            out[i][0] = 0.12 * (X[i][0] - 0.4);
            if constexpr (dim > 1) out[i][1] = 0.1 * X[i][0] * X[i][0];
        }
    });
    scene.lower[0] = 0.4;
    scene.upper[0] = 1.4;
    scene.faces[0][0] = Face::fixed;
    if constexpr (dim > 1) scene.faces[1][1] = Face::roller;
    scene.body_force = pointwise<dim>(
        [](const Vec<dim>& X, double t) -> Vec<dim> { return 0.2 * X + Vec<dim>::Constant(0.1 * std::cos(t) - 0.1); });
    scene.damping = 0.3;
    return scene;
}

template <int dim>
void check_balance(const SolidScene<dim>& scene, const Variant& variant, double cells) {
    INFO(variant.name());
    const auto options = variant.with({{"margin", 0.5}});
    const auto body = started(scene, options, {{"cells", cells}, {"ppc", 2.0}, {"dt", 0.01}});
    REQUIRE(claims(options, "momentum"));
    body->advance_to(0.5, never);
    body->advance_to(0.803, never);
    // 81 steps of sums over some hundred particles, each rounded to an ulp.
    CHECK(figure(body->drift(), "momentum") < 1e-13);
    REQUIRE((claims(options, "mass") || variant.options.contains("reconstruction")));
    if (claims(options, "mass")) CHECK(figure(body->drift(), "mass") < 1e-14);
}

}  // namespace

TEST_CASE("balance: a bar with a wall, loads and damping", "[property]") {
    check_balance<1>(busy_box<1>(), GENERATE(from_range(joined({updated_variants, total_variants, line_variants}))), 8);
}

TEST_CASE("balance: a plate with a wall and a roller", "[property]") {
    check_balance<2>(busy_box<2>(), GENERATE(from_range(joined({updated_variants, total_variants}))), 4);
}

TEST_CASE("balance: traction on free faces counts to the last bit", "[property]") {
    auto scene = busy_box<2>();
    scene.traction =
        pointwise<2>([](const Vec<2>& X, double t) { return Vec<2>(0.05 * X[1] + 0.02 * t, 0.03 * X[0]); });
    check_balance<2>(scene, GENERATE(from_range(joined({updated_variants, total_variants}))), 4);
}

TEST_CASE("balance: held faces that move push the body by what they say", "[property]") {
    auto scene = busy_box<2>();
    scene.faces[0][1] = Face::fixed;
    scene.face_velocity =
        pointwise<2>([](const Vec<2>& X, double t) { return Vec<2>(0.12 * (X[0] - 0.4) * std::cos(t), 0.1 * t); });
    check_balance<2>(scene, GENERATE(from_range(total_variants)), 4);
}

TEST_CASE("balance: the drift rings for an impulse that is left out", "[alarm]") {
    // The scene's wall and loads do move the body: a sum that lacked them would not be round-off.
    const auto scene = busy_box<2>();
    Mpm<2> body(scene, {}, {.cells = 4, .ppc = 2, .h = 0.25, .dt = 0.01}, false);
    const Vec<2> start = momentum(body.particles());
    for (int k = 0; k < 10; ++k) body.step(0.01 * k, 0.01, 0.01);
    CHECK((momentum(body.particles()) - start).norm() > 1e-4);
    CHECK((momentum(body.particles()) - start - body.impulse()).norm() < 1e-15);
}

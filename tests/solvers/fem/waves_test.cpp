// Waves on the mesh: its dispersion, its limits of stability, and the step at which it has no error at all.
#include <numbers>

#include "oracles/bars/bar_traction.hpp"
#include "oracles/bars/oedometer.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/fem/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::fem;
using namespace ordo::solvers::fem::test;

namespace {

constexpr double L = 2;
constexpr double E = 9;
constexpr double rho = 4;
constexpr double c = 1.5;  // sqrt(E / rho)
constexpr int cells = 16;
constexpr double h = L / cells;

/// Angular frequency of mode n of the fixed-free bar, from three successive displacements u, u', u'' of its free end:
/// those of a leapfrog obey u + u'' = 2 cos(omega dt) u' and have sin(omega dt / 2) = omega_mesh dt / 2.
double measured_frequency(const std::string& mass, int n, double dt) {
    const double k = (n - 0.5) * std::numbers::pi / L;
    auto scene = fixed_free_bar(L, rho, linear_law(E));
    scene.deformed = deformed([k](double X, double) { return 0.02 * std::sin(k * X); });
    const auto bar = started(scene, {{"mass", mass}}, {{"cells", double(cells)}, {"dt", dt}});
    std::array<double, 3> u{};
    for (int step = 0; step < 3; ++step) {
        bar->advance_to((20 + step) * dt, never);
        u[static_cast<std::size_t>(step)] = bar->snapshot().field("displacement").values.back();
    }
    const double cosine = (u[0] + u[2]) / (2 * u[1]);
    return 2 / dt * std::sqrt((1 - cosine) / 2);
}

/// Largest speed of a free bar that is shaken in its shortest wave, over so many steps; infinite where it broke.
double largest_speed(const std::string& mass, double courant, int steps) {
    auto scene = free_bar(L, rho, linear_law(E));
    scene.velocity = field([](double X, double) { return std::lround((X + 0.3) / h) % 2 == 0 ? 1e-6 : -1e-6; });
    const auto bar = started(scene, {{"mass", mass}}, {{"cells", double(cells)}, {"courant", courant}});
    double most = 0;
    try {
        for (int k = 1; k <= steps; ++k) {
            bar->advance_to(k * courant * h / c, never);
            const Snapshot shot = bar->snapshot();
            most = std::max(most, Errors(shot, "velocity", nowhere).most);
        }
    } catch (const Diverged&) {
        return HUGE_VAL;
    }
    return most;
}

/// A column under gravity g and a load p0 on its top.
SolidScene<1> column(double g, double p0) {
    auto scene = fixed_free_bar(L, rho, linear_law(E));
    scene.body_force = field([g](double, double) { return -g; });
    scene.traction = field([p0](double, double) { return p0; });
    return scene;
}

/// Largest nodal displacement error of that column over its largest displacement, after 90 steps: 1.4 periods at C = 1;
/// infinite where it broke.
double column_error(const SolidScene<1>& scene, const Given& options, double courant) {
    const oracles::Oedometer truth{.H = L, .E = E, .rho = rho, .g = 0.2, .p0 = 0.3};
    const auto bar = started(scene, options, {{"cells", double(cells)}, {"courant", courant}});
    try {
        bar->advance_to(90 * courant * h / c, never);
    } catch (const Diverged&) {
        return HUGE_VAL;
    }
    const auto exact = [&](double X, double t) { return truth.displacement(X, t); };
    const Snapshot shot = bar->snapshot();
    return Errors(shot, "displacement", exact).most / Errors(shot, "displacement", nowhere).most;
}

}  // namespace

TEST_CASE("fem waves: each mode swings at the frequency that the mesh gives it", "[property]") {
    const auto mass = GENERATE(from_range(masses));
    const auto n = GENERATE(1, 2, 5, 8, 12, 16);
    INFO(mass << ", mode " << n);
    const double k = (n - 0.5) * std::numbers::pi / L;
    const double expected = frequency_on_mesh(mass, k, h, c);
    // F = 1 + du/dX, rounded at 1e-16 of 1, gives 1e-14 of the strain; some steps; 1 - cos(omega dt) from 1e-3 on.
    CHECK(measured_frequency(mass, n, 0.04) == Approx(expected).epsilon(1e-10));
    // The two masses lie on either side of the continuum, and are told apart by this.
    CHECK((mass == "lumped" ? expected < 0.9999 * c * k : expected > 1.0001 * c * k));
}

TEST_CASE("fem waves: the step is stable up to C = 1 with lumped and 1/sqrt 3 with consistent mass", "[property]") {
    const auto mass = GENERATE(from_range(masses));
    const double limit = mass == "lumped" ? 1 : 1 / std::sqrt(3.0);
    // That wave has omega dt/2 = asin(C/limit), and below the limit the velocity of whole steps is v0 cos(omega t);
    // above, it grows by exp(2 acosh(1.005)) = 1.22 a step.
    CHECK(largest_speed(mass, 0.995 * limit, 300) < 1e-6 * (1 + 1e-6));
    CHECK(largest_speed(mass, 1.005 * limit, 300) > 1);
}

TEST_CASE("fem waves: with lumped mass and C = 1 leapfrog is d'Alembert's solution at the nodes", "[property]") {
    // u(X, t + dt) + u(X, t - dt) = u(X + h, t) + u(X - h, t) holds for every sum of waves, and with g dt^2 for a fall;
    // kinks run along the mesh's diagonals. Round-off of marginally stable waves grows as steps squared.
    const auto body_force = GENERATE(from_range(body_forces));
    CHECK(column_error(column(0.2, 0.3), {{"body_force", body_force}}, 1) < 1e-12);
}

TEST_CASE("fem waves: a pull at the lower end is the mirror image of one at the upper end", "[property]") {
    const auto mass = GENERATE(from_range(masses));
    auto mirrored = fixed_free_bar(L, rho, linear_law(E));
    mirrored.faces = {{{Face::free, Face::fixed}}};
    mirrored.body_force = field([](double, double) { return 0.2; });
    mirrored.traction = field([](double, double) { return -0.3; });  // outward, towards -x
    const auto at_end = [&](const SolidScene<1>& scene) {
        const auto bar = started(scene, {{"mass", mass}}, {{"cells", double(cells)}, {"courant", 0.5}});
        bar->advance_to(3, never);
        return bar->snapshot().field("displacement").values;
    };
    const auto there = at_end(column(0.2, 0.3));
    const auto here = at_end(mirrored);
    for (std::size_t i = 0; i < there.size(); ++i)
        CHECK(here[i] == Approx(-there[there.size() - 1 - i]).margin(1e-14));  // of 0.2; 72 steps
}

TEST_CASE("fem waves: the d'Alembert check rings for other steps, masses, starts, laws and signs", "[alarm]") {
    const auto word = [](const std::string& name, const std::string& value) { return Given{{name, value}}; };
    CHECK(column_error(column(0.2, 0.3), {}, 0.9) > 1e-3);
    CHECK(column_error(column(0.2, 0.3), word("time", "symplectic_euler"), 1) > 1e-3);
    CHECK(column_error(column(0.2, 0.3), word("mass", "consistent"), 0.5) > 1e-3);
    CHECK(column_error(column(0.2, -0.3), {}, 1) > 1e-3);
    CHECK(column_error(column(-0.2, 0.3), {}, 1) > 1e-3);
    CHECK(column_error(column(0.2, 0.3001), {}, 1) > 1e-5);
    auto other_law = column(0.2, 0.3);
    other_law.law = LogarithmicLaw{{.lambda = 0, .mu = E / 2}};
    CHECK(column_error(other_law, {}, 1) > 1e-3);
}

TEST_CASE("fem waves: a mode is not taken for its neighbour, nor one mass for the other", "[alarm]") {
    const double found = measured_frequency("lumped", 2, 0.04);
    const auto k = [](int n) { return (n - 0.5) * std::numbers::pi / L; };
    CHECK_FALSE(found == Approx(frequency_on_mesh("consistent", k(2), h, c)).epsilon(1e-10));
    CHECK_FALSE(found == Approx(frequency_on_mesh("lumped", k(3), h, c)).epsilon(1e-10));
    CHECK_FALSE(found == Approx(c * k(2)).epsilon(1e-10));
}

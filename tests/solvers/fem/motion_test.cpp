// Motions that linear elements represent exactly stay exact: free fall, and uniform stretches under every law.
#include "tests/catch.hpp"
#include "tests/solvers/fem/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::fem;
using namespace ordo::solvers::fem::test;

namespace {

constexpr double E = 2;

/// A law with its nominal stress in a uniaxial stretch F from the undeformed state, written here a second time.
struct Stretched {
    std::string name;
    Law law;
    std::function<double(double F)> P;
};

/// Uniaxial strain e of a von Mises solid: elastic up to 2 G e = Y0, then p = (2 G e - Y0)/(3 G + H) of plastic strain.
double plastic_stress(double e) {
    const double lambda = 0.7, G = 0.4, Y0 = 0.05, H = 0.1;
    const double p = std::max(0.0, (2 * G * std::abs(e) - Y0) / (3 * G + H));
    return (lambda + 2 * G / 3) * e + std::copysign(2.0 / 3, e) * (2 * G * std::abs(e) - 3 * G * p);
}

const std::vector<Stretched> laws{
    {"E ln F", LogarithmicLaw{{0, E / 2}}, [](double F) { return E * std::log(F); }},
    {"E(1-1/F)", ReciprocalLaw{{0, E / 2}}, [](double F) { return E * (1 - 1 / F); }},
    {"E(F-1)", NominalLaw{{0, E / 2}}, [](double F) { return E * (F - 1); }},
    {"E(F-1/F)/2", NeoHookeanLaw{{0, E / 2}}, [](double F) { return E / 2 * (F - 1 / F); }},
    {"E ln F / F", HenckyLaw{{0, E / 2}}, [](double F) { return E * std::log(F) / F; }},
    {"J2", J2Law{{0.7, 0.4}, 0.05, 0.1}, [](double F) { return plastic_stress(std::log(F)); }},
};

void check_uniform(const Snapshot& shot, double strain, double stress) {
    // 50 steps; F is a difference of displacements near 1 over h = 1/5.
    CHECK(Errors(shot, "strain", [&](double, double) { return strain; }).most < 1e-13);
    CHECK(Errors(shot, "stress", [&](double, double) { return stress; }).most < 1e-12);
}

}  // namespace

TEST_CASE("fem motion: free fall is exact with leapfrog, half a step ahead with symplectic Euler", "[property]") {
    const auto mass = GENERATE(from_range(masses));
    const auto time = GENERATE(from_range(times));
    const auto body_force = GENERATE(from_range(body_forces));
    const auto sampled_at = GENERATE(from_range(samplings));
    const double dt = 0.05;
    auto scene = free_bar(0.75, 1.3, laws[0].law);
    scene.velocity = field([](double, double) { return 0.5; });
    scene.body_force = field([](double, double) { return -1.5; });
    const auto bar =
        started(scene, {{"mass", mass}, {"time", time}, {"body_force", body_force}, {"sampled_at", sampled_at}},
                {{"cells", 3.0}, {"dt", dt}});
    bar->advance_to(20 * dt, never);
    const double ahead = time == "leapfrog" ? 0 : dt;
    const auto flown = [&](double, double t) { return 0.5 * t - 0.75 * t * (t + ahead); };
    const Snapshot shot = bar->snapshot();
    CHECK(Errors(shot, "displacement", flown).most < 1e-14);  // 20 steps near 1
    CHECK(Errors(shot, "velocity", [](double, double t) { return 0.5 - 1.5 * t; }).most < 1e-14);
    CHECK(Errors(shot, "stress", nowhere).most < 1e-13);
}

TEST_CASE("fem motion: a flight in uneven legs keeps the leapfrog's time", "[property]") {
    // Legs of 7, 1 and 5 steps: each kick spans from the middle of the last step to that of this one.
    auto scene = free_bar(0.75, 1.3, laws[0].law);
    scene.velocity = field([](double, double) { return 0.5; });
    scene.body_force = field([](double, double) { return -1.5; });
    const auto bar = started(scene, {}, {{"cells", 3.0}, {"dt", 0.05}});
    for (const double t_end : {0.34, 0.35, 0.58}) {
        bar->advance_to(t_end, never);
        const Snapshot shot = bar->snapshot();
        CHECK(shot.t == t_end);
        CHECK(Errors(shot, "velocity", [](double, double t) { return 0.5 - 1.5 * t; }).most < 1e-14);
        CHECK(Errors(shot, "displacement", [](double, double t) { return 0.5 * t - 0.75 * t * t; }).most < 1e-14);
    }
    CHECK(figure(bar->work(), "steps") == 13);
    CHECK(figure(bar->work(), "element_steps") == 39);
}

TEST_CASE("fem motion: consistent mass and force give a linear field back, lumped ones any field", "[property]") {
    // int N_i b = sum_j M_ij b_j for a linear b, and m_i b_i for any: after one step at rest v = dt b(X_i).
    const auto mass = GENERATE(from_range(masses));
    const auto load = mass == "lumped" ? field([](double X, double) { return std::exp(3 * X); })
                                       : field([](double X, double) { return 2 - 3 * X; });
    auto scene = free_bar(1, 1.3, laws[0].law);
    scene.body_force = load;
    const auto bar = started(scene, {{"time", std::string("symplectic_euler")}, {"mass", mass}, {"body_force", mass}},
                             {{"cells", 5.0}, {"dt", 0.01}});
    bar->advance_to(0.01, never);
    CHECK(Errors(bar->snapshot(), "velocity", [&](double X, double) {
              Vec<1> b;
              load(std::array{Vec<1>(X)}, 0, std::span(&b, 1));
              return 0.01 * b[0];
          }).most < 1e-15);
}

TEST_CASE("fem motion: two Gauss points take the sum of a cubic body force exactly, nodes by the trapezoidal rule",
          "[property]") {
    const auto body_force = GENERATE(from_range(body_forces));
    const auto cubic = [](double X, double) { return 1 + X * X * X; };
    auto scene = free_bar(1, 1.3, laws[0].law);
    scene.body_force = field(cubic);
    const Options options{.lumped = false, .leapfrog = false, .body_force_lumped = body_force == "lumped"};
    Bar bar(scene, options, {.cells = 4, .h = 0.25, .dt = 0.01});
    bar.step({.t = 0, .dt = 0.01, .kick = 0.01, .velocity_time = 0.01});
    double sum = 1 + (std::pow(0.7, 4) - std::pow(0.3, 4)) / 4;
    if (body_force == "lumped") {
        sum = 0;
        for (int e = 0; e < 4; ++e) sum += 0.125 * (cubic(-0.3 + 0.25 * e, 0) + cubic(-0.05 + 0.25 * e, 0));
    }
    CHECK(bar.momentum() == Approx(0.01 * 1.3 * sum).epsilon(1e-14));
}

TEST_CASE("fem motion: a uniform stretch that its end's traction balances stays at rest", "[property]") {
    const auto& law = GENERATE(from_range(laws));
    const auto mass = GENERATE(from_range(masses));
    const auto sampled_at = GENERATE(from_range(samplings));
    const auto F = GENERATE(0.7, 1.01, 1.4);
    INFO(law.name << ", " << mass << ", F = " << F);
    auto scene = fixed_free_bar(1, 1.3, law.law);
    scene.deformed = deformed([F](double X, double) { return (F - 1) * X; });
    scene.traction = field([&](double, double) { return law.P(F); });
    const auto bar = started(scene, {{"mass", mass}, {"sampled_at", sampled_at}}, {{"cells", 5.0}, {"courant", 0.3}});
    bar->advance_to(1, never);
    check_uniform(bar->snapshot(), F - 1, law.P(F));
    CHECK(Errors(bar->snapshot(), "velocity", nowhere).most < 1e-13);
}

TEST_CASE("fem motion: a bar drawn at one end in a uniform stretch follows its law", "[property]") {
    const auto& law = GENERATE(from_range(laws));
    const auto mass = GENERATE(from_range(masses));
    const auto time = GENERATE(from_range(times));
    const auto rate = GENERATE(-0.4, 0.6);
    INFO(law.name << ", " << mass << ", " << time << ", rate = " << rate);
    auto scene = fixed_free_bar(1, 1.3, law.law);
    scene.faces = {{{Face::roller, Face::fixed}}};
    scene.velocity = field([=](double X, double) { return 0.2 + rate * X; });
    scene.face_velocity = scene.velocity;
    scene.damping = 0.7;  // which this body force makes good
    scene.body_force = field([=](double X, double) { return 0.7 * (0.2 + rate * X); });
    const auto bar = started(scene, {{"mass", mass}, {"time", time}}, {{"cells", 5.0}, {"courant", 0.3}});
    bar->advance_to(1, never);
    check_uniform(bar->snapshot(), rate, law.P(1 + rate));
    CHECK(Errors(bar->snapshot(), "displacement", [=](double X, double t) { return (0.2 + rate * X) * t; }).most <
          1e-14);
    CHECK(Errors(bar->snapshot(), "velocity", [=](double X, double) { return 0.2 + rate * X; }).most < 1e-13);
}

TEST_CASE("fem motion: a plastic bar remembers its way", "[property]") {
    // Strain to e1 and back to e2, elastically: unloading has the slope lambda + 2 G, and is not the stress of e2.
    HistoryMaterial<J2Law> material({{0.7, 0.4}, 0.05, 0.1}, 1);
    const auto parts = GENERATE(1, 10);
    const double e1 = 0.3;
    const double e2 = 0.28;
    std::vector<double> P(1);
    for (int k = 1; k <= parts; ++k) material.stress(std::vector{std::exp(e1 * k / parts)}, P, {0, 1});
    CHECK(P[0] == Approx(plastic_stress(e1)).epsilon(1e-13));
    for (int k = 1; k <= parts; ++k) material.stress(std::vector{std::exp(e1 + (e2 - e1) * k / parts)}, P, {0, 1});
    CHECK(P[0] == Approx(plastic_stress(e1) + (0.7 + 2 * 0.4) * (e2 - e1)).epsilon(1e-13));
}

TEST_CASE("fem motion: the patch rings for a traction off by a millionth and for another law", "[alarm]") {
    const auto largest_speed = [](const Law& law, double traction) {
        auto scene = fixed_free_bar(1, 1.3, law);
        scene.deformed = deformed([](double X, double) { return 0.4 * X; });
        scene.traction = field([=](double, double) { return traction; });
        const auto bar = started(scene, {}, {{"cells", 5.0}, {"courant", 0.3}});
        bar->advance_to(1, never);
        return Errors(bar->snapshot(), "velocity", nowhere).most;
    };
    CHECK(largest_speed(laws[2].law, E * 0.4 * (1 + 1e-6)) > 1e-7);
    CHECK(largest_speed(laws[0].law, E * 0.4) > 1e-2);
}

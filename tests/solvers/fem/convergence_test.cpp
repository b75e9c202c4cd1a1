// Orders of accuracy, measured, against those that the solver claims or that theory gives.
#include <numbers>

#include "oracles/bars/bar_traction.hpp"
#include "oracles/bars/bar_vibration.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/fem/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::fem;
using namespace ordo::solvers::fem::test;

namespace {

constexpr double quarter_wave = std::numbers::pi / 2;  // wave number of the first mode on a bar of length 1

double order_in_time(const Given& options) {
    const Solver fem = fem::solver();
    return fem.claim(resolve(fem.options, options, "", "fem")).order_in_time;
}

/// Against the oracle, at a step whose error is a thousandth of that of 32 elements: (dt / h)^2 for wave speed 1.
double space_error(const Given& options, double cells, const std::string& name) {
    const oracles::BarVibration truth{.L = 1, .E = 1, .rho = 1, .v0 = 0.1, .mode = 1};
    auto scene = fixed_free_bar(1, 1, linear_law(1));
    scene.velocity = field([&](double X, double) { return truth.velocity(X, 0); });
    const auto bar = started(scene, options, {{"cells", cells}, {"dt", 1e-3}});
    bar->advance_to(0.7, never);
    const auto exact = [&](double X, double t) {
        if (name == "displacement") return truth.displacement(X, t);
        return name == "velocity" ? truth.velocity(X, t) : truth.stress(X, t);
    };
    return Errors(bar->snapshot(), name, exact).rms;
}

/// On 8 elements against the exact motion of these: a mode sin(k X) of the continuum is one of the mesh, which swings
/// at its own frequency. It starts off balance, a(0) != 0.
double time_error(const Given& options, const std::string& mass, double dt, const std::string& name) {
    const double omega = frequency_on_mesh(mass, quarter_wave, 0.125, 1);
    auto scene = fixed_free_bar(1, 1, linear_law(1));
    scene.velocity = field([](double X, double) { return 0.1 * std::sin(quarter_wave * X); });
    scene.deformed = deformed([](double X, double) { return 0.2 * std::sin(quarter_wave * X); });
    const auto bar = started(scene, options, {{"cells", 8.0}, {"dt", dt}});
    bar->advance_to(0.64, never);
    return Errors(bar->snapshot(), name,
                  [&](double X, double t) {
                      const double c = std::cos(omega * t);
                      const double s = std::sin(omega * t);
                      const double part =
                          name == "displacement" ? 0.2 * c + 0.1 / omega * s : 0.1 * c - 0.2 * omega * s;
                      return part * std::sin(quarter_wave * X);
                  })
        .rms;
}

double traction_error(oracles::BarTraction::Profile profile, const std::string& mass, double cells) {
    const oracles::BarTraction truth{.L = 1, .E = 1, .rho = 1, .tau = 0.01, .omega = 4, .profile = profile};
    const bool step = profile == oracles::BarTraction::Profile::step;
    auto scene = fixed_free_bar(1, 1, linear_law(1));
    scene.traction = field([=](double X, double t) { return X > 0.5 ? 0.01 * (step ? 1 : std::sin(4 * t)) : 1e9; });
    const auto bar = started(scene, {{"mass", mass}}, {{"cells", cells}, {"courant", 0.25}});
    bar->advance_to(1.7, never);
    return Errors(bar->snapshot(), "displacement", [&](double X, double t) { return truth.displacement(X, t); }).rms;
}

}  // namespace

TEST_CASE("fem convergence: smooth waves are second order in space", "[convergence]") {
    struct Row {
        std::string field, sampled_at;
    };
    const auto row = GENERATE(values<Row>({{"displacement", "nodes"},
                                           {"displacement", "centres"},
                                           {"velocity", "nodes"},
                                           {"velocity", "centres"},
                                           {"stress", "centres"}}));
    const auto mass = GENERATE(from_range(masses));
    INFO(row.field << " at " << row.sampled_at << ", " << mass);
    std::vector<double> errors;
    for (const double cells : {4.0, 8.0, 16.0, 32.0})
        errors.push_back(space_error({{"mass", mass}, {"sampled_at", row.sampled_at}}, cells, row.field));
    CAPTURE(errors);
    CHECK(order_defect(2, errors) <= 0.1);
}

TEST_CASE("fem convergence: from a start off balance the order in time is the claimed one", "[convergence]") {
    const auto mass = GENERATE(from_range(masses));
    const auto time = GENERATE(from_range(times));
    const auto name = GENERATE(as<std::string>{}, "displacement", "velocity");
    INFO(name << ", " << mass << ", " << time);
    const Given options{{"mass", mass}, {"time", time}};
    CHECK(order_in_time(options) == (time == "leapfrog" ? 2 : 1));
    std::vector<double> errors;
    for (const double dt : {0.02, 0.01, 0.005, 0.0025}) errors.push_back(time_error(options, mass, dt, name));
    CAPTURE(errors);
    CHECK(order_defect(order_in_time(options), errors) <= 0.1);
}

TEST_CASE("fem convergence: a suddenly loaded bar loses order as its front has kinks", "[convergence]") {
    // Data with a jump in derivative q + 1 lie in H^s for s < q + 3/2, for which a scheme of order 2 has the order 2
    // s/3 in L2: 1 for the kink of a step load (q = 0), 5/3 for the sine's jump of u_XX (q = 1). The sine's smooth
    // part, of order 2, is still a few hundredths of the order at 128 elements.
    using Profile = oracles::BarTraction::Profile;
    const auto mass = GENERATE(from_range(masses));
    const auto profile = GENERATE(Profile::step, Profile::sine);
    std::vector<double> errors;
    for (const double cells : {128.0, 512.0, 2048.0}) errors.push_back(traction_error(profile, mass, cells));
    CAPTURE(mass, errors);
    CHECK(order_defect(profile == Profile::step ? 1 : 5.0 / 3, errors, 4) <= 0.1);
}

TEST_CASE("fem convergence: a held end follows its velocity, by the midpoint or at the end of steps", "[convergence]") {
    const auto time = GENERATE(from_range(times));
    auto scene = fixed_free_bar(1, 1, linear_law(1));
    scene.faces = {{{Face::roller, Face::fixed}}};
    scene.face_velocity = field([](double X, double t) { return (0.1 + 0.2 * X) * std::cos(t); });
    std::vector<double> errors;
    for (const double dt : {0.1, 0.05, 0.025, 0.0125}) {
        const auto bar = started(scene, {{"time", time}}, {{"cells", 1.0}, {"dt", dt}});
        bar->advance_to(2, never);
        const Snapshot shot = bar->snapshot();
        // At the time of the snapshot itself, to round-off.
        CHECK(Errors(shot, "velocity", [](double X, double t) { return (0.1 + 0.2 * X) * std::cos(t); }).most < 1e-15);
        errors.push_back(
            Errors(shot, "displacement", [](double X, double t) { return (0.1 + 0.2 * X) * std::sin(t); }).rms);
    }
    CAPTURE(errors);
    CHECK(order_defect(time == "leapfrog" ? 2 : 1, errors) <= 0.1);
}

TEST_CASE("fem convergence: damping is of the time scheme's order", "[convergence]") {
    // A free bar in flight: v' = -alpha v, so that u = v0 (1 - exp(-alpha t)) / alpha.
    const auto mass = GENERATE(from_range(masses));
    const auto time = GENERATE(from_range(times));
    auto scene = free_bar(1, 1.3, linear_law(1));
    scene.velocity = field([](double, double) { return 0.4; });
    scene.damping = 1.5;
    std::vector<double> errors;
    for (const double dt : {0.04, 0.02, 0.01, 0.005}) {
        const auto bar = started(scene, {{"mass", mass}, {"time", time}}, {{"cells", 4.0}, {"dt", dt}});
        bar->advance_to(0.8, never);
        errors.push_back(Errors(bar->snapshot(), "displacement", [](double, double t) {
                             return 0.4 * (1 - std::exp(-1.5 * t)) / 1.5;
                         }).rms);
    }
    CAPTURE(mass, time, errors);
    CHECK(order_defect(time == "leapfrog" ? 2 : 1, errors) <= 0.1);
}

TEST_CASE("fem convergence: the check rings for a wrong order, for a floor, for NaN and for the other mass's mesh",
          "[alarm]") {
    const auto errors = [](double order, double floor) {
        std::vector<double> list;
        for (const double h : {0.25, 0.125, 0.0625, 0.03125}) list.push_back(0.7 * std::pow(h, order) + floor);
        return list;
    };
    CHECK(order_defect(2, errors(2, 0)) <= 0.1);
    CHECK_FALSE(order_defect(2, errors(1.85, 0)) <= 0.1);
    CHECK_FALSE(order_defect(2, errors(2.15, 0)) <= 0.1);
    CHECK_FALSE(order_defect(2, errors(2, 1e-3)) <= 0.1);
    CHECK_FALSE(order_defect(2, std::vector{1.0, 0.25, std::nan(""), 1.0 / 64}) <= 0.1);
    std::vector<double> other;
    for (const double dt : {0.02, 0.01, 0.005, 0.0025})
        other.push_back(time_error({{"mass", std::string("lumped")}}, "consistent", dt, "displacement"));
    CHECK_FALSE(order_defect(2, other) <= 0.1);
}

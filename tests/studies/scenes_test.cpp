// Each one-dimensional benchmark asks for what its truth answers: same start, same ends, same balance of momentum.
#include <array>

#include "core/error.hpp"
#include "oracles/bars/oedometer.hpp"
#include "tests/catch.hpp"
#include "tests/studies/scene_identities.hpp"

using namespace ordo;
using namespace ordo::studies;
using namespace ordo::studies::tests;

namespace {

struct Case {
    std::string name;
    Given given;
};

const Given pulled{{"L", 2.0}, {"E", 300.0}, {"rho", 7.0}, {"tau", 5.0}, {"omega", 11.0}};
const Given column{{"H", 3.0}, {"E", 900.0}, {"rho", 4.0}, {"g", 5.0}, {"p0", -30.0}};
const Given swinging{{"L", 2.0}, {"E", 50.0}, {"nu", 0.3}, {"rho", 3.0}, {"A", 0.1}};
const Given standing{{"L", 2.0}, {"E", 50.0}, {"rho", 3.0}, {"A", 0.08}};
const Given plastic{{"E", 900.0}, {"nu", 0.2}, {"Y0", 3.0}, {"H", 40.0}, {"rate", 0.7}, {"L", 3.0}, {"rho", 2.0}};
const Given heavy{{"H", 3.0}, {"E", 900.0}, {"rho", 4.0}, {"g", 5.0}, {"p0", 30.0}};

Given with(Given given, const std::string& name, Value value) {
    given.insert_or_assign(name, std::move(value));
    return given;
}

/// A wave needs 0.31, 0.2, 0.49 and 0.49 s from end to end; the ramps last for one and for three of these.
const std::vector<Case> waves{{"bar_traction", pulled},
                              {"oedometer", column},
                              {"oedometer", with(column, "ramp", 0.2)},
                              {"oedometer", with(with(column, "ramp", 0.6), "p0", 0.0)},
                              {"bar_mms", swinging},
                              {"periodic_bar_mms", standing}};

std::vector<Case> moving() {
    auto cases = waves;
    cases.push_back({"bar_traction", with(pulled, "profile", "step")});
    cases.push_back({"uniaxial_strain", plastic});
    cases.push_back({"uniaxial_strain", with(plastic, "rate", -0.7)});
    return cases;
}

std::vector<std::string> laws() { return solvers::law_parameter("E(F-1)").word_names(); }

constexpr double round_off = 1e-12;        // of the truth's largest value, after less than a hundred radians
constexpr double difference_error = 2e-6;  // see balance_fault; harmonics of large amplitudes have a third of L
constexpr std::array some_times{0.01, 0.15, 0.4, 1.03};

/// P(H) = p0, dP/dX = rho g in a column at rest, with P from the law and u of the truth by differences over 1e-4 H.
double rest_fault(const Bound& scene) {
    const double H = scene.bar.upper[0];
    const double d = 1e-4 * H;
    const auto P = [&](double X) {
        const double rise = exact(scene, "displacement", X + d, 0) - exact(scene, "displacement", X - d, 0);
        return nominal(scene.bar.law, 1 + rise / (2 * d));
    };
    Relative rest;
    for (int i = 1; i < 8; ++i) {
        const double X = H * i / 8;
        const double weight = -scene.bar.rho * at(scene.bar.body_force, X, 0) * (H - X);
        rest.add(P(X), at(scene.bar.traction, H, 0) - weight);
    }
    return rest.value();
}

/// The truth's momentum at t less the impulse of the end's traction, before the wave has reached the other end.
double impulse_fault(const Bound& scene, double t) {
    const double L = scene.bar.upper[0];
    const std::vector<double> ends{0, L};
    std::vector<double> means(scene.truth.width());
    scene.truth.averages(ends, t, means);
    double impulse = 0;
    for (int i = 0; i < 1000; ++i) impulse += at(scene.bar.traction, L, (i + 0.5) * t / 1000) * t / 1000;
    return std::abs(scene.bar.rho * L * means[*scene.truth.offset("velocity")] / impulse - 1);
}

}  // namespace

TEST_CASE("scenes: a body starts as its truth does", "[unit]") {
    for (const auto& [name, given] : moving()) {
        INFO(name);
        CHECK(start_fault(bound(name, given)) <= round_off);
    }
}

TEST_CASE("scenes: held ends move and free ends are loaded as in the truth", "[unit]") {
    for (const auto& [name, given] : moving()) {
        for (const double t : some_times) {
            INFO(name << " at t = " << t);
            CHECK(end_fault(bound(name, given), t) <= round_off);
        }
    }
    CHECK(end_fault(bound("oedometer_static", heavy), 0) <= round_off);
}

TEST_CASE("scenes: sudden loads act from t = 0 on", "[unit]") {
    CHECK(at(bound("bar_traction", with(pulled, "profile", "step")).bar.traction, 2, 0) == 5);
    CHECK(at(bound("oedometer", column).bar.traction, 3, 0) == -30);
    CHECK(at(bound("oedometer", column).bar.body_force, 1, 0) == -5);
    CHECK(at(bound("oedometer", with(column, "ramp", 0.2)).bar.body_force, 1, 0) == 0);
}

TEST_CASE("scenes: what does not act is left out", "[unit]") {
    const auto light = bound("oedometer", with(column, "g", 0.0)).bar;
    CHECK((!light.body_force && light.traction && !light.damping));
    const auto unloaded = bound("oedometer_static", with(heavy, "p0", 0.0)).bar;
    CHECK((unloaded.body_force && !unloaded.traction && unloaded.damping));
    CHECK_FALSE(bound("bar_traction", pulled).bar.body_force);
}

TEST_CASE("scenes: the truth balances the scene's momentum", "[property]") {
    for (const auto& [name, given] : waves) {
        INFO(name);
        CHECK(balance_fault(bound(name, given), 6, 1) <= difference_error);
    }
}

TEST_CASE("scenes: problem and truth have the same defaults", "[property]") {
    for (const char* name : {"bar_traction", "oedometer", "bar_mms", "periodic_bar_mms"}) {
        INFO(name);
        CHECK(balance_fault(bound(name, {}), 6, 2) <= difference_error);
    }
    CHECK(rest_fault(bound("oedometer_static", {})) <= 1e-8);
    const auto& oracle = oracles::oracle_named("j2_uniaxial_strain", "test");
    const auto small_strain = oracle.bind(resolve(oracle.parameters, {}, "test", oracle.name));
    const auto scene = bound("uniaxial_strain", {});
    CHECK(exact(scene, "stress", 0.5, 0.02) == Approx(exact({scene.bar, small_strain}, "stress", 0, std::log(1.02))));
}

TEST_CASE("scenes: the traction's impulse is the truth's momentum", "[property]") {
    for (const char* profile : {"sine", "step"}) {
        const auto scene = bound("bar_traction", with(pulled, "profile", profile));
        CHECK(impulse_fault(scene, 0.1) <= 1e-6);  // midpoint rule: (omega t / 1000)^2 / 24
        CHECK(impulse_fault(scene, 0.3) <= 1e-6);
    }
}

TEST_CASE("scenes: a column at rest bears its load, whatever the law", "[property]") {
    for (const auto& law : laws()) {
        INFO(law);
        const auto scene = bound("oedometer_static", with(heavy, "law", law));
        CHECK(exact(scene, "displacement", 0, 0) == 0);
        CHECK(rest_fault(scene) <= 1e-8);  // (1e-4 H)^2 u''' / 6 u'; u''' H^2 < u' here. Round-off 1e-12
    }
}

TEST_CASE("scenes: the law that is asked for is the one that is given", "[unit]") {
    constexpr double F = 1.25;
    const double P_over_E[]{std::log(F), 1 - 1 / F, F - 1, std::log(F) / F, (F - 1 / F) / 2};
    const std::vector<std::string> names{"E ln F", "E(1-1/F)", "E(F-1)", "E ln F / F", "E(F-1/F)/2"};
    REQUIRE(laws() == names);
    for (std::size_t i = 0; i < names.size(); ++i) {
        INFO(names[i]);
        for (const auto& [name, given] :
             {Case{"bar_traction", pulled}, {"oedometer", column}, {"oedometer_static", heavy}}) {
            const double E = std::get<double>(given.at("E"));
            CHECK(nominal(bound(name, with(given, "law", names[i])).bar.law, F) ==
                  Approx(E * P_over_E[i]).epsilon(1e-14));
        }
    }
}

TEST_CASE("scenes: F of a deformed start is 1 + du/dX", "[unit]") {
    const auto scene = bound("periodic_bar_mms", standing);
    REQUIRE(scene.bar.deformed);
    constexpr double d = 1e-4;  // (pi d)^2 / 6 is 2e-8, round-off 1e-13
    for (const double X : {0.1, 0.37, 1.0, 1.6}) {
        const auto& u = scene.bar.deformed->displacement;
        CHECK(at(scene.bar.deformed->F, X, 0) ==
              Approx(1 + (at(u, X + d, 0) - at(u, X - d, 0)) / (2 * d)).epsilon(5e-8));
    }
}

TEST_CASE("scenes: damping is critical for the first mode unless it is given", "[unit]") {
    // x'' + alpha x' + omega^2 x = 0 has a double root at alpha = 2 omega; the dynamic column knows omega.
    const double omega = oracles::Oedometer{.H = 3, .E = 900, .rho = 4}.first_eigenfrequency();
    CHECK(bound("oedometer_static", heavy).bar.damping.value() == Approx(2 * omega).epsilon(1e-14));
    CHECK(bound("oedometer_static", with(heavy, "damping", 0.75)).bar.damping.value() == 0.75);
}

TEST_CASE("scenes: small strain increments of the deformed body add up to the truth's stress", "[property]") {
    // The midpoint of each step makes ln F an O(steps^-2) sum; the flow rule is exact on this path.
    for (const double rate : {0.7, -0.7, 0.002}) {
        const auto scene = bound("uniaxial_strain", with(plastic, "rate", rate));
        const auto law = std::get<solvers::J2Law>(scene.bar.law);
        solvers::J2Law::History history;
        constexpr int steps = 20'000;
        for (int i = 0; i < steps; ++i) {
            const double middle = 1 + rate * (i + 0.5) / steps;
            law.updated<1>(history, solvers::Tensor<1>(rate / steps / middle));
        }
        CHECK(history.sigma(0, 0) == Approx(exact(scene, "stress", 0.5, 1)).epsilon(1e-8));
        CHECK((history.plastic_strain > 0) == (std::abs(rate) > 0.1));
    }
    // By hand at F = 1.7: G = 375, K = 500, e = ln F, p = (2 G e - Y0) / (3 G + H), sigma = K e + 2 (Y0 + H p) / 3.
    const auto scene = bound("uniaxial_strain", plastic);
    const double e = std::log(1.7);
    const double q = 3 + 40 * (750 * e - 3) / (1125 + 40);
    CHECK(exact(scene, "displacement", 2, 1) == Approx(1.4));
    CHECK(exact(scene, "strain", 2, 1) == Approx(0.7));
    CHECK(exact(scene, "stress", 2, 1) == Approx(500 * e + 2 * q / 3).epsilon(1e-13));
}

TEST_CASE("scenes: a problem without a truth is refused before it runs", "[unit]") {
    const std::vector<Case> refused{
        {"bar_traction", with(pulled, "omega", 1e30)},  {"oedometer", with(column, "ramp", 1e9)},
        {"oedometer_static", with(heavy, "p0", 900.0)}, {"bar_mms", with(swinging, "A", 1.0)},
        {"periodic_bar_mms", with(standing, "A", 0.4)}, {"uniaxial_strain", with(plastic, "rate", 1.5e308)}};
    for (const auto& [name, given] : refused) {
        INFO(name);
        const auto& scene = scene_named(name, "test");
        const Values values = resolve(scene.parameters, given, "test", name);
        CHECK_THROWS_AS(scene.problem(values), InputError);
        CHECK_THROWS_AS(scene.truth(values), InputError);
    }
    const auto times = bound("uniaxial_strain", with(plastic, "rate", -0.5)).truth.times;
    CHECK((times.contains(1.9) && !times.contains(2)));  // F = 0 at t = 2
}

TEST_CASE("alarm: a scene that asks for something else is found", "[alarm]") {
    auto scene = bound("bar_traction", pulled);
    scene.bar.traction = [](auto, double t, auto out) { out[0][0] = -5 * std::sin(11 * t); };
    CHECK(end_fault(scene, 0.15) > 0.1);
    CHECK(impulse_fault(scene, 0.1) > 0.1);

    scene = bound("oedometer", with(column, "ramp", 0.2));
    scene.bar.body_force = [](auto, double t, auto out) { out[0][0] = -5 * std::min(1.0, t / 0.2); };
    CHECK(balance_fault(scene, 6, 1) > 0.01);

    for (const auto& [name, given] : {Case{"bar_mms", swinging}, {"periodic_bar_mms", standing}}) {
        scene = bound(name, given);
        const auto right = *scene.bar.body_force;
        scene.bar.body_force = [right](auto X, double t, auto out) {
            right(X, t, out);
            out[0] *= 1.0001;
        };
        CHECK(balance_fault(scene, 6, 1) > 5 * difference_error);
        scene.bar.body_force.reset();
        CHECK(balance_fault(scene, 6, 1) > 0.01);
    }
    scene.bar.deformed.reset();
    CHECK(start_fault(scene) > 0.1);

    scene = bound("uniaxial_strain", plastic);
    scene.bar.face_velocity.reset();
    CHECK(end_fault(scene, 0.15) > 0.1);

    scene = bound("oedometer_static", heavy);
    scene.bar.law = solvers::make_law("E ln F", {.lambda = 0, .mu = 450});
    CHECK(rest_fault(scene) > 1e-4);
}

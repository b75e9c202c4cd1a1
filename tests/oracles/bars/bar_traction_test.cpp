#include "oracles/bars/bar_traction.hpp"

#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/bars/bar_traction_cases_gate.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::loaded;

namespace {

double detuning(const BarTraction& bar) { return std::cos(bar.omega * bar.L / bar.wave_speed()); }

/// |images - series| beyond bound and round-off, over the amplitude.
Defect series_defect(const BarTraction& bar, int terms, bool lifted) {
    const BarMotion motion = motion_of(bar);
    const double scale = largest(motion, motion.displacement);
    const double bound = lifted ? bar.lifted_bound(terms) : bar.modal_bound(terms);
    // Near resonance both parts grow like 1 / cos(omega L / c), which itself is known to an absolute 1e-16 only.
    const double cosine = detuning(bar);
    const double cancels = lifted ? std::max(1.0, std::abs(bar.tau) * bar.L / bar.E / scale / (cosine * cosine)) : 1;
    Defect defect;
    for (const double X : {0.0, 0.17043, 0.5, 0.83051, 1.0}) {
        for (const double share : bar_times) {
            const double t = share * motion.transit();
            const double series =
                lifted ? bar.lifted_displacement(X * bar.L, t, terms) : bar.modal_displacement(X * bar.L, t, terms);
            const double beyond = std::abs(series - motion.displacement(X * bar.L, t)) - bound;
            defect.add(std::max(0.0, beyond), cancels * motion.accuracy(t) * scale, scale);
        }
    }
    return defect;
}

}  // namespace

TEST_CASE("bar_traction: equation, data, energy and fronts hold", "[gate]") {
    for (const auto& bar : loaded_bars()) {
        for (const auto& [name, gate] : bar_gates) {
            const Defect defect = gate(motion_of(bar));
            INFO(name << ": " << name_of(bar) << ": defect " << defect.found << ", allowed " << defect.allowed);
            CHECK(defect.holds());
        }
    }
}

TEST_CASE("bar_traction: both series stay within their bounds, which are not idle", "[gate]") {
    for (const auto& bar : loaded_bars()) {
        for (const int terms : {10, 300}) {
            INFO(name_of(bar) << ", terms " << terms);
            const Defect modal = series_defect(bar, terms, false);
            INFO("modal: defect " << modal.found << ", allowed " << modal.allowed);
            CHECK(modal.holds());
            if (bar.resonant_mode() > 0) {
                CHECK(std::isinf(bar.lifted_bound(terms)));
                continue;
            }
            if (std::abs(detuning(bar)) < 1e-4) continue;
            const Defect lifted = series_defect(bar, terms, true);
            INFO("lifted: defect " << lifted.found << ", allowed " << lifted.allowed);
            CHECK(lifted.holds());
        }
    }
    // At t = 0 the step's lifted series is all truncation: 8 L tau / (pi^2 E) times the rest of sum 1 / (2n - 1)^2.
    const BarTraction step{.L = 2, .E = 7, .tau = 3, .profile = Profile::step};
    for (const int terms : {1, 2, 5, 20, 1000}) {
        const double error = std::abs(step.lifted_displacement(2, 0, terms));
        CHECK(error <= step.lifted_bound(terms));
        CHECK(error >= 0.9 * step.lifted_bound(terms));
        CHECK(step.lifted_bound(terms) == Approx(8 * 3 * 2 / (pi * pi * 7) / (4 * terms)).epsilon(1e-14));
    }
    // The sine's: within a factor 10 where the first terms left out pull the same way.
    const BarTraction bar = sine(1.3, 7, 2, 0.3, 1.1);
    const double early = 0.5 / 1000 * bar.L / bar.wave_speed();
    CHECK(std::abs(bar.lifted_displacement(1.3, early, 1000) - bar.displacement(1.3, early)) >
          0.1 * bar.lifted_bound(1000));
    CHECK(std::isinf(bar.modal_bound(0)));
    CHECK(std::isinf(sine(1, 1, 1, 1, 9.5 * pi).modal_bound(9)));
}

TEST_CASE("bar_traction: the table of one period", "[gate]") {
    const BarTraction bar{.L = 1.3, .E = 70, .rho = 3, .tau = 2, .omega = pi * std::sqrt(70 / 3.0) / 1.3};
    const double alpha = bar.tau * bar.L / (pi * bar.E);
    const auto table = [&](double x, double r) {  // x and ct in lengths L, 0 <= r < 4
        const double plus = std::cos(pi * (r + x)), minus = std::cos(pi * (r - x));
        return r < 1 - x ? 0 : r < 1 + x ? 1 + plus : r < 3 - x ? plus - minus : r < 3 + x ? -1 - minus : 0;
    };
    for (int period = 0; period < 3; ++period) {
        for (double r = 0.0137; r < 4; r += 0.0519) {
            for (double x = 0; x <= 1; x += 0.0625) {
                const double t = (r + 4 * period) * bar.L / bar.wave_speed();
                const double tolerance = 1e-14 * (1 + bar.omega * t);
                CHECK(std::abs(bar.displacement(x * bar.L, t) / alpha - table(x, r)) <= tolerance);
            }
        }
    }
}

TEST_CASE("bar_traction: step load, values of the textbooks", "[published]") {
    const BarTraction bar{.L = 2.5, .E = 40, .rho = 3, .tau = 0.7, .profile = Profile::step};
    const double transit = bar.L / bar.wave_speed();
    const double tip = bar.tau * bar.L / bar.E;
    CHECK(bar.displacement(bar.L, transit) == Approx(tip).epsilon(1e-14));
    CHECK(bar.displacement(bar.L, 2 * transit) == Approx(2 * tip).epsilon(1e-14));
    CHECK(std::abs(bar.displacement(bar.L, 4 * transit)) < 1e-14 * tip);
    CHECK(bar.stress(0, 0.999 * transit) == 0);
    for (const double share : {1.001, 1.7, 2.3, 2.999}) CHECK(bar.stress(0, share * transit) == 2 * bar.tau);
    CHECK(bar.stress(0, 3.001 * transit) == 0);
    // The default bar: c = 1, omega between the first two eigenfrequencies, period 4, alpha = tau L / (pi E).
    const BarTraction benchmark;
    CHECK(benchmark.wave_speed() == 1);
    CHECK(benchmark.omega == Approx(2 * benchmark.eigenfrequency(1)).epsilon(1e-15));
    CHECK(benchmark.displacement(1, 1) == Approx(2 / (100 * pi)).epsilon(1e-14));
}

TEST_CASE("bar_traction: means over cells are integrals of the fields", "[gate]") {
    for (const auto& bar : loaded_bars()) {
        const BarMotion motion = motion_of(bar);
        const Exact exact = bound_bar(given_by(bar));
        const Row scale{largest(motion, motion.displacement), largest(motion, motion.velocity),
                        largest(motion, motion.stress), largest(motion, motion.strain)};
        for (const double share : {0.21147, 1.30671, 2.43317, 3.31907, 12.83011}) {
            const double t = share * motion.transit();
            const auto at = [&](double X) { return row_at(exact, X, t); };
            const auto mean = [&](double a, double b) { return mean_over(exact, a, b, t); };
            const auto places = front_places(motion, t);
            const Defect defect = bar_averages(bar.L, places, scale, motion.accuracy(t), at, mean);
            INFO(name_of(bar) << ": defect " << defect.found << ", allowed " << defect.allowed);
            CHECK(defect.holds());
            const auto wrong = [&](double a, double b) { return at((a + b) / 2); };
            CHECK_FALSE(bar_averages(bar.L, places, scale, motion.accuracy(t), at, wrong).holds());
        }
    }
}

TEST_CASE("bar_traction: the catalogue entry binds the same numbers, says its jumps and constants", "[unit]") {
    for (const auto& bar : loaded_bars()) {
        const Exact exact = bound_bar(given_by(bar));
        for (const double share : bar_times) {
            const double t = share * bar.L / bar.wave_speed();
            const double X = 0.38541 * bar.L;
            CHECK(row_at(exact, X, t) == Row{bar.displacement(X, t) + 0.0, bar.velocity(X, t) + 0.0,
                                             bar.stress(X, t) + 0.0, bar.strain(X, t) + 0.0});
            CHECK(exact.jumps(t).size() == (bar.profile == Profile::step ? 1 : 0));
        }
        CHECK(exact.jumps(0).empty());
    }
    const auto word = [](const Exact& exact, const std::string& name) {
        for (const auto& constant : exact.constants(0.25)) {
            if (constant.name == name) return std::get<std::string>(constant.value);
        }
        return std::string("none");
    };
    CHECK(word(bound_bar({}), "resonance") == "no");
    CHECK(word(bound_bar(given_by(sine(1.3, 7, 2, 1, 1.5 * pi))), "resonance") == "yes");
    CHECK(word(bound_bar({{"profile", "step"}}), "resonance") == "none");
    CHECK(sine(1.3, 7, 2, 1, 1.5 * pi).resonant_mode() == 2);
    CHECK_THROWS_WITH(bound_bar({{"omega", 1e20}}), ContainsSubstring("oracle bar_traction: omega = 1e+20"));
    CHECK_THROWS_WITH(bound_bar({{"E", 1e300}, {"rho", 1e-300}}), ContainsSubstring("wave speed"));
    CHECK_THROWS_WITH(bound_bar({{"tau", 1e308}, {"E", 1e-3}}), ContainsSubstring("tau / E"));
    CHECK_FALSE(bound_bar({}).times.contains(1e13));
}

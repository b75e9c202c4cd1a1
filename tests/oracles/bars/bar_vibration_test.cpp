#include "oracles/bars/bar_vibration.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/bars/bar_vibration_gate.hpp"
#include "tests/oracles/fuzz.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::vibration;

namespace {

constexpr std::array all_ends{BarVibration::Ends::fixed_free, BarVibration::Ends::fixed_fixed,
                              BarVibration::Ends::periodic};

std::string word_of(BarVibration::Ends ends) {
    return std::array{"fixed_free", "fixed_fixed", "periodic"}.at(static_cast<std::size_t>(ends));
}

/// Default and off-default bars: soft, steel in SI, short and heavy, with a negative amplitude.
std::vector<BarVibration> bars() {
    std::vector<BarVibration> list;
    for (const auto ends : all_ends) {
        for (const int mode : {1, 2, 3, 7, 40}) {
            list.push_back({.mode = mode, .ends = ends});
            list.push_back({.L = 0.3, .E = 2.1e11, .rho = 7850, .v0 = -3, .mode = mode, .ends = ends});
            list.push_back({.L = 1.7, .E = 0.02, .rho = 13, .v0 = 1e-4, .mode = mode, .ends = ends});
        }
    }
    return list;
}

std::string names_of(const BarVibration& bar) {
    return word_of(bar.ends) + ", mode " + std::to_string(bar.mode) + ", L = " + std::to_string(bar.L);
}

Exact bound(const BarVibration& bar) {
    const Oracle oracle = bar_vibration();
    const std::string ends = word_of(bar.ends);
    const Given given{{"L", bar.L},  {"E", bar.E}, {"rho", bar.rho}, {"v0", bar.v0}, {"mode", double(bar.mode)},
                      {"ends", ends}};
    return oracle.bind(resolve(oracle.parameters, given, "", "bar_vibration"));
}

Means means_of(const BarVibration& bar) {
    return [exact = bound(bar)](double a, double b, double t) {
        const std::array edges{a, b};
        std::array<double, 4> row{};
        exact.averages(edges, t, row);
        return row;
    };
}

/// Names of the gates that the motion does not pass, joined.
std::string ringing(const Motion& motion) {
    std::string names;
    for (const auto& [name, defect] : gates) {
        if (!defect(motion).holds()) names += name + "; ";
    }
    return names;
}

}  // namespace

TEST_CASE("bar_vibration: equation, derivatives, boundary and initial data, period and energy hold", "[gate]") {
    for (const auto& bar : bars()) {
        for (const auto& [name, gate] : gates) {
            const Defect defect = gate(motion_of(bar));
            INFO(name << ": " << names_of(bar) << ": defect " << defect.found << ", allowed " << defect.allowed);
            CHECK(defect.holds());
        }
    }
}

TEST_CASE("bar_vibration: a periodic bar goes on at its end as it began, and an odd mode between walls does not",
          "[gate]") {
    for (const int mode : {1, 2, 3, 7, 40}) {
        for (const auto ends : {BarVibration::Ends::periodic, BarVibration::Ends::fixed_fixed}) {
            const BarVibration bar{.L = 0.3, .E = 2.1e11, .rho = 7850, .v0 = -3, .mode = mode, .ends = ends};
            const double t = 0.2 / bar.frequency();
            const double largest = std::abs(bar.strain(0, t));
            // 2 ulp times 1 + k L + omega t, as stated.
            const double allowed = 4.5e-16 * (2 + bar.wave_number() * bar.L) * largest;
            const double gap = std::abs(bar.strain(bar.L, t) - bar.strain(0, t));
            const bool goes_on = ends == BarVibration::Ends::periodic || mode % 2 == 0;
            CHECK((goes_on ? gap <= allowed : gap > largest));
            CHECK(std::abs(bar.velocity(bar.L, t)) <= 4.5e-16 * (2 + bar.wave_number() * bar.L) * 3);
        }
    }
}

TEST_CASE("bar_vibration: the stated accuracy holds up to the highest mode", "[gate]") {
    for (const auto ends : all_ends) {
        const Motion motion = motion_of({.L = 0.7, .E = 3, .rho = 1.3, .mode = 1000, .ends = ends});
        CHECK(boundary_data(motion).holds());
        CHECK(initial_data(motion).holds());
        CHECK(period(motion).holds());
    }
}

TEST_CASE("bar_vibration: the catalogue binds the same numbers to the same bits", "[gate]") {
    const Oracle& oracle = oracle_named("bar_vibration", "");
    for (const auto& bar : bars()) {
        const std::string ends = word_of(bar.ends);
        const Given given{{"L", bar.L},  {"E", bar.E}, {"rho", bar.rho}, {"v0", bar.v0}, {"mode", double(bar.mode)},
                          {"ends", ends}};
        const Exact exact = oracle.bind(resolve(oracle.parameters, given, "", "bar_vibration"));
        const auto value = [&](const std::string& field, double X, double t) {
            std::vector<double> values(exact.width());
            exact.sample({&X, 1}, t, values);
            return values.at(*exact.offset(field));
        };
        CHECK((exact.dim == 1 && exact.coordinates == Coordinates::material));
        CHECK((exact.lower == std::vector{0.0} && exact.upper == std::vector{bar.L} && exact.jumps(0.3).empty()));
        at_samples(motion_of(bar), [&](double X, double t) {
            REQUIRE(value("displacement", X, t) == bar.displacement(X, t));
            REQUIRE(value("velocity", X, t) == bar.velocity(X, t));
            REQUIRE(value("strain", X, t) == bar.strain(X, t));
            REQUIRE(value("stress", X, t) == bar.stress(X, t));
        });
    }
}

TEST_CASE("bar_vibration: the gate rings for seeded faults", "[alarm]") {
    for (const auto& bar : bars()) {
        const Motion good = motion_of(bar);
        INFO(names_of(bar));
        const double v_scale = std::abs(bar.v0);
        CHECK(ringing(good).empty());

        // Wave number one part in a million too large, frequency right.
        Motion wave_number = good;
        wave_number.displacement = [good](double X, double t) { return good.displacement(X * (1 + 1e-6), t); };
        CHECK_THAT(ringing(wave_number), ContainsSubstring("equation of motion") && ContainsSubstring("derivatives"));

        // cos for sin in space: the same waves, a quarter wave further on; derivatives all consistent.
        Motion quarter = good;
        const double shift = good.half_wave() / 2;
        for (OfXt Motion::*field : {&Motion::displacement, &Motion::velocity, &Motion::strain, &Motion::stress}) {
            quarter.*field = [f = good.*field, shift](double X, double t) { return f(X + shift, t); };
        }
        CHECK_THAT(ringing(quarter), ContainsSubstring("boundary data") && ContainsSubstring("initial data"));

        // Stress without E.
        Motion strain_for_stress = good;
        strain_for_stress.stress = good.strain;
        CHECK_THAT(ringing(strain_for_stress), ContainsSubstring("derivatives") && ContainsSubstring("energy"));

        // The motion of a bar with the other end condition.
        Motion other_ends =
            motion_of({bar.L, bar.E, bar.rho, bar.v0, bar.mode,
                       good.free_end() ? BarVibration::Ends::fixed_fixed : BarVibration::Ends::fixed_free});
        other_ends.bar.ends = bar.ends;
        CHECK_THAT(ringing(other_ends), ContainsSubstring("boundary data") && ContainsSubstring("period"));

        // The next mode; velocity that forgot to follow the frequency's sign; a decaying amplitude; NaN.
        Motion next_mode = motion_of({bar.L, bar.E, bar.rho, bar.v0, bar.mode + 1, bar.ends});
        next_mode.bar.mode = bar.mode;
        CHECK_THAT(ringing(next_mode), ContainsSubstring("initial data") && ContainsSubstring("period"));
        Motion decaying = good;
        decaying.velocity = [good](double X, double t) {
            return good.velocity(X, t) * std::exp(-1e-6 * t / good.transit());
        };
        CHECK_THAT(ringing(decaying), ContainsSubstring("energy") && ContainsSubstring("derivatives"));
        Motion broken = good;
        broken.displacement = [v_scale](double, double) { return v_scale * std::nan(""); };
        CHECK_THAT(ringing(broken), ContainsSubstring("equation of motion") && ContainsSubstring("period"));
    }
}

TEST_CASE("bar_vibration: means over cells are integrals of the fields", "[gate]") {
    for (const auto& bar : bars()) {
        const Defect defect = cell_averages(motion_of(bar), means_of(bar));
        INFO(names_of(bar) << ": defect " << defect.found << ", allowed " << defect.allowed);
        CHECK(defect.holds());
    }
}

TEST_CASE("bar_vibration: the gate of means rings for seeded faults", "[alarm]") {
    for (const auto& bar : {bars()[3], bars()[19]}) {
        INFO(names_of(bar));
        const Motion motion = motion_of(bar);
        const Means good = means_of(bar);
        REQUIRE(cell_averages(motion, good).holds());
        const auto holds = [&](const Means& means) { return cell_averages(motion, means).holds(); };
        const auto row = [&](double X, double t) {
            return std::array{motion.displacement(X, t), motion.velocity(X, t), motion.stress(X, t),
                              motion.strain(X, t)};
        };
        // The middle's value, the mean of the ends, a cell too wide, one field for another, a difference of ends.
        CHECK_FALSE(holds([&](double a, double b, double t) { return row((a + b) / 2, t); }));
        CHECK_FALSE(holds([&](double, double b, double t) { return row(b, t); }));
        CHECK_FALSE(holds([&](double a, double b, double t) { return good(a, b + 1e-6 * (b - a), t); }));
        CHECK_FALSE(holds([&](double a, double b, double t) {
            auto means = good(a, b, t);
            std::swap(means[2], means[3]);
            return means;
        }));
        CHECK_FALSE(holds([&](double a, double b, double t) {
            auto means = good(a, b, t);
            means[3] = (motion.displacement(b, t) - motion.displacement(a, t)) / (b - a);
            return means;
        }));
        CHECK_FALSE(holds([&](double a, double b, double t) {
            auto means = good(a, b, t);
            if (b - a < 1e-9 * bar.L) means[0] = std::nan("");
            return means;
        }));
    }
}

TEST_CASE("bar_vibration: random bars keep their energy at every point of phase", "[property]") {
    Random random(20260);
    Tally tally;
    const int rounds = fuzz_rounds(2000);
    for (int round = 0; round < rounds; ++round) {
        const double decades = round % 10 == 0 ? 1e150 : 1e4;
        BarVibration bar{.L = random.log_uniform(1 / decades, decades),
                         .E = random.log_uniform(1 / decades, decades),
                         .rho = random.log_uniform(1 / decades, decades),
                         .v0 = random.uniform(-3, 3),
                         .mode = random.coin() ? random.whole(1, 1000) : random.whole(1, 5),
                         .ends = random.coin()   ? BarVibration::Ends::fixed_free
                                 : random.coin() ? BarVibration::Ends::fixed_fixed
                                                 : BarVibration::Ends::periodic};
        try {
            const Exact exact = bound(bar);
            const double t = random.log_uniform(1e-3, 1e6) / bar.frequency();
            const double X = random.uniform(0, 1) * bar.L;
            std::array<double, 4> row{};
            exact.sample({&X, 1}, t, row);
            for (const double value : row) REQUIRE(std::isfinite(value));
            // (u omega / sin kX)^2 + (v / sin kX)^2 = v0^2 at any X and t.
            const double sine = std::sin(bar.wave_number() * X);
            const double energy = std::hypot(row[0] * bar.frequency(), row[1]);
            const double most = std::abs(bar.v0);
            INFO(names_of(bar) << ", X = " << X << ", omega t = " << bar.frequency() * t);
            REQUIRE(std::abs(energy - most * std::abs(sine)) <= 4e-16 * (8 + bar.wave_number() * X) * most);
            ++tally.checked;
        } catch (const InputError&) {
            REQUIRE(decades > 1e4);  // only where frequency or amplitude is no number
            ++tally.refused;
        }
    }
    CHECK(tally.mostly_checked());
}

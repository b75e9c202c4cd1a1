#include "oracles/bars/oedometer.hpp"

#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/bars/oedometer_cases_gate.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::loaded;

namespace {

/// Section and verse of the papers: static part and modes, one after the other.
double plain_series(const Oedometer& c, double y, double t, int terms) {
    double u = c.rho * c.g / (2 * c.E) * y * y + (c.p0 - c.rho * c.g * c.H) * y / c.E;
    for (int n = 1; n <= terms; ++n) {
        const double k = (2 * n - 1) * pi / (2 * c.H);
        const double u_n = 16 * c.rho * c.g * c.H * c.H / (std::pow(2 * n - 1, 3) * std::pow(pi, 3) * c.E) +
                           8 * c.H * c.p0 * std::pow(-1, n) / (std::pow(2 * n - 1, 2) * pi * pi * c.E);
        u += u_n * std::cos(std::sqrt(c.E / c.rho) * k * t) * std::sin(k * y);
    }
    return u;
}

}  // namespace

TEST_CASE("oedometer: equation, data, energy and fronts hold", "[gate]") {
    for (const auto& column : columns()) {
        for (const auto& [name, gate] : bar_gates) {
            const Defect defect = gate(motion_of(column));
            INFO(name << ": " << name_of(column) << ": defect " << defect.found << ", allowed " << defect.allowed);
            CHECK(defect.holds());
        }
    }
}

TEST_CASE("oedometer: the series comes within its bound, which is not idle", "[gate]") {
    for (const auto& column : columns()) {
        const BarMotion motion = motion_of(column);
        const double scale = largest(motion, motion.displacement);
        for (const int terms : {1, 20, 400}) {
            const double bound = column.series_bound(terms);
            double worst = 0;
            for (const double y : {0.17043, 0.5, 0.83051, 1.0}) {
                for (const double share : bar_times) {
                    const double t = share * motion.transit();
                    const double series = column.series(y * column.H, y * column.H, t, terms).displacement;
                    const double error = std::abs(series - column.displacement(y * column.H, t));
                    worst = std::max(worst, error);
                    INFO(name_of(column) << ", terms " << terms << ", y " << y << ", t " << t);
                    CHECK(error <= bound + motion.accuracy(t) * scale);
                }
            }
            // At t = 0 the first terms left out have one sign: those of the load at the top, of gravity near the base.
            for (const double y : {column.H, column.H / (2 * terms)})
                worst = std::max(worst, std::abs(column.series(y, y, 0, terms).displacement));
            if (column.ramp == 0) CHECK(worst > 0.2 * bound);
        }
    }
}

TEST_CASE("oedometer: truncated, it is the series that the papers print", "[gate]") {
    for (auto column : columns()) {
        column.ramp = 0;
        const double scale =
            std::abs(column.p0) * column.H / column.E + column.rho * column.g * column.H * column.H / column.E;
        for (const int terms : {1, 2, 20, 333}) {
            column.terms = terms;
            const Exact exact = bound_column(given_by(column));
            CHECK(exact.jumps(0.3).empty());
            for (const double share : bar_times) {
                const double t = share * column.H / column.wave_speed();
                for (const double y : bar_places) {
                    const double expected = plain_series(column, y * column.H, t, terms);
                    // Phases omega_n t are rounded; weights 1 / n^2 leave the logarithm of their number.
                    CHECK(std::abs(row_at(exact, y * column.H, t)[0] - expected) <= 1e-15 * scale * (4 + 4 * share));
                }
            }
        }
    }
    // Velocity and strain of the series are its derivatives, ramped too: it is smooth.
    for (auto column : columns()) {
        column.terms = 7;
        const double t = 0.70923 * column.H / column.wave_speed(), y = 0.38541 * column.H;
        const auto in_time = [&](double s) { return column.displacement(y, s); };
        const auto in_space = [&](double s) { return column.displacement(s, t); };
        const double scale = 4 * (std::abs(column.p0) + column.rho * column.g * column.H) / column.E;
        const double step = 0.008;
        const auto u_t = first_derivative(in_time, t, step * column.H / column.wave_speed(), 1e-15 * scale * column.H);
        const auto u_y = first_derivative(in_space, y, step * column.H, 1e-15 * scale * column.H);
        Defect defect;
        defect.add(column.velocity(y, t) - u_t.value, u_t.error, scale * column.wave_speed());
        defect.add(column.strain(y, t) - u_y.value, u_y.error, scale);
        INFO(name_of(column) << ": defect " << defect.found << ", allowed " << defect.allowed);
        CHECK(defect.holds());
    }
}

TEST_CASE("oedometer: the ramped series is Duhamel's integral of the sudden one, by quadrature", "[gate]") {
    // u(t) = r(t) w(0) + int_0^t r(s) w_t(t - s) ds for the response w to the sudden load: ramps from a tenth of a
    // radian of the slowest mode to hundreds of the fastest, so that both branches of a mode's response are met.
    const Oedometer sudden{.H = 1.3, .E = 8, .rho = 2, .g = 2.1, .terms = 9};
    const double transit = sudden.H / sudden.wave_speed();
    const double y = 0.38541 * sudden.H;
    const double scale = sudden.rho * sudden.g * sudden.H * sudden.H / sudden.E;
    for (const double ramp : {0.06, 0.31, 0.9, 2.7, 12.0}) {
        Oedometer slow = sudden;
        slow.ramp = ramp * transit;
        for (const double share : {0.05, 0.4, 0.93, 1.7, 4.1}) {
            const double t = share * slow.ramp;
            const auto pull = [&](double s) { return gravity_share(slow.ramp, s) * sudden.velocity(y, t - s); };
            // Pieces of less than half a period of the fastest mode, cut where the ramp ends.
            double sum = 0;
            for (const auto& [low, high] :
                 {std::pair{0.0, std::min(t, slow.ramp)}, std::pair{std::min(t, slow.ramp), t}}) {
                const int pieces = 1 + static_cast<int>((high - low) / (0.1 * transit));
                for (int k = 0; k < pieces && high > low; ++k) {
                    const double from = low + (high - low) * k / pieces, to = low + (high - low) * (k + 1) / pieces;
                    sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(pull, from, to, 0);
                }
            }
            const double expected = gravity_share(slow.ramp, t) * sudden.displacement(y, 0) + sum;
            INFO("ramp " << ramp << " transits, t " << share << " ramps");
            CHECK(std::abs(slow.displacement(y, t) - expected) <= 1e-14 * scale * (1 + t / transit));
        }
    }
}

TEST_CASE("oedometer: numbers of the papers", "[published]") {
    // Twenty terms: at most 1e-5 m for the column of 5e4 Pa; 5e-4 m RMS for the one of 1e5 Pa and 1e3 kg/m.
    CHECK(Oedometer{}.series_bound(20) < 1e-5);
    const Oedometer heavy{.H = 25, .E = 1e5, .rho = 1e3};
    double squares = 0;
    const int points = 1000;
    for (int i = 0; i < points; ++i) {
        const double y = (i + 0.5) / points * heavy.H;
        squares += std::pow(heavy.series(y, y, 0.5, 20).displacement - heavy.displacement(y, 0.5), 2);
    }
    CHECK(std::sqrt(squares / points) == Approx(5e-4).epsilon(0.1));
    CHECK(heavy.strain(0, 0.5) == Approx(-0.4905).epsilon(1e-14));  // g t / c
    // Above the front the column falls freely.
    CHECK(heavy.displacement(10, 0.5) == Approx(-9.81 * 0.125).epsilon(1e-15));
}

TEST_CASE("oedometer: a period, and the long ramp's end at rest in the static state", "[gate]") {
    for (auto column : columns()) {
        const double period = 4 * column.H / column.wave_speed();
        const BarMotion motion = motion_of(column);
        const double scale = largest(motion, motion.displacement);
        for (const double y : bar_places) {
            const double t = column.ramp + 0.321 * period;
            const double later = t + 1000 * period;
            CHECK(std::abs(column.displacement(y * column.H, later) - column.displacement(y * column.H, t)) <=
                  motion.accuracy(later) * scale);
        }
    }
    Oedometer slow{.H = 1.3, .E = 8, .rho = 2, .g = 2.1};
    slow.ramp = 400 * slow.H / slow.wave_speed();
    for (const double y : bar_places) {
        const double X = y * slow.H;
        const double rest = slow.rho * slow.g / slow.E * X * (X / 2 - slow.H);
        // The jump of r''' at the ends, 60 / T^3, is all that excites: modes of 60 / (omega_1 T)^3 of the static state.
        CHECK(std::abs(slow.displacement(X, 1.1 * slow.ramp) / rest - 1) < 2 * 60 / std::pow(400 * pi / 2, 3) * 1.3);
    }
}

TEST_CASE("oedometer: means over cells are integrals of the fields", "[gate]") {
    for (auto column : columns()) {
        const BarMotion motion = motion_of(column);
        const Row scale{largest(motion, motion.displacement), largest(motion, motion.velocity),
                        largest(motion, motion.stress), largest(motion, motion.strain)};
        for (const int terms : {0, 5}) {
            column.terms = terms;
            const Exact exact = bound_column(given_by(column));
            for (const double share : {0.21147, 1.30671, 2.43317, 3.31907, 12.83011}) {
                const double t = share * motion.transit();
                const auto at = [&](double X) { return row_at(exact, X, t); };
                const auto mean = [&](double a, double b) { return mean_over(exact, a, b, t); };
                const auto places = terms == 0 ? front_places(motion, t) : std::vector<double>{};
                const Defect defect = bar_averages(column.H, places, scale, motion.accuracy(t), at, mean);
                INFO(name_of(column) << ", terms " << terms << ": defect " << defect.found << ", allowed "
                                     << defect.allowed);
                CHECK(defect.holds());
                const auto wrong = [&](double a, double b) { return at((a + b) / 2); };
                CHECK_FALSE(bar_averages(column.H, places, scale, motion.accuracy(t), at, wrong).holds());
            }
        }
    }
}

TEST_CASE("oedometer: the catalogue entry binds the same numbers, says its jumps and constants", "[unit]") {
    for (const auto& column : columns()) {
        const Exact exact = bound_column(given_by(column));
        for (const double share : bar_times) {
            const double t = share * column.H / column.wave_speed(), y = 0.38541 * column.H;
            CHECK(row_at(exact, y, t) == Row{column.displacement(y, t) + 0.0, column.velocity(y, t) + 0.0,
                                             column.stress(y, t) + 0.0, column.strain(y, t) + 0.0});
            CHECK(exact.jumps(t).size() == (column.p0 != 0 ? 1 : 0));
        }
        CHECK(exact.jumps(0).empty());
        CHECK(exact.constants(0.25).size() == 6);
    }
    CHECK_THROWS_WITH(bound_column({{"ramp", 1e6}}),
                      ContainsSubstring("oracle oedometer: ramp = 1e+06 s") && ContainsSubstring("at most 1e4"));
    CHECK_THROWS_WITH(bound_column({{"E", 1e300}, {"rho", 1e-300}}), ContainsSubstring("wave speed"));
    CHECK_THROWS_WITH(bound_column({{"g", -1.0}}), ContainsSubstring("'g' is -1"));
    CHECK_THROWS_WITH(bound_column({{"terms", -1.0}}), ContainsSubstring("'terms' is -1"));
    CHECK_THROWS_WITH(bound_column({{"p0", 1e308}}), ContainsSubstring("p0 is out of the range"));
}

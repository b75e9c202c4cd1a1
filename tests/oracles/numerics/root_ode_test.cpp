#include <array>
#include <cmath>

#include "oracles/numerics/ode.hpp"
#include "oracles/numerics/root.hpp"
#include "tests/catch.hpp"

using namespace ordo::oracles;

TEST_CASE("bracketed_root: to the last bits, from either side", "[unit]") {
    for (const double wanted : {1e-12, 0.3, 2.0, 5e7}) {
        const auto f = [wanted](double x) { return x * x * x - wanted * wanted * wanted; };
        CHECK(bracketed_root(f, 0, 1e8) == Approx(wanted).epsilon(4e-16));
        CHECK(bracketed_root([&](double x) { return -f(x); }, 0, 1e8) == Approx(wanted).epsilon(4e-16));
    }
    CHECK(bracketed_root([](double x) { return std::cos(x); }, 1, 2) == Approx(std::acos(0.0)).epsilon(2e-16));
    // A wall: no slope on either side of the change of sign.
    CHECK(bracketed_root([](double x) { return x < 0.7 ? -1.0 : 1.0; }, 0, 1) == Approx(0.7).epsilon(4e-16));
}

TEST_CASE("bracketed_root: a zero at an end is that end; no change of sign is NaN", "[unit]") {
    CHECK(bracketed_root([](double x) { return x - 1; }, 1, 2) == 1);
    CHECK(bracketed_root([](double x) { return x - 2; }, 1, 2) == 2);
    CHECK(std::isnan(bracketed_root([](double x) { return x * x + 1; }, -1, 1)));
    CHECK(std::isnan(bracketed_root([](double) { return std::nan(""); }, -1, 1)));
    CHECK(std::isnan(bracketed_root([](double x) { return x > 0 ? std::nan("") : -1.0; }, -1, 1)));
}

TEST_CASE("Ode: an oscillator keeps its phase, forwards and backwards", "[unit]") {
    auto oscillator = [](double, const double* y, double* slopes) {
        slopes[0] = y[1];
        slopes[1] = -y[0];
    };
    for (const double end : {3.0, -3.0}) {
        Ode ode(oscillator, 2, end > 0 ? 1e-3 : -1e-3, 1e-14);
        std::array y{0.0, 1.0};
        double x = 0;
        for (const double stop : {0.5 * end, 0.5 * end, end}) {  // the second time, nothing is left to do
            CHECK(ode.advance(x, stop, y));
            CHECK(x == stop);
            CHECK(y[0] == Approx(std::sin(stop)).margin(1e-13));
            CHECK(y[1] == Approx(std::cos(stop)).margin(1e-13));
        }
    }
}

TEST_CASE("Ode: what cannot be integrated is said, not hung upon", "[unit]") {
    // y' = y^2 from 1 is infinite at x = 1.
    auto blow_up = [](double, const double* y, double* slopes) { slopes[0] = y[0] * y[0]; };
    Ode ode(blow_up, 1, 1e-3, 1e-10);
    std::array y{1.0};
    double x = 0;
    CHECK(ode.advance(x, 0.5, y));
    CHECK(y[0] == Approx(2).epsilon(1e-8));
    CHECK(!ode.advance(x, 2, y));
    CHECK(x < 1.001);
    double at = 0;
    std::array two{1.0, 1.0};
    CHECK(!Ode(blow_up, 1, 1e-3, 1e-10).advance(at, 1, two));
    CHECK(!Ode(blow_up, 1, 1e-3, 1e-10).advance(at, std::nan(""), y));
    auto not_a_number = [](double, const double*, double* slopes) { slopes[0] = std::nan(""); };
    CHECK(!Ode(not_a_number, 1, 1e-3, 1e-10).advance(at, 1, y));
}

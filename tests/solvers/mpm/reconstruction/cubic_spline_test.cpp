#include "solvers/mpm/reconstruction/cubic_spline.hpp"

#include <cmath>

#include "tests/catch.hpp"

using namespace ordo::solvers::mpm;

namespace {

const std::vector<double> uneven{-1.3, -0.9, -0.2, 0.1, 0.75, 1.6, 1.9};

template <class F>
CubicSpline through(const std::vector<double>& x, F f) {
    std::vector<double> values;
    for (const double at : x) values.push_back(f(at));
    CubicSpline spline;
    spline.fit(x, values);
    return spline;
}

}  // namespace

TEST_CASE("cubic spline: it passes through its points, asked in any order", "[unit]") {
    const auto f = [](double x) { return std::sin(2 * x) + 0.1 * x; };
    const auto spline = through(uneven, f);
    for (const std::size_t k : {0, 6, 3, 5, 1, 2, 4}) CHECK(spline(uneven[k]) == Approx(f(uneven[k])).epsilon(1e-14));
}

TEST_CASE("cubic spline: a cubic is met exactly, also beyond the ends", "[unit]") {
    const auto cubic = [](double x) { return 1 - 2 * x + 0.5 * x * x + 3 * x * x * x; };
    for (const std::size_t count : {4, 5, 7}) {
        const std::vector<double> x(uneven.begin(), uneven.begin() + static_cast<long>(count));
        const auto spline = through(x, cubic);
        for (double at = x.front() - 0.3; at < x.back() + 0.3; at += 0.07)
            CHECK(spline(at) == Approx(cubic(at)).margin(1e-12));
    }
    const auto quartic = through(uneven, [](double x) { return x * x * x * x; });
    CHECK(std::abs(quartic(0.4) - 0.0256) > 1e-3);  // and no more than a cubic
}

TEST_CASE("cubic spline: two derivatives are continuous at a knot, the third is at the outer ones", "[unit]") {
    const auto spline = through(uneven, [](double x) { return std::exp(x); });
    // Taylor coefficients of the two cubics that meet at a knot, by differences that are exact for cubics.
    const double e = 0.01;
    const auto third = [&](double x, double side) {
        const double s = side * e;
        return (spline(x + 3 * s) - 3 * spline(x + 2 * s) + 3 * spline(x + s) - spline(x)) / (s * s * s);
    };
    const auto second = [&](double x, double side) {
        const double s = side * e;
        return (spline(x + 2 * s) - 2 * spline(x + s) + spline(x)) / (s * s) - s * third(x, side);
    };
    const auto first = [&](double x, double side) {
        const double s = side * e;
        return (spline(x + s) - spline(x)) / s - 0.5 * s * second(x, side) - s * s / 6 * third(x, side);
    };
    for (std::size_t k = 1; k + 1 < uneven.size(); ++k) {
        CHECK(first(uneven[k], 1) == Approx(first(uneven[k], -1)).epsilon(1e-10));
        CHECK(second(uneven[k], 1) == Approx(second(uneven[k], -1)).epsilon(1e-7));  // round-off over e^2
        const bool not_a_knot = k == 1 || k + 2 == uneven.size();
        const double jump = std::abs(third(uneven[k], 1) - third(uneven[k], -1));
        if (not_a_knot) CHECK(jump < 1e-6);
        else CHECK(jump > 1e-2);
    }
}

TEST_CASE("cubic spline: the error of a smooth function falls as h^4", "[convergence]") {
    const auto error = [](int cells) {
        std::vector<double> x;
        for (int k = 0; k <= cells; ++k) x.push_back(double(k) / cells);
        const auto spline = through(x, [](double s) { return std::sin(5 * s); });
        double most = 0;
        for (double s = 0; s <= 1; s += 1.0 / 1024) most = std::max(most, std::abs(spline(s) - std::sin(5 * s)));
        return most;
    };
    CHECK(std::log2(error(32) / error(64)) == Approx(4).margin(0.2));
    CHECK(std::log2(error(64) / error(128)) == Approx(4).margin(0.1));
}

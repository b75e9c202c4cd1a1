#include "solvers/mpm/reconstruction/least_squares.hpp"

#include <cmath>
#include <random>

#include "solvers/instruction_set.hpp"
#include "tests/catch.hpp"

using namespace ordo::solvers::mpm;

namespace {

/// 40 rising places on about (0, 10), a quarter apart but for a random part.
std::vector<double> scattered() {
    std::mt19937 bits(3);
    std::uniform_real_distribution<double> any(-0.1, 0.1);
    std::vector<double> x;
    for (int k = 0; k < 40; ++k) x.push_back(0.25 * (k + 0.5) + any(bits));
    return x;
}

double value(const MovingLeastSquares& mls, const std::vector<double>& x, int power) {
    double sum = 0;
    const auto [first, last] = mls.window(0);
    for (std::size_t p = first; p < last; ++p) sum += mls.weight(0, p) * std::pow(x[p], power);
    return sum;
}

bool fit(MovingLeastSquares& mls, std::span<const double> x, double at, double radius, std::size_t fewest) {
    return mls.fit(x, std::span(&at, 1), radius, fewest);
}

}  // namespace

TEST_CASE("least squares: polynomials of the degree are met exactly, amid and at the ends", "[unit]") {
    const auto x = scattered();
    const int degree = GENERATE(1, 2, 3, 4, 5, 6);
    MovingLeastSquares mls(degree);
    const auto fewest = static_cast<std::size_t>(degree + 2);
    for (const double at : {0.0, 0.1, 3.3, 5.0, 9.9, 10.0}) {
        REQUIRE(fit(mls, x, at, 0.375 * (degree + 1.5), fewest));
        for (int power = 0; power <= degree; ++power) {
            const double scale = std::pow(10, power);  // powers of the local coordinate would be smaller
            CHECK(std::abs(value(mls, x, power) - std::pow(at, power)) < 1e-10 * scale);
        }
    }
    REQUIRE(fit(mls, x, 5.0, 0.375 * (degree + 1.5), fewest));
    CHECK(std::abs(value(mls, x, degree + 1) - std::pow(5, degree + 1)) > 1e-7);
}

TEST_CASE("least squares: the weights are those of the normal equations, with the cubic kernel", "[unit]") {
    // Degree 1 about `at`: phi_k = w_k (S2 - S1 s_k) / (S0 S2 - S1^2) with moments S_n = sum w s^n.
    const auto x = scattered();
    const double at = 4.3;
    const double radius = 0.9;
    MovingLeastSquares mls(1);
    REQUIRE(fit(mls, x, at, radius, 2));
    const auto w = [&](std::size_t k) {
        const double r = std::abs(x[k] - at) / radius;
        return r <= 0.5 ? 2.0 / 3 - 4 * r * r + 4 * r * r * r
               : r < 1  ? 4.0 / 3 - 4 * r + 4 * r * r - 4.0 / 3 * r * r * r
                        : 0;
    };
    double S0 = 0, S1 = 0, S2 = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        S0 += w(k);
        S1 += w(k) * (x[k] - at);
        S2 += w(k) * (x[k] - at) * (x[k] - at);
    }
    for (std::size_t k = 0; k < x.size(); ++k) {
        const bool inside = k >= mls.window(0).first && k < mls.window(0).last;
        const double expected = w(k) * (S2 - S1 * (x[k] - at)) / (S0 * S2 - S1 * S1);
        CHECK((inside ? mls.weight(0, k) : 0) == Approx(expected).margin(1e-13));
    }
}

TEST_CASE("least squares: places may come in any order", "[unit]") {
    const auto x = scattered();
    MovingLeastSquares any_order(2);
    const std::vector<double> places{9.0, 0.5, 4.0, 3.9, 9.9, 0.0};
    REQUIRE(any_order.fit(x, places, 1, 4));
    for (std::size_t k = 0; k < places.size(); ++k) {
        MovingLeastSquares fresh(2);
        REQUIRE(fit(fresh, x, places[k], 1, 4));
        const auto [first, last] = fresh.window(0);
        CHECK((any_order.window(k).first == first && any_order.window(k).last == last));
        for (std::size_t p = first; p < last; ++p) CHECK(any_order.weight(k, p) == fresh.weight(0, p));
    }
}

TEST_CASE("least squares: a widened window has the same weights alone and beside a wider one", "[unit]") {
    // About 9 the window is widened to 2, 10 and 11, with a radius that reaches 1; its neighbour's holds 1.
    const std::vector<double> x{0, 1, 2, 10, 11};
    const std::vector<double> places{1.5, 9};
    MovingLeastSquares both(1), alone(1);
    REQUIRE(both.fit(x, places, 1, 3));
    REQUIRE(fit(alone, x, 9, 1, 3));
    CHECK((both.window(1).first == 2 && both.window(1).last == 5));
    for (std::size_t p = 2; p < 5; ++p) CHECK(both.weight(1, p) == alone.weight(0, p));
    CHECK(both.weight(1, 1) == 0);
    std::vector<double> out(2);
    both.sample(x, out);
    CHECK(out[1] == Approx(9).epsilon(1e-14));
}

TEST_CASE("least squares: one object takes other particles, more and fewer of them", "[unit]") {
    const auto x = scattered();
    MovingLeastSquares used(3);
    for (const std::size_t count : {40, 12, 33}) {
        const std::span<const double> some(x.data(), count);
        const std::vector<double> places{0.3, 1.1, 1.9, 2.9};
        MovingLeastSquares fresh(3);
        REQUIRE(used.fit(some, places, 1.5, 5));
        REQUIRE(fresh.fit(some, places, 1.5, 5));
        std::vector<double> out(4), expected(4);
        used.sample(some, out);
        fresh.sample(some, expected);
        CHECK(out == expected);
        for (std::size_t k = 0; k < 4; ++k) CHECK(out[k] == Approx(places[k]).epsilon(1e-12));
    }
}

TEST_CASE("least squares: sums are those of the weights, with each set of instructions", "[unit]") {
    const auto x = scattered();
    std::vector<double> f, places;
    for (const double at : x) f.push_back(std::sin(3 * at));
    for (int k = 0; k < 19; ++k) places.push_back(0.2 + 0.5 * k);  // two groups of eight and three more
    for (const std::string set : {"baseline", "avx2", "avx512"}) {
        if (set == "avx2" && !ordo::solvers::has(ordo::solvers::InstructionSet::avx2)) continue;
        if (set == "avx512" && !ordo::solvers::has(ordo::solvers::InstructionSet::avx512)) continue;
        setenv("ORDO_SIMD", set.c_str(), 1);
        MovingLeastSquares mls(4);
        REQUIRE(mls.fit(x, places, 1.4, 6));
        std::vector<double> out(places.size() + 1, -7);
        mls.sample(f, std::span(out).first(places.size()));
        for (std::size_t k = 0; k < places.size(); ++k) {
            double sum = 0;
            const auto [first, last] = mls.window(k);
            for (std::size_t p = first; p < last; ++p) sum += mls.weight(k, p) * f[p];
            CHECK(out[k] == sum);  // outside the window 0 is added
        }
        CHECK(out.back() == -7);
    }
    unsetenv("ORDO_SIMD");
}

TEST_CASE("least squares: a window too narrow is widened to the nearest, and too few are told", "[unit]") {
    const std::vector<double> x{0, 1, 2, 10, 11};
    MovingLeastSquares mls(1);
    REQUIRE(fit(mls, x, 9, 0.1, 3));
    CHECK((mls.window(0).first == 2 && mls.window(0).last == 5));  // 2, 10 and 11
    CHECK(value(mls, x, 0) == Approx(1));
    CHECK(value(mls, x, 1) == Approx(9));
    CHECK_FALSE(fit(mls, x, 9, 0.1, 6));
    const std::vector<double> one_place(4, 2.0);
    MovingLeastSquares coincident(1);
    CHECK_FALSE(fit(coincident, one_place, 2, 1, 2));  // no slope to be had
}

TEST_CASE("least squares: a place has the same weights alone and beside others, with each set of instructions",
          "[unit]") {
    const auto x = scattered();
    const int degree = GENERATE(1, 2, 3, 4, 5, 6);
    const double radius = 0.375 * (degree + 1.5);
    const std::vector<double> places{0.1, 0.7, 1.2, 1.3, 2, 2.5, 2.6, 3.1};
    for (const std::string set : {"baseline", "avx2", "avx512"}) {
        if (set == "avx2" && !ordo::solvers::has(ordo::solvers::InstructionSet::avx2)) continue;
        if (set == "avx512" && !ordo::solvers::has(ordo::solvers::InstructionSet::avx512)) continue;
        setenv("ORDO_SIMD", set.c_str(), 1);
        MovingLeastSquares all(degree);
        REQUIRE(all.fit(x, places, radius, 4));
        setenv("ORDO_SIMD", "baseline", 1);
        for (std::size_t k = 0; k < places.size(); ++k) {
            MovingLeastSquares one(degree);
            REQUIRE(fit(one, x, places[k], radius, 4));
            const auto [first, last] = one.window(0);
            REQUIRE((all.window(k).first == first && all.window(k).last == last));
            for (std::size_t p = first; p < last; ++p) CHECK(all.weight(k, p) == one.weight(0, p));
        }
    }
    unsetenv("ORDO_SIMD");
}

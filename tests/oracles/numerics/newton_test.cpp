#include "oracles/numerics/newton.hpp"

#include <cmath>
#include <limits>

#include "tests/catch.hpp"

using namespace ordo::oracles;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("newton_root: the root to the last digits, from either side and from a bad start", "[unit]") {
    const auto square = [](double x) { return ValueAndSlope{x * x - 2, 2 * x}; };
    for (const double start : {1e-8, 0.5, 1.4, 3.0, 1e8, -7.0, std::nan("")})
        CHECK(newton_root(square, 1e-9, 1e9, start, 0) == Approx(std::sqrt(2.0)).epsilon(1e-15));
    CHECK(newton_root(square, 0, infinity, 5, 0) == Approx(std::sqrt(2.0)).epsilon(1e-15));
}

TEST_CASE("newton_root: steps that leave the bracket are halved, over decades too", "[unit]") {
    // Newton's own steps run away from the root of atan when they start far off.
    const auto angle = [](double x) { return ValueAndSlope{std::atan(x - 3), 1 / (1 + (x - 3) * (x - 3))}; };
    CHECK(newton_root(angle, -1000, 1000, 900, 0) == Approx(3).epsilon(1e-15));
    const auto root = [](double x) { return ValueAndSlope{std::sqrt(x) - 1e-100, 0.5 / std::sqrt(x)}; };
    CHECK(newton_root(root, 1e-300, 1e300, 1e299, 0) == Approx(1e-200).epsilon(1e-15));
}

TEST_CASE("newton_root: noise ends it, NaN is handed on", "[unit]") {
    int calls = 0;
    const auto noisy = [&](double x) {
        ++calls;
        return ValueAndSlope{x - 1, 1};
    };
    CHECK(newton_root(noisy, 0, 2, 1 + 1e-3, 1e-2) == 1 + 1e-3);
    CHECK(calls == 1);
    CHECK(std::isnan(newton_root([](double) { return ValueAndSlope{std::nan(""), 1}; }, 0, 2, 1, 0)));
}

TEST_CASE("newton_root: a slope beyond all doubles is no step of length zero", "[unit]") {
    const auto steep = [](double x) { return ValueAndSlope{std::log(x / 1e-100), x < 1e-200 ? infinity : 1 / x}; };
    CHECK(newton_root(steep, 1e-300, 1, 1e-300, 0) == Approx(1e-100).epsilon(1e-14));
}

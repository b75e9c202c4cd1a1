#include "solvers/mpm/composition.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/catch.hpp"

using namespace ordo::solvers::mpm;

namespace {

/// Distance after t = 1 of the composed x'' = -sin x from a run of so fine steps that its error is round-off.
double pendulum_error(const Composition& scheme, int steps) {
    const auto run = [](const Composition& composed, int count) {
        double x = 1.2;
        double v = 0.3;
        for (int k = 0; k < count; ++k) {
            for (std::size_t stage = 0;; ++stage) {
                x += composed.drift[stage] / count * v;
                if (stage == composed.kick.size()) break;
                v -= composed.kick[stage] / count * std::sin(x);
            }
        }
        return std::pair{x, v};
    };
    static const auto [x, v] = run(yoshida6(), 512);  // 1e-6 of the error at 48 steps
    const auto [a, b] = run(scheme, steps);
    return std::hypot(a - x, b - v);
}

double sum(const std::vector<double>& shares) { return std::accumulate(shares.begin(), shares.end(), 0.0); }

}  // namespace

TEST_CASE("composition: shares add up to the whole step and are symmetric", "[unit]") {
    for (const auto& scheme : {leapfrogs({1}), yoshida4(), yoshida6()}) {
        REQUIRE(scheme.drift.size() == scheme.kick.size() + 1);
        CHECK(sum(scheme.drift) == Approx(1).epsilon(1e-14));
        CHECK(sum(scheme.kick) == Approx(1).epsilon(1e-14));
        for (std::size_t k = 0; k < scheme.kick.size(); ++k)
            CHECK(scheme.kick[k] == Approx(scheme.kick[scheme.kick.size() - 1 - k]).epsilon(1e-14));
        for (std::size_t k = 0; k < scheme.drift.size(); ++k)
            CHECK(scheme.drift[k] == Approx(scheme.drift[scheme.drift.size() - 1 - k]).epsilon(1e-14));
    }
    CHECK((yoshida4().kick.size() == 3 && yoshida6().kick.size() == 7));
}

TEST_CASE("composition: the conditions of the next orders hold", "[unit]") {
    // A composition of leapfrogs w_j has order 4 where sum w^3 = 0, and 6 where sum w^5 = 0 too and a fourth condition
    // holds, which the pendulum tells.   [Yoshida1990]
    const auto powers = [](const Composition& scheme, int n) {
        double total = 0;
        for (const double w : scheme.kick) total += std::pow(w, n);
        return total;
    };
    CHECK(std::abs(powers(yoshida4(), 3)) < 1e-14);
    CHECK(std::abs(powers(yoshida6(), 3)) < 1e-13);  // 15 digits are printed
    CHECK(std::abs(powers(yoshida6(), 5)) < 1e-13);
    CHECK(std::abs(powers(yoshida4(), 5)) > 1);
}

TEST_CASE("composition: a pendulum shows orders 2, 4 and 6", "[convergence]") {
    for (const auto& [scheme, order, steps] :
         {std::tuple{leapfrogs({1}), 2, 32}, {yoshida4(), 4, 32}, {yoshida6(), 6, 12}}) {
        const double coarse = pendulum_error(scheme, steps);
        const double fine = pendulum_error(scheme, 2 * steps);
        CAPTURE(order, coarse, fine);
        CHECK(std::log2(coarse / fine) == Approx(order).margin(0.1));
    }
}

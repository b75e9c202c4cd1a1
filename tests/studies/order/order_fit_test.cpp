#include "studies/order/order_fit.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tests/catch.hpp"

using namespace ordo::studies;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

using Points = std::vector<FitPoint>;

/// Errors at `first`, `first` / ratio, ... : `count` points.
Points line(double first, double ratio, int count, const std::function<double(double)>& error) {
    Points points;
    for (int k = 0; k < count; ++k) {
        const double h = first / std::pow(ratio, k);
        points.push_back({h, error(h)});
    }
    return points;
}

OrderFit fitted(const Points& points) {
    const FitOutcome outcome = fit_order(points);
    INFO(outcome.reason);
    REQUIRE(outcome.fit.has_value());
    CHECK(outcome.refusal == Refusal::none);
    return *outcome.fit;
}

/// Why the points were refused.
std::string refusal(const Points& points) {
    const FitOutcome outcome = fit_order(points);
    CHECK_FALSE(outcome.fit.has_value());
    CHECK(outcome.verdict == (outcome.refusal == Refusal::none ? Convergence::stalled : Convergence::invalid));
    return outcome.reason;
}

/// A sound wave that meets its floor: 128 to 8192 cells, formal order 2.   github.com/quokka-astro/quokka/issues/1203
Points sound_wave() {
    return {{1.0 / 128, 5.029443e-09},  {1.0 / 256, 1.028798e-09},  {1.0 / 512, 1.842775e-10},
            {1.0 / 1024, 4.611129e-11}, {1.0 / 2048, 1.256730e-11}, {1.0 / 4096, 6.526699e-12},
            {1.0 / 8192, 5.722152e-12}};
}

/// Lines that have broken order estimators, and the right answer.
struct Line {
    std::string name;
    Points points;
    Convergence verdict;
    double order;                  ///< inside the interval
    double lowest, highest, last;  ///< neighbour orders
};

std::vector<Line> torture_set() {
    using enum Convergence;
    const auto parabola = [](double h) { return h * h / 2; };
    return {{"h^2/2, ratio 2", line(0.5, 2, 6, parabola), converges, 2, 2, 2, 2},
            {"h^2/2, ratio 10", line(0.5, 10, 6, parabola), converges, 2, 2, 2, 2},
            {"h^2/2, ratio 1.5", line(0.5, 1.5, 6, parabola), converges, 2, 2, 2, 2},
            {"floor", line(1.0 / 16, 2, 8, [](double h) { return h * h + 1e-6; }), converges, 2, 0.66, 2.00, 0.66},
            {"late asymptotics", line(0.25, 2, 7, [](double h) { return 2 * h * h + 100 * std::pow(h, 4); }), converges,
             2, 2.00, 3.21, 2.00},
            {"error changes sign", line(0.25, 2, 6, [](double h) { return std::abs(h - 7 * h * h); }), inconclusive, 1,
             -1.17, 3.59, 0.91},
            {"diverges", line(0.5, 2, 6, [](double h) { return 1e-3 / h; }), diverges, -1, -1, -1, -1},
            {"front between cells",
             line(1.0 / 16, 2, 7, [](double h) { return h * (1 + 0.3 * std::sin(5 * std::log(h))); }), inconclusive, 1,
             0.13, 1.85, 1.05}};
}

}  // namespace

TEST_CASE("order fit: a sound wave that meets its floor has order 2 in its interval", "[unit]") {
    const FitOutcome outcome = fit_order(sound_wave());
    const OrderFit fit = fitted(sound_wave());
    const std::vector<double> neighbours{2.289, 2.481, 1.999, 1.875, 0.945, 0.190};
    REQUIRE(fit.neighbours.size() == neighbours.size());
    for (std::size_t k = 0; k < neighbours.size(); ++k) CHECK(fit.neighbours[k] == Approx(neighbours[k]).margin(6e-4));
    CHECK(outcome.verdict == Convergence::converges);
    CHECK((fit.low < 2 && 2 < fit.high));
    CHECK(fit.high - fit.low < 1);
    CHECK(fit.model == ErrorModel::power_and_floor);
    CHECK(fit.floor == Approx(5.5e-12).epsilon(0.05));  // "about 5.5e-12"
    // The same model by an independent fit with relative weights: p = 2.354, f = 5.29e-12, A = 4.6e-4.
    CHECK(fit.order == Approx(2.354).margin(3e-3));
    CHECK(fit.floor == Approx(5.29e-12).epsilon(2e-3));
    CHECK(fit.coefficient == Approx(4.6e-4).epsilon(0.02));
}

TEST_CASE("order fit: lines that have broken other estimators", "[unit]") {
    for (const auto& [name, points, verdict, order, lowest, highest, last] : torture_set()) {
        INFO(name);
        const OrderFit fit = fitted(points);
        CHECK(text_of(fit_order(points).verdict) == text_of(verdict));
        CHECK((fit.low <= order + 1e-6 && order - 1e-6 <= fit.high));
        if (verdict == Convergence::converges) CHECK(fit.order == Approx(order).margin(1e-3));
        CHECK(*std::min_element(fit.neighbours.begin(), fit.neighbours.end()) == Approx(lowest).margin(6e-3));
        CHECK(*std::max_element(fit.neighbours.begin(), fit.neighbours.end()) == Approx(highest).margin(6e-3));
        CHECK(fit.neighbours.back() == Approx(last).margin(6e-3));
    }
    const OrderFit floor = fitted(torture_set()[3].points);
    CHECK(floor.model == ErrorModel::power_and_floor);
    CHECK(floor.floor == Approx(1e-6).epsilon(1e-6));
    const OrderFit late = fitted(torture_set()[4].points);
    CHECK(late.model == ErrorModel::two_powers);
    CHECK(late.second_order == Approx(4).epsilon(1e-4));
    CHECK(late.second_coefficient == Approx(100).epsilon(1e-3));
    CHECK(late.error_at(0.1) == Approx(0.03).epsilon(1e-3));
    // What wavers says so by its interval: wider than the +- 0.1 that a gate asks for.
    for (const std::size_t wavering : {5, 7}) {
        const OrderFit fit = fitted(torture_set()[wavering].points);
        CHECK(fit.high - fit.order > 0.1);
        CHECK(fit.order - fit.low > 0.1);
    }
}

TEST_CASE("order fit: few noise-free points whose orders settle have an order and a fair interval", "[unit]") {
    for (const int count : {3, 4, 5, 6}) {
        INFO(count);
        const Points points = line(0.25, 2, count, [](double h) { return h * h * (1 + 0.5 * h); });
        CHECK(fit_order(points).verdict == Convergence::converges);
        const OrderFit fit = fitted(points);
        CHECK((fit.low < 2 && 2 < fit.high));
        CHECK(fit.high - fit.low < 0.4);
    }
}

TEST_CASE("order fit: what is no asymptotic range is called by its name", "[unit]") {
    using enum Convergence;
    const auto verdict = [](const Points& points) { return text_of(fit_order(points).verdict); };
    // One term of order 2, and a floor that takes over after two levels of eight.
    CHECK(verdict(line(1, 2, 8, [](double h) { return h * h + 0.2; })) == text_of(at_floor));
    CHECK(verdict(line(1, 2, 6, [](double h) { return std::pow(h, 0.01); })) == text_of(stalled));
    CHECK(verdict(line(1, 2, 5, [](double h) { return h * h + 0.2; })) == text_of(pre_asymptotic));
    // Linear particles: falling, then growing as cells are crossed more often.
    CHECK(verdict(line(1, 2, 8, [](double h) { return h * h + 1e-3 / h; })) != text_of(converges));
    CHECK_THAT(fit_order(line(1, 2, 5, [](double h) { return h * h + 0.2; })).reason,
               ContainsSubstring("too few") && ContainsSubstring("6 (floor)"));
}

TEST_CASE("order fit: a coarse point that bends the line is left out by its place", "[unit]") {
    // Seven levels on a line with small scatter, and a coarsest point far off it.
    Points points = line(1, 2, 8, [](double h) { return h * h; });
    const std::vector<double> scatter{6, 1.003, 0.998, 1.001, 0.999, 1.002, 0.997, 1.001};
    for (std::size_t k = 0; k < points.size(); ++k) points[k].error *= scatter[k];
    std::reverse(points.begin(), points.end());
    const FitOutcome outcome = fit_order(points);
    REQUIRE(outcome.left_out.size() == 1);
    CHECK(outcome.left_out[0].place == 7);
    CHECK(outcome.fit->order == Approx(2).margin(0.01));
}

TEST_CASE("order fit: a pure power is found to round-off, with its coefficient and its sign", "[unit]") {
    for (const double order : {2.0, 1.0, 0.5, -1.0, 3.7}) {
        for (const double ratio : {2.0, 10.0, 1.5, 1.01}) {
            const OrderFit fit = fitted(line(0.3, ratio, 5, [&](double h) { return 0.4 * std::pow(h, order); }));
            // An ulp in a logarithm of about 10 over a span of 4 ln 1.01 = 0.04 at the least.
            CHECK(fit.order == Approx(order).margin(1e-12));
            // Residuals count as 1e-9 at least: over that span 1e-9 / 0.01 times a factor of about 5.
            CHECK(fit.low == Approx(order).margin(1e-6));
            CHECK(fit.high == Approx(order).margin(1e-6));
            CHECK(fit.coefficient == Approx(0.4).epsilon(1e-11));
            CHECK(fit.correlation == Approx(order > 0 ? 1 : -1).epsilon(1e-11));
        }
    }
}

TEST_CASE("order fit: GSL's regression and Student quantile agree", "[unit]") {
    // Three points: a line and nothing else. Five that do not bend: its slope.
    const std::vector<Points> lines{{{1, 1}, {0.5, 0.3}, {0.2, 0.01}},
                                    {{1, 1}, {0.5, 0.27}, {0.25, 0.06}, {0.125, 0.0161}, {0.0625, 0.0039}}};
    for (const auto& points : lines) {
        std::vector<double> x;
        std::vector<double> y;
        for (const auto& [h, error] : points) {
            x.push_back(std::log(h));
            y.push_back(std::log(error));
        }
        double c0 = 0, c1 = 0, cov00 = 0, cov01 = 0, cov11 = 0, squares = 0;
        gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &c0, &c1, &cov00, &cov01, &cov11, &squares);
        const OrderFit fit = fitted(points);
        CHECK(fit.order == Approx(c1).epsilon(1e-12));
        CHECK(fit.coefficient == Approx(std::exp(c0)).epsilon(1e-11));
        CHECK(fit.correlation == Approx(gsl_stats_correlation(x.data(), 1, y.data(), 1, x.size())).epsilon(1e-12));
        if (points.size() > 3) continue;
        const double width = std::sqrt(cov11) * gsl_cdf_tdist_Pinv(0.975, 1);
        CHECK(fit.high - fit.order == Approx(width).epsilon(1e-8));  // quantiles of the two libraries agree to 1e-9
        CHECK(fit.order - fit.low == Approx(width).epsilon(1e-8));
    }
}

TEST_CASE("order fit: points may come in any order, neighbours follow falling abscissae", "[unit]") {
    const OrderFit sorted = fitted({{1, 8}, {0.5, 4}, {0.25, 1}, {0.125, 0.5}});
    const OrderFit mixed = fitted({{0.25, 1}, {1, 8}, {0.125, 0.5}, {0.5, 4}});
    const std::vector<double> neighbours{1, 2, 1};
    for (std::size_t k = 0; k < 3; ++k) CHECK(sorted.neighbours.at(k) == Approx(neighbours[k]).epsilon(1e-14));
    CHECK(mixed.neighbours == sorted.neighbours);
    CHECK(mixed.order == Approx(sorted.order).epsilon(1e-14));
    CHECK(mixed.high == Approx(sorted.high).epsilon(1e-13));
}

TEST_CASE("order fit: two points give an order and no certainty", "[unit]") {
    const OrderFit fit = fitted({{0.5, 1}, {0.25, 0.125}});
    CHECK(fit.order == Approx(3).epsilon(1e-14));
    CHECK(fit.low == -inf);
    CHECK(fit.high == inf);
    CHECK(fit.neighbours.size() == 1);
}

TEST_CASE("order fit: the real ratio of abscissae is used between neighbours", "[unit]") {
    CHECK(neighbour_order({0.3, 0.09}, {0.1, 0.01}) == Approx(2).epsilon(1e-14));
    CHECK(neighbour_order({1, 1e-3}, {0.5, 2e-3}) == Approx(-1).epsilon(1e-14));
    CHECK(std::isnan(neighbour_order({1, -1}, {0.5, 1})));
    CHECK(std::isnan(neighbour_order({1, std::nan("")}, {0.5, 1})));
    CHECK(std::isnan(neighbour_order({1, 1}, {1, 1})));
}

TEST_CASE("order fit: what has no order is refused by name", "[alarm]") {
    auto zero = line(0.5, 2, 6, [](double h) { return h * h / 2; });
    zero.back().error = 0;
    CHECK_THAT(refusal(zero), ContainsSubstring("zero") && ContainsSubstring("0.015625"));
    auto no_number = line(0.5, 2, 6, [](double h) { return h * h / 2; });
    no_number[3].error = std::nan("");
    CHECK_THAT(refusal(no_number), ContainsSubstring("nan") && ContainsSubstring("0.0625"));
    CHECK_THAT(refusal(line(0.5, 2, 6, [](double) { return 1e-3; })), ContainsSubstring("no convergence"));
    CHECK_THAT(refusal({{1, inf}, {0.5, 1}}), ContainsSubstring("inf"));
    CHECK_THAT(refusal({{1, 2}, {0.5, -1}}), ContainsSubstring("negative"));
    CHECK_THAT(refusal({{1, 1}}), ContainsSubstring("fewer than two points"));
    CHECK_THAT(refusal({}), ContainsSubstring("fewer than two points"));
    CHECK_THAT(refusal({{1, 1}, {0.5, 0.3}, {1, 0.9}}), ContainsSubstring("repeated"));
    for (const double abscissa : {0.0, -0.5, std::nan(""), inf, -inf}) {
        CHECK_THAT(refusal({{1, 1}, {abscissa, 0.3}, {0.25, 0.1}}), ContainsSubstring("not positive"));
    }
}

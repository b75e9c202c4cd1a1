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
    INFO(outcome.refused);
    REQUIRE(outcome.fit.has_value());
    CHECK(outcome.refused.empty());
    return *outcome.fit;
}

/// Why the points were refused.
std::string refusal(const Points& points) {
    const FitOutcome outcome = fit_order(points);
    CHECK_FALSE(outcome.fit.has_value());
    return outcome.refused;
}

/// A sound wave that meets its floor: 128 to 8192 cells, formal order 2.   github.com/quokka-astro/quokka/issues/1203
Points sound_wave() {
    return {{1.0 / 128, 5.029443e-09},  {1.0 / 256, 1.028798e-09},  {1.0 / 512, 1.842775e-10},
            {1.0 / 1024, 4.611129e-11}, {1.0 / 2048, 1.256730e-11}, {1.0 / 4096, 6.526699e-12},
            {1.0 / 8192, 5.722152e-12}};
}

/// Lines that have broken order estimators, with what a sign-keeping log-log fit makes of them.
struct Line {
    std::string name;
    Points points;
    double order;
    double lowest, highest, last;  ///< neighbour orders
};

std::vector<Line> torture_set() {
    const auto parabola = [](double h) { return h * h / 2; };
    return {{"h^2/2, ratio 2", line(0.5, 2, 6, parabola), 2, 2, 2, 2},
            {"h^2/2, ratio 10", line(0.5, 10, 6, parabola), 2, 2, 2, 2},
            {"h^2/2, ratio 1.5", line(0.5, 1.5, 6, parabola), 2, 2, 2, 2},
            {"floor", line(1.0 / 16, 2, 8, [](double h) { return h * h + 1e-6; }), 1.73, 0.66, 2.00, 0.66},
            {"late asymptotics", line(0.25, 2, 7, [](double h) { return 2 * h * h + 100 * std::pow(h, 4); }), 2.29,
             2.00, 3.21, 2.00},
            {"error changes sign", line(0.25, 2, 6, [](double h) { return std::abs(h - 7 * h * h); }), 0.70, -1.17,
             3.59, 0.91},
            {"diverges", line(0.5, 2, 6, [](double h) { return 1e-3 / h; }), -1, -1, -1, -1},
            {"front between cells",
             line(1.0 / 16, 2, 7, [](double h) { return h * (1 + 0.3 * std::sin(5 * std::log(h))); }), 0.96, 0.13, 1.85,
             1.05}};
}

}  // namespace

TEST_CASE("order fit: a sound wave that meets its floor gives the published numbers", "[unit]") {
    const Points all = sound_wave();
    const OrderFit fit = fitted(all);
    CHECK(fit.order == Approx(1.708).margin(5e-4));
    const std::vector<double> neighbours{2.289, 2.481, 1.999, 1.875, 0.945, 0.190};
    REQUIRE(fit.neighbours.size() == neighbours.size());
    for (std::size_t k = 0; k < neighbours.size(); ++k) CHECK(fit.neighbours[k] == Approx(neighbours[k]).margin(6e-4));
    CHECK(fitted({all.begin(), all.begin() + 5}).order == Approx(2.177).margin(5e-4));
    CHECK(fitted({all.end() - 3, all.end()}).order == Approx(0.568).margin(5e-4));
    CHECK(fit.high - fit.order > 0.1);  // the floor shows in the interval
}

TEST_CASE("order fit: lines that have broken other estimators", "[unit]") {
    for (const auto& [name, points, order, lowest, highest, last] : torture_set()) {
        INFO(name);
        const OrderFit fit = fitted(points);
        CHECK(fit.order == Approx(order).margin(6e-3));  // the table's two digits
        CHECK(*std::min_element(fit.neighbours.begin(), fit.neighbours.end()) == Approx(lowest).margin(6e-3));
        CHECK(*std::max_element(fit.neighbours.begin(), fit.neighbours.end()) == Approx(highest).margin(6e-3));
        CHECK(fit.neighbours.back() == Approx(last).margin(6e-3));
        CHECK((fit.low <= fit.order && fit.order <= fit.high));
    }
    // What wavers says so by its interval: wider than the +- 0.1 that a gate asks for.
    for (const std::size_t wavering : {5, 7}) {
        const OrderFit fit = fitted(torture_set()[wavering].points);
        CHECK(fit.high - fit.order > 0.1);
        CHECK(fit.order - fit.low > 0.1);
    }
}

TEST_CASE("order fit: a pure power is found to round-off, with its coefficient and its sign", "[unit]") {
    for (const double order : {2.0, 1.0, 0.5, -1.0, 3.7}) {
        for (const double ratio : {2.0, 10.0, 1.5, 1.01}) {
            const OrderFit fit = fitted(line(0.3, ratio, 5, [&](double h) { return 0.4 * std::pow(h, order); }));
            // An ulp in a logarithm of about 10 over a span of 4 ln 1.01 = 0.04 at the least.
            CHECK(fit.order == Approx(order).margin(1e-12));
            CHECK(fit.low == Approx(order).margin(1e-11));
            CHECK(fit.high == Approx(order).margin(1e-11));
            CHECK(fit.coefficient == Approx(0.4).epsilon(1e-11));
            CHECK(fit.correlation == Approx(order > 0 ? 1 : -1).epsilon(1e-11));
        }
    }
}

TEST_CASE("order fit: GSL's regression and Student quantile agree", "[unit]") {
    auto lines = torture_set();
    lines.push_back({"sound wave", sound_wave(), 0, 0, 0, 0});
    lines.push_back({"three points", {{1, 1}, {0.5, 0.3}, {0.2, 0.01}}, 0, 0, 0, 0});
    for (const auto& each : lines) {
        INFO(each.name);
        std::vector<double> x;
        std::vector<double> y;
        for (const auto& [h, error] : each.points) {
            x.push_back(std::log(h));
            y.push_back(std::log(error));
        }
        double c0 = 0, c1 = 0, cov00 = 0, cov01 = 0, cov11 = 0, squares = 0;
        gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &c0, &c1, &cov00, &cov01, &cov11, &squares);
        const double width = std::sqrt(cov11) * gsl_cdf_tdist_Pinv(0.975, static_cast<double>(x.size()) - 2);
        const OrderFit fit = fitted(each.points);
        CHECK(fit.order == Approx(c1).epsilon(1e-12));
        CHECK(fit.coefficient == Approx(std::exp(c0)).epsilon(1e-11));
        // Quantiles of the two libraries agree to 1e-9; the residuals of exact lines are round-off on both sides.
        CHECK(fit.high - fit.order == Approx(width).epsilon(1e-8).margin(1e-12));
        CHECK(fit.order - fit.low == Approx(width).epsilon(1e-8).margin(1e-12));
        CHECK(fit.correlation == Approx(gsl_stats_correlation(x.data(), 1, y.data(), 1, x.size())).epsilon(1e-12));
    }
}

TEST_CASE("order fit: points may come in any order, neighbours follow falling abscissae", "[unit]") {
    const OrderFit sorted = fitted({{1, 8}, {0.5, 4}, {0.25, 1}, {0.125, 0.5}});
    const OrderFit mixed = fitted({{0.25, 1}, {1, 8}, {0.125, 0.5}, {0.5, 4}});
    CHECK(sorted.neighbours == std::vector<double>{1, 2, 1});
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

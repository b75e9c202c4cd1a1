#include "studies/order/grid_convergence.hpp"

#include <algorithm>
#include <cmath>

#include "tests/catch.hpp"

using namespace ordo::studies;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

using Grids = std::vector<GridValue>;

/// `count` grids from h = 1 by `ratio`.
template <class F>
Grids grids(int count, double ratio, F value) {
    Grids all;
    for (int k = 0; k < count; ++k) all.push_back({std::pow(ratio, -k), value(std::pow(ratio, -k))});
    return all;
}

Extrapolation by(const std::string& method, const Grids& grids, double formal = none) {
    const auto all = extrapolations(grids, formal);
    const auto found = std::ranges::find(all, method, &Extrapolation::method);
    REQUIRE(found != all.end());
    return *found;
}

/// Reattachment behind a step: 18000, 8000 and 4500 cells in two dimensions.   [Celik2008]
Grids celik() { return {{1 / std::sqrt(18000), 6.063}, {1 / std::sqrt(8000), 5.972}, {1 / std::sqrt(4500), 5.863}}; }

/// Pressure recovery on three grids, ratio two.   NASA's tutorial on grid convergence
Grids nasa() { return {{1, 0.970500}, {2, 0.968540}, {4, 0.961780}}; }

}  // namespace

TEST_CASE("grid convergence: the example of Celik et al. to its printed digits", "[published]") {
    const Grids all = celik();
    const double order = Triple{all[2], all[1], all[0]}.order();
    CHECK(order == Approx(1.53).margin(0.005));
    CHECK(richardson(all[0], all[1], order) == Approx(6.1685).margin(5e-5));
    CHECK(100 * gci(all[0], all[1], order, 1.25) == Approx(2.17).margin(0.005));
    CHECK(100 * gci(all[1], all[2], order, 1.25) == Approx(4.11).margin(0.005));
    const double check = gci(all[1], all[2], order, 1.25) / (std::pow(1.5, order) * gci(all[0], all[1], order, 1.25));
    CHECK(check == Approx(1.015).margin(5e-4));
    const auto found = by("GCI", all);
    CHECK(found.safety == 1.25);
    CHECK(found.uncertainty / 6.063 == Approx(0.0217).margin(5e-5));
    CHECK(found.verdict == Convergence::converges);
}

TEST_CASE("grid convergence: NASA's example to its printed digits", "[published]") {
    const Grids all = nasa();
    const auto found = by("Richardson", all);
    CHECK(found.order == Approx(1.786170).margin(5e-7));
    CHECK(found.limit == Approx(0.971300).margin(5e-7));
    CHECK(gci(all[0], all[1], found.order, 1.25) == Approx(0.001031).margin(5e-7));
    CHECK(gci(all[1], all[2], found.order, 1.25) == Approx(0.003562).margin(5e-7));
}

TEST_CASE("grid convergence: a power law is found for any ratios", "[unit]") {
    const auto law = [](double h) { return 3 - 0.5 * std::pow(h, 1.7); };
    for (const Grids& all :
         {grids(3, 2, law), grids(3, 1.1, law), Grids{{1, law(1)}, {0.7, law(0.7)}, {0.1, law(0.1)}}}) {
        const auto found = by("Richardson", all);
        CHECK(found.order == Approx(1.7).epsilon(1e-9));
        CHECK(found.limit == Approx(3).epsilon(1e-11));
    }
    const auto many = grids(6, 1.5, law);
    const auto found = by("Eca-Hoekstra", many);
    CHECK(found.model == "h^p");
    CHECK(found.order == Approx(1.7).epsilon(1e-5));
    CHECK(found.limit == Approx(3).epsilon(1e-6));
    CHECK(found.safety == 1.25);
    CHECK(found.uncertainty == Approx(1.25 * std::abs(law(many.back().h) - 3)).epsilon(1e-3));
    auto mixed = many;
    std::swap(mixed[0], mixed[4]);
    CHECK(by("Eca-Hoekstra", mixed).limit == found.limit);
}

TEST_CASE("grid convergence: below half an order, fixed powers; above two, a factor of three", "[unit]") {
    const auto slow = by("Eca-Hoekstra", grids(5, 2, [](double h) { return 1 + std::pow(h, 0.2); }));
    CHECK(slow.model == "h + h^2");  // it scatters least of the three
    CHECK(slow.safety == 3);
    CHECK(slow.verdict == Convergence::inconclusive);
    const auto steep = by("Eca-Hoekstra", grids(5, 2, [](double h) { return 1 + std::pow(h, 3); }));
    CHECK(steep.model == "h^p");
    CHECK(steep.order == Approx(3).epsilon(1e-4));
    CHECK(steep.safety == 3);
    CHECK_THAT(steep.reason, ContainsSubstring("above 2.1"));
    CHECK(by("GCI", grids(3, 2, [](double h) { return 1 + std::pow(h, 3); }), 3).safety == 1.25);
    CHECK(by("GCI", grids(3, 2, [](double h) { return 1 + std::pow(h, 3); })).safety == 3);
}

TEST_CASE("grid convergence: two grids need a formal order, and are trusted three times less", "[unit]") {
    const Grids two{{1, 4}, {0.5, 1.75}};
    CHECK_THAT(by("GCI", two).reason, ContainsSubstring("no formal order"));
    const auto found = by("GCI", two, 2);
    CHECK(found.limit == Approx(1));
    CHECK(found.safety == 3);
    CHECK(found.uncertainty == Approx(3 * 0.75));
    CHECK(found.verdict == Convergence::inconclusive);
    CHECK(by("Richardson", two, 2).limit == Approx(1));
}

TEST_CASE("grid convergence: values that have no limit are called by their names", "[alarm]") {
    const auto [values, behaviour, word] = GENERATE(table<std::vector<double>, Behaviour, std::string>(
        {{{1, 2, 1.5}, Behaviour::oscillatory, "oscillatory"},
         {{1, 2, 4}, Behaviour::divergent, "divergent"},
         {{1, 2, 3}, Behaviour::divergent, "divergent"},  // as a logarithm
         {{1, 1, 2}, Behaviour::divergent, "divergent"},
         {{1, 2, 2}, Behaviour::equal, "equal"},
         {{2, 2, 2}, Behaviour::equal, "equal"}}));
    CAPTURE(values);
    const Grids all{{4, values[0]}, {2, values[1]}, {1, values[2]}};
    CHECK(Triple{all[0], all[1], all[2]}.behaviour() == behaviour);
    CHECK(text_of(behaviour) == word);
    for (const std::string method : {"Richardson", "GCI"}) {
        const auto found = by(method, all);
        CHECK(found.verdict != Convergence::converges);
        CHECK_THAT(found.reason, ContainsSubstring(word));
        CHECK(std::isnan(found.limit));
        CHECK(std::isnan(found.uncertainty));
    }
    CHECK_THAT(fit_order_of_values(all).reason, ContainsSubstring(word));
}

TEST_CASE("grid convergence: scatter beyond the range of the values is not trusted", "[alarm]") {
    const Grids noisy{{16, 1}, {8, 3}, {4, 0.5}, {2, 2.9}, {1, 1.1}};
    const auto found = by("Eca-Hoekstra", noisy);
    CHECK(found.verdict == Convergence::inconclusive);
    CHECK(found.safety == 3);
    CHECK(found.uncertainty > 1);
    CHECK(by("Eca-Hoekstra", grids(4, 2, [](double) { return 7.0; })).verdict == Convergence::stalled);
}

TEST_CASE("grid convergence: what is no value is refused by name", "[alarm]") {
    const auto [grid, words] = GENERATE(table<GridValue, std::string>({{{0.5, NAN}, "nan"},
                                                                       {{0.5, INFINITY}, "inf"},
                                                                       {{0.0, 1.0}, "not positive"},
                                                                       {{-1.0, 1.0}, "not positive"},
                                                                       {{1.0, 1.5}, "repeated"}}));
    const Grids all{{4, 4}, {2, 2}, {1, 1.2}, grid};
    const auto found = extrapolations(all);
    REQUIRE(found.size() == 1);
    CHECK(found[0].verdict == Convergence::invalid);
    CHECK_THAT(found[0].reason, ContainsSubstring(words));
    CHECK_THAT(fit_order_of_values(all).reason, ContainsSubstring(words));
}

TEST_CASE("grid convergence: the finest level as truth gives a high order, and says so", "[unit]") {
    const auto found = by("finest level", grids(5, 2, [](double h) { return h * h; }));
    CHECK(found.order > 2);
    CHECK(found.limit == 1.0 / 256);
    CHECK_THAT(found.assumes, ContainsSubstring("too high"));
}

TEST_CASE("grid convergence: the order of values has an interval from four grids on", "[unit]") {
    const auto three = fit_order_of_values(nasa());
    REQUIRE(three.fit);
    CHECK(three.fit->order == Approx(1.786170).margin(5e-7));
    CHECK(std::isinf(three.fit->high));
    CHECK(three.fit->coefficient == Approx(0.000800).margin(1e-6));  // 0.9713 - 0.9705 at h = 1
    auto bent = grids(6, 1.5, [](double h) { return 2 + h * h; });
    for (std::size_t k = 0; k < bent.size(); ++k) bent[k].value += k % 2 == 0 ? 1e-4 : -1e-4;
    const auto scattered = fit_order_of_values(bent);
    REQUIRE(scattered.fit);
    CHECK(scattered.fit->low < 2);
    CHECK(scattered.fit->high > 2);
    CHECK(scattered.fit->high - scattered.fit->low < 0.1);
    CHECK(scattered.fit->neighbours.size() == 4);
    CHECK_FALSE(fit_order_of_values({{1, 2}, {2, 3}}).fit.has_value());
}

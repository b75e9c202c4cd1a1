// Smooth flow on a periodic line: the order that the solver claims.
#include <numbers>

#include "tests/solvers/godunov/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::godunov;
using namespace ordo::solvers::godunov::test;

namespace {

double sine(double x) { return std::sin(2 * std::numbers::pi * x); }

/// Mean of sine over [a, b].
double sine_mean(double a, double b) {
    const double k = 2 * std::numbers::pi;
    return (std::cos(k * a) - std::cos(k * b)) / (k * (b - a));
}

/// L1 error of the mean density, once around: the wave 1 + 0.2 sin of density moves with the stream.
double carried(const Given& options, int n) {
    const IdealGas gas;
    const auto scene = periodic_wave(gas, n, [&](double x) { return gas.contents(1 + 0.2 * sine(x), 1, 1); });
    const auto shot = at(scene, 1, options, {{"cells", double(n)}});
    double sum = 0;
    for (std::size_t i = 0; i < shot.points(); ++i) {
        const double exact = 1 + 0.2 * sine_mean(shot.edges[i], shot.edges[i + 1]);
        sum += shot.weights[i] * std::abs(shot.field("density").values[i] - exact);
    }
    return sum;
}

/// L1 distance of the mean densities of n cells from those of 2 n cells, for a sound wave that steepens.
template <class M, class State>
double refined(const M& medium, const Given& options, int n, double t, State state) {
    const auto on = [&](int cells) {
        return at(periodic_wave(medium, cells, state), t, options, {{"cells", double(cells)}}, {"density"});
    };
    const auto coarse = on(n);
    const auto fine = on(2 * n);
    double sum = 0;
    for (std::size_t i = 0; i < coarse.points(); ++i) {
        const auto& rho = fine.field("density").values;
        sum += coarse.weights[i] * std::abs(coarse.field("density").values[i] - 0.5 * (rho[2 * i] + rho[2 * i + 1]));
    }
    return sum;
}

template <class Error>
double order_of(Error error, int n) {
    return std::log2(error(n) / error(2 * n));
}

}  // namespace

TEST_CASE("godunov: a carried wave converges with the claimed order", "[convergence]") {
    const auto order = [](const Given& options) { return order_of([&](int n) { return carried(options, n); }, 128); };
    CHECK(std::abs(order({{"order", "first"}}) - 1) < 0.1);
    // Without limiter the error is a clean h^2; limiters flatten the crests, where it is h^2 over a width of h.
    CHECK(std::abs(order({{"limiter", "central"}}) - 2) < 0.02);
    CHECK(std::abs(order({{"limiter", "mc"}}) - 2) < 0.3);
    CHECK(std::abs(order({{"limiter", "van_leer"}}) - 2) < 0.3);
    CHECK(std::abs(order({{"limiter", "minmod"}}) - 2) < 0.4);
}

TEST_CASE("godunov: sound waves converge with the second order in every medium", "[convergence]") {
    const auto limiter = GENERATE(std::string("central"), std::string("mc"));
    // The error is c h^2 + d h^3, and on 256 cells the second part is a fifth of the first; limited crests add to it.
    const double band = limiter == "central" ? 0.25 : 0.35;
    const Given options{{"limiter", limiter}};
    const auto order = [&](const auto& medium, auto state) {
        return order_of([&](int n) { return refined(medium, options, n, 0.3, state); }, 256);
    };
    const IdealGas gas{5.0 / 3};
    CHECK(std::abs(order(gas, [&](double x) { return gas.contents(1, 0.1 * sine(x), 0.6); }) - 2) < band);
    const auto elastic = [&](const auto& line) {
        return order(line, [&](double x) { return line.contents(1.1, 0.1 * sine(x), 0.5 + 0.1 * sine(x)); });
    };
    CHECK(std::abs(elastic(ElasticMedium<HookeEnergy>{}) - 2) < band);
    CHECK(std::abs(elastic(ElasticMedium<RubberEnergy>{.E = 2, .rho0 = 1.5, .c_v = 0.7, .k = 1}) - 2) < band);
    CHECK(std::abs(elastic(ElasticMedium<ReciprocalEnergy>{.k = 0.5}) - 2) < band);
    CHECK(std::abs(elastic(ElasticMedium<LogarithmicEnergy>{.k = 2}) - 2) < band);
}

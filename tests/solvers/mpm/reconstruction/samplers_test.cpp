#include "solvers/mpm/reconstruction/samplers.hpp"

#include <cmath>

#include "solvers/solver.hpp"
#include "tests/catch.hpp"

using namespace ordo::solvers;
using namespace ordo::solvers::mpm;

namespace {

/// Three cells of width 1/2 from 0 on, particles at centres of equal parts or off them; two places a cell.
struct Line {
    std::vector<double> x, volume, places;
    std::vector<TaylorSampler::Stretch> stretches;

    Line(int ppc, double shift) {
        const double gauss = 0.5 / std::sqrt(3.0);
        for (int cell = 0; cell < 3; ++cell) {
            for (int k = 0; k < ppc; ++k) {
                x.push_back(0.5 * (cell + (k + 0.5) / ppc) + shift * (k % 2 == 0 ? 1 : -0.5));
                volume.push_back(0.5 / ppc);
            }
            stretches.push_back({0.5 * cell, 0.5 * (cell + 1)});
            for (const double xi : {0.5 - gauss, 0.5 + gauss}) places.push_back(0.5 * (cell + xi));
        }
    }
    Layout layout() const { return {x, volume, places}; }
};

template <class F>
std::vector<double> at(const std::vector<double>& x, F f) {
    std::vector<double> values;
    for (const double place : x) values.push_back(f(place));
    return values;
}

template <class Sampler>
std::vector<double> sampled(Sampler& sampler, const std::vector<double>& f, std::size_t places) {
    std::vector<double> out(places, std::nan(""));
    sampler.sample(f, out);
    return out;
}

void check_equal(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    for (std::size_t k = 0; k < a.size(); ++k) CHECK(a[k] == Approx(b[k]).margin(1e-12));
}

const auto quadratic = [](double x) { return 2 - 3 * x + 1.5 * x * x; };

}  // namespace

TEST_CASE("samplers: the spline takes cubics to the places, and field after field", "[unit]") {
    const Line line(2, 0.03);
    SplineSampler spline;
    spline.prepare(line.layout());
    const auto cubic = [](double x) { return x * x * x - x; };
    check_equal(sampled(spline, at(line.x, cubic), 6), at(line.places, cubic));
    check_equal(sampled(spline, at(line.x, quadratic), 6), at(line.places, quadratic));
    const std::vector<double> three{0, 1, 2};
    CHECK_THROWS_AS(spline.prepare({three, three, three}), Diverged);
}

TEST_CASE("samplers: moving least squares takes polynomials of its degree to the places", "[unit]") {
    const Line line(3, 0.02);
    MovingSampler moving(2);
    moving.prepare(line.layout(), 0.8);
    check_equal(sampled(moving, at(line.x, quadratic), 6), at(line.places, quadratic));
    check_equal(sampled(moving, std::vector<double>(9, 4.0), 6), std::vector<double>(6, 4.0));
    const std::vector<double> three{0, 1, 2};
    CHECK_THROWS_AS(moving.prepare({three, three, three}, 1), Diverged);  // degree 2 wants four
}

TEST_CASE("samplers: Taylor least squares keeps the sums of every cell, whatever the field", "[property]") {
    const int ppc = GENERATE(1, 2, 3, 5);
    const Line line(ppc, 0.04);
    TaylorSampler taylor;
    taylor.prepare(line.layout(), line.stretches);
    const auto f = at(line.x, [](double x) { return std::exp(3 * x) * std::sin(40 * x); });
    const auto found = sampled(taylor, f, 6);
    for (std::size_t cell = 0; cell < 3; ++cell) {
        double sum = 0;
        for (std::size_t p = cell * std::size_t(ppc); p < (cell + 1) * std::size_t(ppc); ++p)
            sum += line.volume[p] * f[p];
        CHECK(0.25 * (found[2 * cell] + found[2 * cell + 1]) == Approx(sum).epsilon(1e-13));
    }
}

TEST_CASE("samplers: Taylor least squares meets constants, and linear fields about the cells' centres", "[unit]") {
    const auto linear = [](double x) { return 2 - 3 * x; };
    for (const int ppc : {2, 3, 4}) {
        const Line line(ppc, 0);
        TaylorSampler taylor;
        taylor.prepare(line.layout(), line.stretches);
        check_equal(sampled(taylor, std::vector<double>(line.x.size(), 7.0), 6), std::vector<double>(6, 7.0));
        check_equal(sampled(taylor, at(line.x, linear), 6), at(line.places, linear));
    }
    const Line alone(1, 0);  // one particle a cell: its value
    TaylorSampler taylor;
    taylor.prepare(alone.layout(), alone.stretches);
    check_equal(sampled(taylor, at(alone.x, linear), 6), {1.25, 1.25, -0.25, -0.25, -1.75, -1.75});
}

TEST_CASE("samplers: Taylor least squares meets a quadratic where the particles' mean is the cell's", "[unit]") {
    // Particles at three Gauss points with their weights: the mean of a quadratic is exact.
    Line line(3, 0);
    for (std::size_t cell = 0; cell < 3; ++cell) {
        for (const int side : {-1, 1}) {
            const std::size_t p = 3 * cell + (side < 0 ? 0 : 2);
            line.x[p] = 0.5 * double(cell) + 0.25 * (1 + side * std::sqrt(0.6));
            line.volume[p] = 0.5 * 5 / 18;
        }
        line.volume[3 * cell + 1] = 0.5 * 8 / 18;
    }
    TaylorSampler taylor;
    taylor.prepare(line.layout(), line.stretches);
    check_equal(sampled(taylor, at(line.x, quadratic), 6), at(line.places, quadratic));
}

TEST_CASE("samplers: a cell without particles gets nothing", "[unit]") {
    const Line line(2, 0);
    TaylorSampler taylor;
    const std::vector<double> x{0.125, 0.375, 1.125, 1.375}, volume(4, 0.25);
    taylor.prepare({x, volume, line.places}, line.stretches);
    check_equal(sampled(taylor, std::vector<double>(4, 3.0), 6), {3, 3, 0, 0, 3, 3});
}

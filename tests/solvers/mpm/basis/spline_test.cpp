#include "solvers/mpm/basis/spline.hpp"

#include <cmath>
#include <vector>

#include "tests/catch.hpp"

using namespace ordo::solvers::mpm;

namespace {

/// Spline i of degree d on a full knot vector, by the recursion as it is written in the books; the last span is closed.
double cox_de_boor(const std::vector<double>& t, std::size_t i, std::size_t d, double x) {
    if (d == 0) {
        const bool last = x == t.back() && t[i + 1] == t.back() && t[i] < t[i + 1];
        return (t[i] <= x && x < t[i + 1]) || last ? 1 : 0;
    }
    double sum = 0;
    if (t[i + d] > t[i]) sum += (x - t[i]) / (t[i + d] - t[i]) * cox_de_boor(t, i, d - 1, x);
    if (t[i + d + 1] > t[i + 1])
        sum += (t[i + d + 1] - x) / (t[i + d + 1] - t[i + 1]) * cox_de_boor(t, i + 1, d - 1, x);
    return sum;
}

std::vector<double> clamped_knots(int degree, int cells) {
    std::vector<double> t(static_cast<std::size_t>(degree), 0.0);
    for (int k = 0; k <= cells; ++k) t.push_back(k);
    t.insert(t.end(), static_cast<std::size_t>(degree), cells);
    return t;
}

const std::vector<double> local{0, 0.125, 0.4, 0.5, 0.71, 1};

}  // namespace

TEMPLATE_TEST_CASE_SIG("spline: constants and linear fields come out exactly in every cell", "[unit]",
                       ((int degree), degree), 1, 2, 3, 4) {
    const int cells = GENERATE(1, 2, 3, 4, 9);  // also fewer than the degree
    for (int cell = 0; cell < cells; ++cell) {
        for (const double xi : local) {
            const Spline<degree> spline(cell, xi, cells);
            double one = 0, none = 0, place = 0, unit = 0;
            for (int k = 0; k <= degree; ++k) {
                const auto j = static_cast<std::size_t>(k);
                const double node = greville(cell + k, degree, cells);
                one += spline.value[j];
                none += spline.slope[j];
                place += node * spline.value[j];
                unit += node * spline.slope[j];
                CHECK(spline.value[j] >= 0);
            }
            CHECK(std::abs(one - 1) < 1e-15 * 4);
            CHECK(std::abs(none) < 1e-14);
            CHECK(std::abs(place - cell - xi) < 1e-14);
            CHECK(std::abs(unit - 1) < 1e-13);  // slopes up to degree, nodes up to 9
        }
    }
}

TEMPLATE_TEST_CASE_SIG("spline: values are those of the recursion on the full knot vector, slopes its differences",
                       "[unit]", ((int degree), degree), 1, 2, 3, 4) {
    const int cells = GENERATE(1, 2, 3, 7);
    const auto t = clamped_knots(degree, cells);
    for (int cell = 0; cell < cells; ++cell) {
        for (const double xi : {0.1, 0.35, 0.5, 0.85}) {
            const Spline<degree> spline(cell, xi, cells);
            for (int i = 0; i < cells + degree; ++i) {
                const auto at = [&](double x) { return cox_de_boor(t, static_cast<std::size_t>(i), degree, x); };
                const bool lives = i >= cell && i <= cell + degree;
                const auto k = static_cast<std::size_t>(i - cell);
                CHECK((lives ? spline.value[k] : 0) == Approx(at(cell + xi)).margin(1e-14));
                // Two central differences whose h^2 terms cancel: exact up to degree 4 but for round-off 1e-16 / 0.01.
                const auto difference = [&](double e) { return (at(cell + xi + e) - at(cell + xi - e)) / (2 * e); };
                const double slope = (4 * difference(0.01) - difference(0.02)) / 3;
                CHECK((lives ? spline.slope[k] : 0) == Approx(slope).margin(1e-12));
            }
        }
    }
}

TEST_CASE("spline: far from the ends they are the uniform splines in closed form", "[unit]") {
    const int cells = 12;
    const auto quadratic = [](double r) {
        r = std::abs(r);
        return r <= 0.5 ? 0.75 - r * r : r <= 1.5 ? 0.5 * (1.5 - r) * (1.5 - r) : 0;
    };
    const auto cubic = [](double r) {
        r = std::abs(r);
        return r <= 1 ? 2.0 / 3 - r * r + 0.5 * r * r * r : r <= 2 ? (2 - r) * (2 - r) * (2 - r) / 6 : 0;
    };
    for (const double xi : local) {
        const int cell = 6;
        const Spline<2> two(cell, xi, cells);
        const Spline<3> three(cell, xi, cells);
        for (int k = 0; k <= 2; ++k) {
            const double r = cell + xi - greville(cell + k, 2, cells);
            CHECK(two.value[static_cast<std::size_t>(k)] == Approx(quadratic(r)).margin(1e-15));
        }
        for (int k = 0; k <= 3; ++k) {
            const double r = cell + xi - greville(cell + k, 3, cells);
            CHECK(three.value[static_cast<std::size_t>(k)] == Approx(cubic(r)).margin(1e-15));
        }
        const Spline<1> one(cell, xi, cells);
        CHECK((one.value[0] == 1 - xi && one.value[1] == xi && one.slope[0] == -1 && one.slope[1] == 1));
    }
}

TEMPLATE_TEST_CASE_SIG("spline: the outermost ones interpolate at the ends", "[unit]", ((int degree), degree), 1, 2, 3,
                       4) {
    const int cells = GENERATE(1, 2, 6);
    const Spline<degree> first(0, 0, cells);
    const Spline<degree> last(cells - 1, 1, cells);
    for (int k = 0; k <= degree; ++k) {
        CHECK(first.value[static_cast<std::size_t>(k)] == (k == 0 ? 1 : 0));
        CHECK(last.value[static_cast<std::size_t>(k)] == (k == degree ? 1 : 0));
    }
    CHECK(greville(0, degree, cells) == 0);
    CHECK(greville(cells + degree - 1, degree, cells) == cells);
}

TEMPLATE_TEST_CASE_SIG("spline: degree - 1 derivatives are continuous across a face, and no more", "[unit]",
                       ((int degree), degree), 1, 2, 3, 4) {
    // Polynomials of two neighbouring cells, both taken s beyond the face: their difference is c s^degree.
    const int cells = 7;
    for (int cell = 0; cell + 1 < cells; ++cell) {
        bool jumps = false;
        for (int k = 0; k <= degree + 1; ++k) {  // spline cell + k
            const auto jump = [&](double s) {
                const Spline<degree> left(cell, 1 + s, cells);
                const Spline<degree> right(cell + 1, s, cells);
                const double from_left = k <= degree ? left.value[static_cast<std::size_t>(k)] : 0;
                const double from_right = k >= 1 ? right.value[static_cast<std::size_t>(k - 1)] : 0;
                return from_left - from_right;
            };
            CHECK(jump(0) == Approx(0).margin(1e-15));
            CHECK(jump(0.5) * std::pow(2, degree) == Approx(jump(1)).margin(1e-12));
            CHECK(jump(-0.5) * std::pow(-2, degree) == Approx(jump(1)).margin(1e-12));
            jumps = jumps || std::abs(jump(1)) > 0.01;
        }
        CHECK(jumps);
    }
}

TEST_CASE("spline: the tent of a node and its integral agree", "[unit]") {
    for (double r = -1.9375; r < 2; r += 0.125) {  // midway between the kinks
        CHECK(Tent::value(r) == std::max(0.0, 1 - std::abs(r)));
        // The tent is linear there: the midpoint rule is exact.
        CHECK(Tent::integral(r + 0.0625) - Tent::integral(r - 0.0625) == Approx(0.125 * Tent::value(r)).margin(1e-15));
    }
    CHECK((Tent::integral(-1) == 0 && Tent::integral(1) == 1 && Tent::integral(-7) == 0 && Tent::integral(7) == 1));
}

#pragma once
// B-splines of degree 1 (tents) to 4 on equal cells, clamped at both ends of the grid.
#include <algorithm>
#include <array>

namespace ordo::solvers::mpm {

/// The degree + 1 splines that live in one cell; spline `cell + k` is entry k. The knots are 0, 1, ..., cells with the
/// first and the last repeated `degree` times more, so that the end splines interpolate. A grid has cells + degree of
/// them along an axis. source [DeBoor2001], chapters IX and X
template <int degree>
struct Spline {
    static constexpr int count = degree + 1;
    std::array<double, count> value;
    std::array<double, count> slope;  ///< derivative by x / h

    /// At the local coordinate xi of `cell`; outside [0, 1] the cell's polynomials go on.
    Spline(int cell, double xi, int cells) {
        const bool amid = cell >= degree - 1 && cell <= cells - degree;  // no repeated knot is felt
        if (amid) evaluate(xi, [](int j) { return j; });
        else evaluate(xi, [=](int j) { return std::clamp(cell + j, 0, cells) - cell; });
    }

private:
    /// knot(j): j knots after the cell's first. Where it is j itself all widths are known to the compiler.
    template <class Knot>
    void evaluate(double xi, Knot knot) {
        std::array<double, count> lower{};
        value = {1};
#pragma GCC unroll 4
        for (int d = 1; d <= degree; ++d) {
            lower = value;
            double carried = 0;
#pragma GCC unroll 4
            for (int k = 0; k < d; ++k) {
                const double part = lower[k] / (knot(k + 1) - knot(k + 1 - d));
                value[k] = carried + (knot(k + 1) - xi) * part;
                carried = (xi - knot(k + 1 - d)) * part;
            }
            value[d] = carried;
        }
#pragma GCC unroll 5
        for (int k = 0; k < count; ++k) {
            const double before = k == 0 ? 0 : lower[k - 1] / (knot(k) - knot(k - degree));
            const double after = k == degree ? 0 : lower[k] / (knot(k + 1) - knot(k + 1 - degree));
            slope[k] = degree * (before - after);
        }
    }
};

/// Where a linear field has its coefficient of spline i: the mean of the spline's inner knots, in cells.   [Farin2002]
inline double greville(int i, int degree, int cells) {
    double sum = 0;
    for (int k = 1; k <= degree; ++k) sum += std::clamp(i + k - degree, 0, cells);
    return sum / degree;
}

/// The tent of node 0 at r cells from it, and its antiderivative from r = -1 on.
struct Tent {
    static constexpr double value(double r) { return r <= -1 || r >= 1 ? 0 : r < 0 ? 1 + r : 1 - r; }
    static constexpr double integral(double r) {
        return r <= -1 ? 0 : r >= 1 ? 1 : r < 0 ? 0.5 * (1 + r) * (1 + r) : 1 - 0.5 * (1 - r) * (1 - r);
    }
};

}  // namespace ordo::solvers::mpm

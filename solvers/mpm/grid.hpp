#pragma once
// The background grid: a box of equal cells, the nodes of a basis on it, what they carry, and those that are held.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "solvers/mpm/basis/spline.hpp"
#include "solvers/mpm/options.hpp"

namespace ordo::solvers::mpm {

/// A cell by its place along each axis.
template <int dim>
using Cell = Eigen::Matrix<int, dim, 1>;

/// Where a point is before it has been looked for: in no cell, nor beside one.
constexpr int nowhere = std::numeric_limits<int>::min();

/// One velocity component of one node that a fixed or roller face rules.
struct Held {
    int node;
    int axis;
};

template <int dim>
struct Grid {
    Vec<dim> lower;                 ///< where the first cell begins [m]
    double h = 1;                   ///< cell width [m]
    int degree = 1;                 ///< of the splines: an axis has cells + degree nodes
    std::array<int, dim> cells{};   ///< along each axis
    std::array<int, dim> stride{};  ///< from a node to the next one along each axis
    bool extrapolate = false;
    std::array<bool, dim> periodic{};  ///< axes whose faces are: `degree` cells before and behind the body stand for it
    std::array<std::vector<double>, dim> place;  ///< of the nodes along each axis, in cells from `lower`
    std::vector<double> m;                       ///< [kg]
    std::vector<Vec<dim>> v;                     ///< momentum while it is being gathered, then velocity [m/s]
    std::vector<Vec<dim>> a;                     ///< force while it is being gathered, then acceleration [m/s^2]
    std::vector<Held> held;

    Grid(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution);

    int nodes() const { return static_cast<int>(m.size()); }

    /// Where node i stands: the Greville point of its spline. Linear fields have their values there as coefficients.
    Vec<dim> position(int i) const {
        Vec<dim> x;
        for (int axis = 0; axis < dim; ++axis) {
            const int along = i / stride[axis] % static_cast<int>(place[axis].size());
            x[axis] = lower[axis] + h * place[axis][static_cast<std::size_t>(along)];
        }
        return x;
    }

    bool is_periodic() const { return std::ranges::find(periodic, true) != periodic.end(); }

    /// x by whole periods to where the body was at the start. A place within a box that round-off has put outside
    /// stays.
    Vec<dim> folded(Vec<dim> x) const {
        for (int axis = 0; axis < dim; ++axis) {
            if (!periodic[axis]) continue;
            const double period = h * (cells[axis] - 2 * degree);
            const double turns = std::floor((x[axis] - lower[axis] - h * degree) / period + end_tolerance);
            if (turns != 0) x[axis] -= turns * period;
        }
        return x;
    }

    /// The node that stands for node i: of all that are a period apart one.
    int image(int i) const {
        int node = i;
        for (int axis = 0; axis < dim; ++axis) {
            if (!periodic[axis]) continue;
            const int period = cells[axis] - 2 * degree;
            const int along = i / stride[axis] % (cells[axis] + degree);
            node += stride[axis] * ((along + degree * (period - 1)) % period + degree - along);
        }
        return node;
    }

    /// The cell of x along each axis, and the local coordinate xi there. False where the grid ends, and for NaN.
    /// A point on the face between two cells stays in the one that `cell` names: the other may hold no mass.
    bool locate(const Vec<dim>& x, Cell<dim>& cell, Vec<dim>& xi) const {
        for (int axis = 0; axis < dim; ++axis) {
            const double r = (x[axis] - lower[axis]) / h;
            const int count = cells[axis];
            const bool at_end = r >= count && r <= count + end_tolerance;
            if (!(r >= -end_tolerance && (r < count || at_end)) && !(extrapolate && std::abs(r) < 2.0 * count + 2))
                return false;
            if (r != cell[axis] + 1) cell[axis] = r < 0 ? 0 : r >= count ? count - 1 : static_cast<int>(r);
            xi[axis] = r - cell[axis];
        }
        return true;
    }

    /// The body's box has moved: the same cells, as wide as it takes. One dimension only.
    void fit(double from, double to) {
        lower[0] = from;
        h = (to - from) / cells[0];
    }

private:
    /// A point on the last face belongs to the last cell, and one that round-off has put beside a face to the grid [-].
    static constexpr double end_tolerance = 1e-9;
};

/// The grid covers the body and, where it does not follow it, a margin of cells beyond each free face.
template <int dim>
Grid<dim>::Grid(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution)
    : lower(scene.lower),
      h(resolution.h),
      degree(options.spline_degree()),
      extrapolate(options.beyond_grid == BeyondGrid::extrapolate) {
    std::array<std::array<int, 2>, dim> ends{};  // nodes that stand on the body's faces
    int count = 1;
    for (int axis = 0; axis < dim; ++axis) {
        const auto& face = scene.faces[axis];
        const int body = options.cells_span_grid
                             ? resolution.cells
                             : static_cast<int>(std::lround((scene.upper[axis] - scene.lower[axis]) / h));
        const bool widened =
            options.beyond_grid == BeyondGrid::extend && options.frame == Frame::updated && !options.cells_span_grid;
        const int margin = widened ? static_cast<int>(std::ceil(options.margin * body)) + 1 : 0;
        periodic[axis] = face[0] == Face::periodic;
        const auto beyond = [&](Face which) { return which == Face::free ? margin : periodic[axis] ? degree : 0; };
        const int before = beyond(face[0]);
        cells[axis] = before + body + beyond(face[1]);
        lower[axis] -= before * h;
        for (int i = 0; i < cells[axis] + degree; ++i) place[axis].push_back(greville(i, degree, cells[axis]));
        ends[axis] = {0, cells[axis] + degree - 1};
        stride[axis] = count;
        count *= cells[axis] + degree;
    }
    m.resize(static_cast<std::size_t>(count));
    v.resize(m.size());
    a.resize(m.size());
    for (int node = 0; node < count; ++node) {
        std::array<bool, dim> holds{};
        for (int axis = 0; axis < dim; ++axis) {
            const int index = node / stride[axis] % (cells[axis] + degree);
            for (int side = 0; side < 2; ++side) {
                const Face face = scene.faces[axis][side];
                if (face == Face::free || face == Face::periodic || index != ends[axis][side]) continue;
                for (int c = 0; c < dim; ++c) holds[c] = holds[c] || face == Face::fixed || c == axis;
            }
        }
        for (int c = 0; c < dim; ++c) {
            if (holds[c]) held.push_back({node, c});
        }
    }
}

}  // namespace ordo::solvers::mpm

#pragma once
// The background grid: a box of equal cells, nodal mass, velocity and acceleration, and the nodes that are held.
#include <array>
#include <cmath>
#include <vector>

#include "solvers/mpm/options.hpp"

namespace ordo::solvers::mpm {

/// One velocity component of one node that a fixed or roller face holds at zero.
struct Held {
    int node;
    int axis;
};

template <int dim>
struct Grid {
    Vec<dim> lower;                 ///< position of node 0 [m]
    double h = 1;                   ///< cell width [m]
    std::array<int, dim> cells{};   ///< along each axis
    std::array<int, dim> stride{};  ///< from a node to the next one along each axis
    bool extrapolate = false;
    std::vector<double> m;    ///< [kg]
    std::vector<Vec<dim>> v;  ///< momentum while it is being gathered, then velocity [m/s]
    std::vector<Vec<dim>> a;  ///< force while it is being gathered, then acceleration [m/s^2]
    std::vector<Held> held;

    Grid(const SolidScene<dim>& scene, const Resolution& resolution, const Options& options);

    /// The cell of x as its first node, and the local coordinate xi there. False where the grid ends, and for NaN.
    bool locate(const Vec<dim>& x, int& base, Vec<dim>& xi) const {
        base = 0;
        for (int axis = 0; axis < dim; ++axis) {
            const double r = (x[axis] - lower[axis]) / h;
            const int last = cells[axis] - 1;
            if (!(r >= 0 && r < cells[axis]) && !(extrapolate && std::abs(r) < 2.0 * cells[axis] + 2)) return false;
            const int cell = r < 0 ? 0 : r > last ? last : static_cast<int>(r);
            xi[axis] = r - cell;
            base += cell * stride[axis];
        }
        return true;
    }
};

/// The grid covers the body and, unless it extrapolates, a margin of cells beyond each free face.
template <int dim>
Grid<dim>::Grid(const SolidScene<dim>& scene, const Resolution& resolution, const Options& options)
    : lower(scene.lower), h(resolution.h), extrapolate(options.extrapolate) {
    std::array<int, dim> first{};
    std::array<int, dim> body{};
    int nodes = 1;
    for (int axis = 0; axis < dim; ++axis) {
        body[axis] = static_cast<int>(std::lround((scene.upper[axis] - scene.lower[axis]) / h));
        const int margin = extrapolate ? 0 : static_cast<int>(std::ceil(options.margin * body[axis])) + 1;
        first[axis] = scene.faces[axis][0] == Face::free ? margin : 0;
        cells[axis] = first[axis] + body[axis] + (scene.faces[axis][1] == Face::free ? margin : 0);
        lower[axis] -= first[axis] * h;
        stride[axis] = nodes;
        nodes *= cells[axis] + 1;
    }
    m.resize(nodes);
    v.resize(nodes);
    a.resize(nodes);
    for (int node = 0; node < nodes; ++node) {
        std::array<bool, dim> holds{};
        for (int axis = 0; axis < dim; ++axis) {
            const int index = node / stride[axis] % (cells[axis] + 1);
            for (int side = 0; side < 2; ++side) {
                const Face face = scene.faces[axis][side];
                if (face == Face::free || index != first[axis] + side * body[axis]) continue;
                for (int c = 0; c < dim; ++c) holds[c] = holds[c] || face == Face::fixed || c == axis;
            }
        }
        for (int c = 0; c < dim; ++c) {
            if (holds[c]) held.push_back({node, c});
        }
    }
}

}  // namespace ordo::solvers::mpm

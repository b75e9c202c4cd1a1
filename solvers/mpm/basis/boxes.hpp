#pragma once
// Bases that average the grid's tents over the box that a particle stands for: GIMP and CPDI.
#include <Eigen/LU>
#include <array>
#include <cmath>

#include "solvers/mpm/basis/tensor.hpp"
#include "solvers/mpm/particles.hpp"

namespace ordo::solvers::mpm {

/// Means over [from, to], in cells, of f = dI/dr for the tents first, first + 1, ... that live there.
template <double (*I)(double)>
struct MeansOfTents {
    double from = 0;
    double to = 1;
    int first = 0;
    std::size_t count = 0;

    std::size_t size() const { return count; }
    double operator[](std::size_t k) const {
        const double node = first + static_cast<double>(k);
        return (I(to - node) - I(from - node)) / (to - from);
    }
};
using GimpAxis = AlongAxis<MeansOfTents<Tent::integral>, MeansOfTents<Tent::value>>;

/// The tents' means and mean slopes over a box of half edges `half` [m] around x; a box that reaches beyond the grid is
/// cut there, so that the weights stay a partition of unity. source [BardenhagenKober2004]
template <int dim>
void add_gimp(const Grid<dim>& grid, const Vec<dim>& x, const Vec<dim>& half, Stencils<dim>& stencils) {
    std::array<GimpAxis, dim> axes;
    for (int axis = 0; axis < dim; ++axis) {
        const double centre = (x[axis] - grid.lower[axis]) / grid.h;
        const double reach = half[axis] / grid.h;
        const double from = std::max(centre - reach, 0.0);
        const double to = std::min(centre + reach, static_cast<double>(grid.cells[axis]));
        const int first = static_cast<int>(std::floor(from));
        const auto count = static_cast<std::size_t>(static_cast<int>(std::ceil(to)) - first + 1);
        axes[axis] = {first, {from, to, first, count}, {from, to, first, count}};
    }
    add_products<dim>(grid, axes, stencils);
}

/// Appends share * (tents at a corner), with the gradient `weight` times them. The corner is moved onto the grid.
template <int dim>
void add_corner(const Grid<dim>& grid, const Vec<dim>& corner, double share, const Vec<dim>& weight,
                Stencils<dim>& stencils) {
    std::array<int, dim> cell{};
    Vec<dim> xi;
    for (int axis = 0; axis < dim; ++axis) {
        const double last = grid.cells[axis];
        const double r = std::clamp((corner[axis] - grid.lower[axis]) / grid.h, 0.0, last);
        cell[axis] = std::min(static_cast<int>(r), grid.cells[axis] - 1);
        xi[axis] = r - cell[axis];
    }
    for (int k = 0; k < 1 << dim; ++k) {
        int node = 0;
        double w = 1;
        for (int axis = 0; axis < dim; ++axis) {
            const int along = k >> axis & 1;
            node += (cell[axis] + along) * grid.stride[axis];
            w *= along == 0 ? 1 - xi[axis] : xi[axis];
        }
        stencils.add(node, share * w, w * weight);
    }
}

/// CPDI: the box has become a parallelepiped of half edges R = F diag(half); each tent is replaced by its multilinear
/// interpolation between the corners, whose mean gradient is R^-T sum_c sign_c N(x_c) / 2^dim.
/// source [Sadeghirad2011]
template <int dim>
void add_cpdi(const Grid<dim>& grid, const Vec<dim>& x, const Tensor<dim>& R, Stencils<dim>& stencils) {
    constexpr double share = 1.0 / (1 << dim);
    const Tensor<dim> to_gradient = share * R.inverse().transpose();
    for (int k = 0; k < 1 << dim; ++k) {
        const Vec<dim> sign = corner_signs<dim>(k);
        add_corner<dim>(grid, x + R * sign, share, to_gradient * sign, stencils);
    }
}

/// CPDI2: the same with corners that the grid has moved one by one. Means over the isoparametric box, by two Gauss
/// points an axis: exact, since the integrands are polynomials of degree 3 at most in each local coordinate.
/// source [Sadeghirad2013]
template <int dim>
void add_cpdi2(const Grid<dim>& grid, std::span<const Vec<dim>> corners, Stencils<dim>& stencils) {
    constexpr int count = 1 << dim;
    std::array<double, count> share{};
    std::array<Vec<dim>, count> weight;
    weight.fill(Vec<dim>::Zero());
    double volume = 0;
    for (int q = 0; q < count; ++q) {
        const Vec<dim> at = corner_signs<dim>(q) / std::sqrt(3.0);
        std::array<double, count> phi;
        std::array<Vec<dim>, count> slope;
        Tensor<dim> J = Tensor<dim>::Zero();
        for (int k = 0; k < count; ++k) {
            const Vec<dim> factor = 0.5 * (Vec<dim>::Ones() + corner_signs<dim>(k).cwiseProduct(at));
            phi[k] = factor.prod();
            for (int axis = 0; axis < dim; ++axis) {
                slope[k][axis] = 0.5 * corner_signs<dim>(k)[axis];
                for (int other = 0; other < dim; ++other) slope[k][axis] *= other == axis ? 1 : factor[other];
            }
            J += corners[static_cast<std::size_t>(k)] * slope[k].transpose();
        }
        const double det = J.determinant();
        const Tensor<dim> to_space = J.inverse().transpose();
        volume += det;
        for (int k = 0; k < count; ++k) {
            share[k] += det * phi[k];
            weight[k] += det * (to_space * slope[k]);
        }
    }
    for (int k = 0; k < count; ++k)
        add_corner<dim>(grid, corners[static_cast<std::size_t>(k)], share[k] / volume, weight[k] / volume, stencils);
}

}  // namespace ordo::solvers::mpm

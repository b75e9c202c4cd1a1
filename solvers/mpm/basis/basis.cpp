#include "solvers/mpm/basis/basis.hpp"

#include "solvers/mpm/basis/boxes.hpp"
#include "solvers/mpm/basis/dual_domain.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::mpm {
namespace {

/// One row a point: `add(p, xi)` appends the entries of point p.
template <int dim, class Add>
Filled fill_rows(const Grid<dim>& grid, std::span<const Vec<dim>> x, std::span<Cell<dim>> cell, Stencils<dim>& stencils,
                 Add&& add) {
    stencils.clear();
    long crossed = 0;
    bool on_face = false;
    for (std::size_t p = 0; p < x.size(); ++p) {
        Vec<dim> xi;
        const Cell<dim> before = cell[p];
        if (!grid.locate(x[p], cell[p], xi)) return {p, crossed, on_face};
        crossed += before[0] != nowhere && before != cell[p];
        for (int axis = 0; axis < dim; ++axis) on_face = on_face || xi[axis] == 0 || xi[axis] == 1;
        add(p, xi);
        stencils.close_row();
    }
    return {x.size(), crossed, on_face};
}

/// Which cells hold a point.
template <int dim>
class OccupiedCells {
public:
    OccupiedCells(const Grid<dim>& grid, std::span<const Vec<dim>> x, std::span<const Cell<dim>> last) : grid_(grid) {
        std::size_t count = 1;
        for (const int cells : grid.cells) count *= static_cast<std::size_t>(cells);
        holds_.assign(count, false);
        for (std::size_t p = 0; p < x.size(); ++p) {
            Cell<dim> cell = last[p];
            Vec<dim> xi;
            if (grid.locate(x[p], cell, xi)) holds_[number_of(cell)] = true;
        }
    }
    bool operator()(const Cell<dim>& cell) const {
        for (int axis = 0; axis < dim; ++axis) {
            if (cell[axis] < 0 || cell[axis] >= grid_.cells[axis]) return false;
        }
        return holds_[number_of(cell)];
    }

private:
    std::size_t number_of(const Cell<dim>& cell) const {
        std::size_t number = 0;
        for (int axis = dim - 1; axis >= 0; --axis)
            number = number * static_cast<std::size_t>(grid_.cells[axis]) + static_cast<std::size_t>(cell[axis]);
        return number;
    }

    const Grid<dim>& grid_;
    std::vector<bool> holds_;
};

}  // namespace

template <int dim>
Filled fill_at_points(const Grid<dim>& grid, std::span<const Vec<dim>> x, std::span<Cell<dim>> cell,
                      Stencils<dim>& stencils) {
    const auto splines = [&]<int degree>(std::integral_constant<int, degree>) {
        return fill_rows(grid, x, cell, stencils, [&](std::size_t p, const Vec<dim>& xi) {
            add_splines<degree, dim>(grid, cell[p], xi, stencils);
        });
    };
    switch (grid.degree) {
        case 2: return splines(std::integral_constant<int, 2>{});
        case 3: return splines(std::integral_constant<int, 3>{});
        case 4: return splines(std::integral_constant<int, 4>{});
        default: return splines(std::integral_constant<int, 1>{});
    }
}

namespace {

template <int dim>
Filled fill_at(const Grid<dim>& grid, const Options& options, std::span<const Vec<dim>> x, Particles<dim>& p,
               Stencils<dim>& stencils) {
    const bool total = options.frame == Frame::total;
    const std::span<Cell<dim>> cell = p.cell;
    const auto rows = [&](auto&& add) { return fill_rows(grid, x, cell, stencils, add); };
    switch (options.basis) {
        case Basis::ugimp:
        case Basis::cpgimp: {
            const bool stretched = options.basis == Basis::cpgimp && !total;
            return rows([&](std::size_t i, const Vec<dim>&) {
                const Vec<dim> half = stretched ? Vec<dim>(p.F[i].diagonal().cwiseProduct(p.half[i])) : p.half[i];
                if (!(half.minCoeff() > 0) || !half.allFinite()) throw Diverged("the box of a particle has no width");
                add_gimp<dim>(grid, x[i], half, stencils);
            });
        }
        case Basis::cpdi:
            return rows([&](std::size_t i, const Vec<dim>&) {
                const Tensor<dim> box = p.half[i].asDiagonal();
                const Tensor<dim> now = total ? box : Tensor<dim>(p.F[i] * box);
                if (!now.allFinite()) throw Diverged("the box of a particle is not finite");
                add_cpdi<dim>(grid, x[i], now, stencils);
            });
        case Basis::cpdi2:
            return rows([&](std::size_t i, const Vec<dim>&) {
                constexpr std::size_t count = 1 << dim;
                add_cpdi2<dim>(grid, std::span(p.corners).subspan(i * count, count), stencils);
            });
        case Basis::ddmp: {
            const OccupiedCells<dim> occupied(grid, x, cell);
            return rows([&](std::size_t i, const Vec<dim>& xi) {
                add_dual_domain<dim>(grid, cell[i], xi, occupied, stencils);
            });
        }
        default: return fill_at_points(grid, x, cell, stencils);
    }
}

}  // namespace

template <int dim>
Filled fill(const Grid<dim>& grid, const Options& options, Particles<dim>& p, Stencils<dim>& stencils) {
    const std::span<const Vec<dim>> x = options.frame == Frame::total ? p.X : p.x;
    if (!grid.is_periodic()) return fill_at(grid, options, x, p, stencils);
    std::vector<Vec<dim>> inside(x.begin(), x.end());
    for (auto& place : inside) place = grid.folded(place);
    const Filled filled = fill_at<dim>(grid, options, inside, p, stencils);
    stencils.rename([&](int i) { return grid.image(i); });
    return filled;
}

template Filled fill_at_points(const Grid<1>&, std::span<const Vec<1>>, std::span<Cell<1>>, Stencils<1>&);
template Filled fill_at_points(const Grid<2>&, std::span<const Vec<2>>, std::span<Cell<2>>, Stencils<2>&);
template Filled fill_at_points(const Grid<3>&, std::span<const Vec<3>>, std::span<Cell<3>>, Stencils<3>&);
template Filled fill(const Grid<1>&, const Options&, Particles<1>&, Stencils<1>&);
template Filled fill(const Grid<2>&, const Options&, Particles<2>&, Stencils<2>&);
template Filled fill(const Grid<3>&, const Options&, Particles<3>&, Stencils<3>&);

}  // namespace ordo::solvers::mpm

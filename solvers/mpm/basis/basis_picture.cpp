#include "solvers/mpm/basis/basis_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/error.hpp"
#include "core/text.hpp"
#include "solvers/mpm/basis/basis.hpp"

namespace ordo::solvers::mpm {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Options options_for(const Lineup& lineup) {
    Options options;
    options.basis = lineup.basis;
    options.placement = Placement::body_centred;
    return options;
}

/// The body with its shift and stretch as a deformation that it starts with.
SolidScene<1> scene_for(const Lineup& lineup) {
    const double middle = 0.5 * lineup.cells;
    SolidScene<1> scene;
    scene.lower[0] = lineup.margin;
    scene.upper[0] = lineup.cells - lineup.margin;
    scene.velocity = [](std::span<const Vec<1>>, double, std::span<Vec<1>>) {};
    scene.deformed = Deformed<1>{[=](std::span<const Vec<1>> X, double, std::span<Vec<1>> u) {
                                     for (std::size_t p = 0; p < X.size(); ++p)
                                         u[p][0] = lineup.translate + (lineup.stretch - 1) * (X[p][0] - middle);
                                 },
                                 [=](std::span<const Vec<1>>, double, std::span<Tensor<1>> F) {
                                     std::fill(F.begin(), F.end(), Tensor<1>(lineup.stretch));
                                 }};
    return scene;
}

/// The grid's margin is an option relative to the body, rounded up, and a cell more.
Grid<1> grid_for(const Lineup& lineup, const SolidScene<1>& scene, Options options, const Resolution& resolution) {
    options.margin = lineup.margin == 1 ? 0 : (lineup.margin - 1.5) / resolution.cells;
    Grid<1> grid(scene, options, resolution);
    if (grid.cells[0] != lineup.cells || grid.lower[0] != 0)
        throw std::logic_error("the grid is not the one asked for");
    return grid;
}

void check(const Lineup& lineup, const std::string& where) {
    const int body = lineup.cells - 2 * lineup.margin;
    if (body < 1)
        throw InputError(where, "'margin' is " + std::to_string(lineup.margin) + ", but must leave a cell of the " +
                                    std::to_string(lineup.cells) +
                                    " to the body (nearest: " + std::to_string((lineup.cells - 1) / 2) + ")");
    const double middle = 0.5 * lineup.cells + lineup.translate;
    const double reach = 0.5 * body * lineup.stretch;
    const double over = std::max(reach - middle, middle + reach - lineup.cells);
    if (over <= negligible) return;
    const int more = static_cast<int>(std::ceil(over - negligible));
    throw InputError(where, "the body reaches from " + shortest(middle - reach) + " to " + shortest(middle + reach) +
                                ", but must stay on the grid from 0 to " + std::to_string(lineup.cells) +
                                " (nearest: cells " + std::to_string(lineup.cells + 2 * more) + " with margin " +
                                std::to_string(lineup.margin + more) + ")");
}

/// Rows of stencils as a full matrix.
Weights full(const Stencils<1>& stencils, int nodes) {
    Weights weights = Weights::Zero(static_cast<Eigen::Index>(stencils.points()), nodes);
    for (std::size_t p = 0; p < stencils.points(); ++p)
        stencils.row(p, [&](int node, double w, const Vec<1>&) { weights(static_cast<Eigen::Index>(p), node) += w; });
    return weights;
}

Weights seen_by(const Grid<1>& grid, const Lineup& lineup, Particles<1>& particles) {
    Stencils<1> stencils;
    if (fill(grid, options_for(lineup), particles, stencils).rows != particles.size())
        throw InputError("", "a point lies outside the grid");
    return full(stencils, grid.nodes());
}

}  // namespace

std::vector<Parameter> lineup_parameters() {
    const Lineup d;
    return {whole("cells", d.cells, between(3, 64), "cells of the grid, each of width 1"),
            whole("margin", d.margin, between(1, 31), "cells on either side of the undeformed body"),
            number("ppc", "-", d.ppc, between(0.5, 4), "particles a cell of the undeformed body"),
            number("translate", "cells", d.translate, between(-64, 64), "shift of the body"),
            number("stretch", "-", d.stretch, between(0.1, 10), "stretch about the body's middle, boxes too")};
}

Picture picture_of(const Lineup& lineup, const std::string& where) {
    check(lineup, where);
    const int body = lineup.cells - 2 * lineup.margin;
    const Options options = options_for(lineup);
    const SolidScene<1> scene = scene_for(lineup);
    const Resolution resolution{.cells = body, .ppc = lineup.ppc};
    Picture picture{
        lineup, grid_for(lineup, scene, options, resolution), seeded<1>(scene, options, resolution, true), {}, {}, {}};
    picture.S = seen_by(picture.grid, lineup, picture.particles);
    for (Eigen::Index i = 0; i < picture.S.cols(); ++i)
        picture.touched.push_back(picture.S.col(i).maxCoeff() > negligible);
    for (std::size_t p = 0; p < picture.particles.size(); ++p) {
        const double half = lineup.stretch * picture.particles.half[p][0];
        picture.corners.push_back(picture.particles.x[p][0] - half);
        picture.corners.push_back(picture.particles.x[p][0] + half);
    }
    return picture;
}

Eigen::VectorXd Picture::positions() const {
    Eigen::VectorXd x(count());
    for (Eigen::Index p = 0; p < x.size(); ++p) x[p] = particles.x[static_cast<std::size_t>(p)][0];
    return x;
}

Weights grid_basis(const Picture& picture, std::span<const double> x) {
    Particles<1> probes;
    const Vec<1> half = picture.particles.half.front();
    for (const double at : x) {
        probes.x.emplace_back(at);
        probes.corners.emplace_back(at - picture.lineup.stretch * half[0]);
        probes.corners.emplace_back(at + picture.lineup.stretch * half[0]);
    }
    probes.half.assign(x.size(), half);
    probes.F.assign(x.size(), Tensor<1>(picture.lineup.stretch));
    probes.cell.assign(x.size(), Cell<1>::Constant(nowhere));
    return seen_by(picture.grid, picture.lineup, probes);
}

Weights grid_functions(const Picture& picture, std::span<const double> x) {
    std::vector<Vec<1>> points;
    for (const double at : x) points.emplace_back(at);
    std::vector<Cell<1>> cell(x.size(), Cell<1>::Constant(nowhere));
    Stencils<1> stencils;
    if (fill_at_points<1>(picture.grid, points, cell, stencils).rows != x.size())
        throw InputError("", "a point lies outside the grid");
    return full(stencils, picture.nodes());
}

Weights interpolated_tents(const Picture& picture, std::span<const double> x) {
    const Weights at_corners = grid_functions(picture, picture.corners);
    Weights tents = Weights::Constant(static_cast<Eigen::Index>(x.size()), picture.nodes(), nan);
    for (std::size_t k = 0; k < x.size(); ++k) {
        for (std::size_t p = 0; p < picture.particles.size(); ++p) {
            const double from = picture.corners[2 * p];
            const double xi = (x[k] - from) / (picture.corners[2 * p + 1] - from);
            if (!(xi >= -negligible && xi <= 1 + negligible)) continue;
            const auto first = static_cast<Eigen::Index>(2 * p);
            tents.row(static_cast<Eigen::Index>(k)) = (1 - xi) * at_corners.row(first) + xi * at_corners.row(first + 1);
        }
    }
    return tents;
}

std::vector<double> points_between_particles(const Picture& picture) {
    const Eigen::VectorXd x_p = picture.positions();
    std::vector<double> x = drawing_points(picture);
    std::erase_if(x, [&](double at) { return at < x_p.minCoeff() || at > x_p.maxCoeff(); });
    return x;
}

std::vector<double> drawing_points(const Picture& picture) {
    std::vector<double> x = picture.corners;
    for (const auto& at : picture.particles.x) x.push_back(at[0]);
    const int intervals = picture.lineup.cells * points_a_cell;
    for (int k = 0; k <= intervals; ++k) x.push_back(static_cast<double>(k) / points_a_cell);
    // A corner on the grid's end may lie beside it by round-off.
    for (double& at : x) at = std::clamp(at, 0.0, static_cast<double>(picture.lineup.cells));
    std::ranges::sort(x);
    const auto same = std::ranges::unique(x, [](double a, double b) { return b - a < negligible; });
    x.erase(same.begin(), same.end());
    return x;
}

}  // namespace ordo::solvers::mpm

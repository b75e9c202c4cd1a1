// What every basis owes: constants and linear fields exactly, in each dimension.
#include "solvers/mpm/basis/basis.hpp"

#include <random>
#include <string>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/rows.hpp"

using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

const std::vector<std::string> all_bases{"linear", "quadratic", "cubic", "quartic", "ugimp",
                                         "cpgimp", "cpdi",      "cpdi2", "ddmp"};

template <int dim>
SolidScene<dim> some_box() {
    return box<dim>(Vec<dim>(Vec<3>(1.0, 0.6, 0.8).head<dim>()), Face::fixed, uniform<dim>(Vec<dim>::Zero()));
}

/// Bodies whose boxes have become general parallelepipeds, moved off their lattice but within the grid.
template <int dim>
Particles<dim> crumpled(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution) {
    auto p = seeded<dim>(scene, options, resolution, true);
    std::mt19937 bits(11);
    std::uniform_real_distribution<double> any(-1, 1);
    p.corners.clear();
    for (std::size_t i = 0; i < p.size(); ++i) {
        Tensor<dim> change;
        for (int k = 0; k < dim * dim; ++k) change(k) = 0.15 * any(bits);
        p.F[i] += change;
        const Vec<dim> middle = 0.5 * (scene.lower + scene.upper);
        p.x[i] = middle + 0.6 * (p.X[i] - middle);
        for (int axis = 0; axis < dim; ++axis) p.x[i][axis] += 0.03 * any(bits);
        for (int k = 0; k < 1 << dim; ++k) {
            Vec<dim> corner = p.half[i];
            for (int axis = 0; axis < dim; ++axis) corner[axis] *= (k >> axis & 1) == 0 ? -1 : 1;
            p.corners.push_back(p.x[i] + p.F[i] * corner);
        }
    }
    return p;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("basis: constants and linear fields come out exactly", "[unit]", ((int dim), dim), 1, 2, 3) {
    const auto name = GENERATE(from_range(all_bases));
    const auto frame = GENERATE(as<std::string>{}, "updated", "total");
    INFO(name << ", " << frame);
    const auto scene = some_box<dim>();
    const auto options = options_of({{"basis", name}, {"frame", frame}});
    const Resolution resolution{.cells = 5, .ppc = 2, .h = 0.2, .dt = 1};
    const Grid<dim> grid(scene, options, resolution);
    auto p = crumpled<dim>(scene, options, resolution);
    if (frame == "total") p.corners = seeded<dim>(scene, options_of({{"basis", "cpdi2"}}), resolution, false).corners;
    Stencils<dim> stencils;
    REQUIRE(fill<dim>(grid, options, p, stencils).rows == p.size());
    REQUIRE(stencils.points() == p.size());
    for (std::size_t i = 0; i < p.size(); ++i)
        check_linear_fields<dim>(Row<dim>(grid, stencils, i), frame == "total" ? p.X[i] : p.x[i], grid.h);
}

TEMPLATE_TEST_CASE_SIG("basis: boxes of no size are tents at points", "[unit]", ((int dim), dim), 1, 2, 3) {
    const auto name = GENERATE(as<std::string>{}, "ugimp", "cpgimp", "cpdi", "cpdi2");
    INFO(name);
    const auto scene = some_box<dim>();
    const auto options = options_of({{"basis", name}});
    const Resolution resolution{.cells = 5, .ppc = 3, .h = 0.2, .dt = 1};
    const Grid<dim> grid(scene, options, resolution);
    auto p = crumpled<dim>(scene, options, resolution);
    const double size = 1e-6;
    for (std::size_t i = 0; i < p.corners.size(); ++i) {
        const auto& x = p.x[i >> dim];
        p.corners[i] = x + size * (p.corners[i] - x);
    }
    for (auto& half : p.half) half *= size;
    Stencils<dim> stencils;
    REQUIRE(fill<dim>(grid, options, p, stencils).rows == p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Row<dim> found(grid, stencils, i);
        const Row<dim> tents = row_at<dim>(grid, p.x[i]);
        for (const auto& [node, entry] : found.at) {
            CHECK(std::abs(entry.w - tents[node].w) < 2 * size);
            CHECK((entry.grad - tents[node].grad).norm() * grid.h < 1e-9 + 2 * size);  // round-off over the size
        }
    }
}

TEST_CASE("basis: a filling counts the points that changed their cell and stops at the first that left", "[unit]") {
    const auto scene = some_box<1>();
    const Grid<1> grid(scene, {}, {.cells = 5, .ppc = 1, .h = 0.2, .dt = 1});
    const auto at = [&](double cells) { return Vec<1>(scene.lower[0] + 0.2 * cells); };
    std::vector<Vec<1>> x{at(0.5), at(1.5), at(2.5)};
    std::vector<Cell<1>> cell(3, Cell<1>(nowhere));
    Stencils<1> stencils;
    const auto filled = [&] { return fill_at_points<1>(grid, std::span<const Vec<1>>(x), cell, stencils); };
    CHECK((filled().rows == 3 && filled().crossed == 0));  // the first time nobody crosses
    x[0] = at(1.25);
    x[2] = at(4.5);
    const auto [rows, crossed, on_face] = filled();
    CHECK((rows == 3 && crossed == 2));
    CHECK((cell[0][0] == 1 && cell[1][0] == 1 && cell[2][0] == 4));
    x[1] = at(5.5);
    CHECK(filled().rows == 1);
}

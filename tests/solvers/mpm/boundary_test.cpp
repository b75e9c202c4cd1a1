#include "solvers/mpm/boundary.hpp"

#include <string>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/rows.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

const Resolution quarter{.cells = 4, .ppc = 2, .h = 0.25, .dt = 1};

/// Nominal traction, linear in place and time.
template <int dim>
Vec<dim> load(const Vec<dim>& X, double t) {
    return Vec<dim>::Constant(1 + t) + 2 * X;
}

/// A unit box whose faces are free but for the lower one along axis 0.
template <int dim>
SolidScene<dim> loaded_box() {
    SolidScene<dim> scene{.lower = Vec<dim>::Zero(), .upper = Vec<dim>::Ones(), .faces = all_faces<dim>(Face::free)};
    scene.faces[0][0] = Face::fixed;
    scene.velocity = uniform<dim>(Vec<dim>::Zero());
    scene.traction = pointwise<dim>(load<dim>);
    return scene;
}

template <int dim>
struct Met {
    Grid<dim> grid;
    Particles<dim> p;
    Stencils<dim> stencils;
    Boundary<dim> boundary;

    Met(const SolidScene<dim>& scene, const Options& options)
        : grid(scene, options, quarter),
          p(seeded<dim>(scene, options, quarter, false)),
          boundary(scene, options, quarter, p) {
        REQUIRE(fill<dim>(grid, options, p, stencils).rows == p.size());
        boundary.meet_grid(grid, options.frame == Frame::total, stencils);
        for (auto& m : grid.m) m = 1;  // every node can take a load
    }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("boundary: points cover each free face that is loaded, and no other", "[unit]", ((int dim), dim),
                       1, 2, 3) {
    const Met<dim> met(loaded_box<dim>(), {});
    const auto& boundary = met.boundary;
    const int a_face = 1 << 3 * (dim - 1);  // 4 cells of 2
    CHECK(boundary.X.size() == static_cast<std::size_t>((2 * dim - 1) * a_face));
    double area = 0;
    for (std::size_t k = 0; k < boundary.X.size(); ++k) {
        area += boundary.area[k];
        int on_faces = 0;
        for (int axis = 0; axis < dim; ++axis)
            on_faces += boundary.X[k][axis] == 1 || (axis > 0 && boundary.X[k][axis] == 0);
        CHECK(on_faces == 1);
        CHECK(boundary.x[k] == boundary.X[k]);
    }
    CHECK(area == Approx(2 * dim - 1));
    auto without = loaded_box<dim>();
    without.traction.reset();
    CHECK(Met<dim>(without, {}).boundary.X.empty());
}

TEMPLATE_TEST_CASE_SIG("boundary: the grid feels the whole load, where it acts", "[unit]", ((int dim), dim), 1, 2, 3) {
    const auto basis = GENERATE(Basis::linear, Basis::cubic);
    Met<dim> met(loaded_box<dim>(), {.basis = basis});
    const double t = 0.5;
    std::vector<Vec<dim>> f(met.grid.m.size(), Vec<dim>::Zero());
    const Vec<dim> total = met.boundary.pull(t, met.grid, f);
    Vec<dim> sum = Vec<dim>::Zero();
    Tensor<dim> moment = Tensor<dim>::Zero();
    for (int i = 0; i < met.grid.nodes(); ++i) {
        sum += f[static_cast<std::size_t>(i)];
        moment += met.grid.position(i) * f[static_cast<std::size_t>(i)].transpose();
    }
    // Integral of 1 + t + 2 X_c over the faces X_a = 1 (all axes) and X_a = 0 (all but the first), by hand: its mean
    // over a face is 1 + t + 1 along the face and 1 + t + 2 X_a across it.
    Vec<dim> by_hand = Vec<dim>::Zero();
    for (int axis = 0; axis < dim; ++axis) {
        for (const double X : {0.0, 1.0}) {
            if (axis == 0 && X == 0) continue;
            for (int c = 0; c < dim; ++c) by_hand[c] += 1 + t + (c == axis ? 2 * X : 1);
        }
    }
    CHECK((total - by_hand).norm() < 1e-13);
    CHECK((sum - total).norm() < 1e-13);
    Tensor<dim> expected = Tensor<dim>::Zero();
    for (std::size_t k = 0; k < met.boundary.X.size(); ++k)
        expected += met.boundary.area[k] * met.boundary.X[k] * load<dim>(met.boundary.X[k], t).transpose();
    CHECK((moment - expected).norm() < 1e-13);
}

TEST_CASE("boundary: a node without mass leaves its part of the load to the others", "[unit]") {
    Met<1> met(loaded_box<1>(), {});
    met.boundary.x[0] = Vec<1>(1.1);
    met.boundary.meet_grid(met.grid, false, met.stencils);
    std::vector<Vec<1>> f(met.grid.m.size(), Vec<1>::Zero());
    met.grid.m[5] = 0;
    const double total = met.boundary.pull(0, met.grid, f)[0];
    CHECK(total == 3);
    CHECK(f[4][0] == Approx(3));
    CHECK(f[5][0] == 0);
}

TEST_CASE("boundary: the particle nearest to a face can stand for it", "[unit]") {
    const auto frame = GENERATE(Frame::updated, Frame::total);
    Met<1> met(loaded_box<1>(), {.frame = frame, .last_particle_loaded = true});
    std::vector<Vec<1>> f(met.grid.m.size(), Vec<1>::Zero());
    CHECK(met.boundary.pull(0, met.grid, f)[0] == 3);  // the load of the face X = 1
    // The last particle stands a quarter of a cell inside: 1/4 of its load goes to node 3.
    CHECK(f[3][0] == Approx(0.75));
    CHECK(f[4][0] == Approx(2.25));
    CHECK_FALSE(met.boundary.moves());
    CHECK(Met<1>(loaded_box<1>(), {}).boundary.moves());
}

TEST_CASE("boundary: points move with the grid, and a start that is deformed moves them at once", "[unit]") {
    auto scene = loaded_box<1>();
    scene.deformed = Deformed<1>{.displacement = pointwise<1>([](const Vec<1>& X, double) { return Vec<1>(0.1 * X); }),
                                 .F = [](std::span<const Vec<1>>, double, std::span<Tensor<1>> out) {
                                     std::fill(out.begin(), out.end(), Tensor<1>(1.1));
                                 }};
    Met<1> met(scene, {});
    REQUIRE(met.boundary.x.size() == 1);
    CHECK((met.boundary.X[0][0] == 1 && met.boundary.x[0][0] == 1.1));
    for (int i = 0; i < met.grid.nodes(); ++i) met.grid.v[static_cast<std::size_t>(i)] = 3 * met.grid.position(i);
    met.boundary.move(0.01, met.grid);
    CHECK(met.boundary.x[0][0] == Approx(1.1 + 0.01 * 3.3));
    // A node without mass has no velocity to give: the others move the point.
    met.grid.m[5] = 0;
    met.boundary.move(0.01, met.grid);
    CHECK(met.boundary.x[0][0] == Approx(1.1 + 0.01 * 3.3 + 0.01 * 3));
    met.boundary.x[0] = Vec<1>(5);
    CHECK_THROWS_AS(met.boundary.meet_grid(met.grid, false, met.stencils), Diverged);
}

TEST_CASE("boundary: where the grid follows the body every face has a point, held or not", "[unit]") {
    auto scene = loaded_box<1>();
    scene.traction.reset();
    const Met<1> met(scene, {.beyond_grid = BeyondGrid::follow});
    REQUIRE(met.boundary.X.size() == 2);
    CHECK((met.boundary.X[0][0] == 0 && met.boundary.X[1][0] == 1));
    CHECK(Met<1>(scene, {}).boundary.X.empty());
}

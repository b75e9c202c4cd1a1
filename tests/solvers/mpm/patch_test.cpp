// Patch tests: motions that linear functions represent exactly stay exact.
//
// Which ones? A lumped nodal velocity is the mean of the particles' velocities under the node's tent. It equals a
// linear field at the node only where the tent's mass has its centre there: sum m_p S_ip (x_p - x_i) = 0. The internal
// force of a uniform stress vanishes only where sum V_p grad S_ip = 0. A lattice of particles with spacing h / ppc
// fulfils both for any shift against the grid, since the tent's Fourier transform has double zeros at all multiples of
// 2 pi / h. A body that stretches carries its lattice along: after one step the spacing is no fraction of h, and both
// sums fail by O(strain). So MPM keeps a translation and a shear (whose rows slide as they are) exactly over many
// steps, a uniform strain for one step only; further ones are matter of convergence, not of a patch test.
#include <string>

#include "core/text.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

/// Largest entries of found - expected over the particles that were looked at.
struct Deviation {
    double displacement = 0, velocity = 0, strain = 0, stress = 0;
    int particles = 0;

    template <class A, class B>
    static void enlarge(double& most, const A& found, const B& expected) {
        const double difference = (found - expected).cwiseAbs().maxCoeff();
        if (!(difference <= most)) most = difference;  // keeps NaN
    }
};

/// The body's motion at one time, uniform but for the displacement and the velocity.
template <int dim>
struct Expected {
    std::function<Vec<dim>(const Vec<dim>&X)> displacement, velocity;
    Tensor<dim> strain = Tensor<dim>::Zero();  ///< F - I
    Tensor<dim> stress = Tensor<dim>::Zero();
};

/// Compares the particles that lie at t = 0 at least `depth` inside the box.
template <int dim>
Deviation compare(const Snapshot& shot, const SolidScene<dim>& scene, double depth, const Expected<dim>& expected) {
    Deviation most;
    for (std::size_t p = 0; p < shot.points(); ++p) {
        const Vec<dim> X = vector_at<dim>(shot.X, p);
        if (((X - scene.lower).array() < depth).any() || ((scene.upper - X).array() < depth).any()) continue;
        ++most.particles;
        Deviation::enlarge(most.displacement, vector_at<dim>(shot.field("displacement").values, p),
                           expected.displacement(X));
        Deviation::enlarge(most.velocity, vector_at<dim>(shot.field("velocity").values, p), expected.velocity(X));
        Deviation::enlarge(most.strain, tensor_at<dim>(shot.field("strain").values, p), expected.strain);
        Deviation::enlarge(most.stress, tensor_at<dim>(shot.field("stress").values, p), expected.stress);
    }
    return most;
}

void check_below(const Deviation& most, double tolerance) {
    INFO("u " << shortest(most.displacement) << ", v " << shortest(most.velocity) << ", strain "
              << shortest(most.strain) << ", stress " << shortest(most.stress));
    CHECK(most.displacement < tolerance);
    CHECK(most.velocity < tolerance);
    CHECK(most.strain < tolerance);
    CHECK(most.stress < tolerance);
}

template <int dim>
Tensor<dim> leading_block(const Tensor<3>& full) {
    return full.topLeftCorner<dim, dim>();
}

Tensor<3> full_matrix() {
    Tensor<3> A;
    A << 0.31, -0.52, 0.23, 0.74, -0.15, 0.46, -0.67, 0.88, 0.09;
    return A;
}

template <int dim>
Tensor<dim> hooke(const Moduli& C, const Tensor<dim>& dL) {
    Tensor<dim> sigma;
    for (int i = 0; i < dim; ++i) {
        for (int j = 0; j < dim; ++j) sigma(i, j) = (i == j ? C.lambda * dL.trace() : 0) + C.mu * (dL(i, j) + dL(j, i));
    }
    return sigma;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("patch: a skew translation over several cells stays exact", "[property]", ((int dim), dim), 1, 2,
                       3) {
    const auto stress_update = GENERATE(from_range(stress_updates));
    const auto strain_increment = GENERATE(from_range(strain_increments));
    INFO(stress_update << ", " << strain_increment);
    const Vec<dim> v0 = Vec<dim>(Vec<3>(1.0, -0.6, 0.35).head<dim>());
    const Vec<dim> edges = Vec<dim>(Vec<3>(0.9, 0.6, 0.6).head<dim>());
    const auto scene = box<dim>(edges, Face::free, uniform<dim>(v0));
    const auto body =
        started(scene, {{"stress_update", stress_update}, {"strain_increment", strain_increment}, {"margin", 1.0}},
                {{"cells", 3.0}, {"ppc", 2.0}, {"dt", 0.02}});
    // A time at which no step puts a particle almost onto a cell face with nothing beyond: USL enlarges round-off by
    // the inverse of such a node's share of mass, and exactly on the face the node has no mass and no velocity at all.
    const double t = 0.71;
    body->advance_to(t, never);
    const auto same = [&](const Vec<dim>&) { return v0; };
    const auto moved = [&](const Vec<dim>&) -> Vec<dim> { return v0 * t; };
    const Deviation most = compare<dim>(body->snapshot(), scene, 0, {moved, same});
    CHECK(most.particles == static_cast<int>(body->snapshot().points()));
    CHECK(body->work()[2].value > most.particles);  // more than one crossing a particle
    check_below(most, 1e-14);                       // 36 steps add velocities near 1, each rounded to an ulp
}

TEMPLATE_TEST_CASE_SIG("patch: a general uniform velocity gradient strains its first step exactly", "[property]",
                       ((int dim), dim), 1, 2, 3) {
    const auto stress_update = GENERATE(as<std::string>{}, "usf", "usl", "musl");  // one update a step
    const auto strain_increment = GENERATE(from_range(strain_increments));
    const auto placement = GENERATE(as<std::string>{}, "cell_centred", "even_interior", "gauss");
    const auto law_name = GENERATE(as<std::string>{}, "E ln F", "E(1-1/F)", "E(F-1)");
    INFO(stress_update << ", " << strain_increment << ", " << placement << ", " << law_name);
    const Tensor<dim> A = leading_block<dim>(full_matrix());
    const Vec<dim> edges = Vec<dim>(Vec<3>(1.2, 1.0, 1.0).head<dim>());
    const Moduli C{.lambda = 0.7, .mu = 0.4};
    const double dt = 0.1;
    const double h = 0.2;
    auto scene =
        box<dim>(edges, Face::free, pointwise<dim>([A](const Vec<dim>& X, double) { return Vec<dim>(A * X); }));
    scene.law = make_law(law_name, C);
    const auto body = started(
        scene, {{"stress_update", stress_update}, {"strain_increment", strain_increment}, {"placement", placement}},
        {{"cells", 6.0}, {"ppc", 3.0}, {"dt", dt}});
    body->advance_to(dt, never);

    const Tensor<dim> dL = dt * A;
    const Tensor<dim> moved_dL = dL * (Tensor<dim>::Identity() + dL).inverse();
    Expected<dim> expected;
    expected.displacement = [&](const Vec<dim>& X) -> Vec<dim> { return dL * X; };
    expected.velocity = [&](const Vec<dim>& X) -> Vec<dim> { return A * X; };
    expected.strain = dL;
    expected.stress = hooke<dim>(C, strain_increment == "moved_mesh" ? moved_dL : dL);
    // Nodes on a face have particles on one side only; a particle one cell inside touches none of them. Under USF the
    // new stress already pulls within the step, so that motion is free of the faces two cells inside.
    const auto particles_inside = [&](double depth) {
        return std::lround(((edges.array() - 2 * depth) / h).prod() * std::pow(3, dim));
    };
    const Deviation strained = compare<dim>(body->snapshot(), scene, h, expected);
    CHECK(strained.particles == particles_inside(h));
    CHECK(strained.strain < 1e-14);
    CHECK(strained.stress < 1e-14);
    const double depth = stress_update == "usf" ? 2 * h : h;
    const Deviation moved = compare<dim>(body->snapshot(), scene, depth, expected);
    CHECK(moved.particles == particles_inside(depth));
    CHECK(moved.displacement < 1e-14);
    CHECK(moved.velocity < 1e-14);
}

TEMPLATE_TEST_CASE_SIG("patch: a simple shear stays exact over many steps and cell crossings", "[property]",
                       ((int dim), dim), 2, 3) {
    const auto stress_update = GENERATE(from_range(stress_updates));
    const auto strain_increment = GENERATE(from_range(strain_increments));
    INFO(stress_update << ", " << strain_increment);
    // v = (g y + k z, 0, 0) and a common skew flight. A node without its full share of particles is wrong, so are the
    // particles of its cells, and with them the nodes of the next cell: a face is felt one cell further in with every
    // mapping, MUSL has two a step, and the body's motion against the grid between two steps can bring one more. So
    // `count` steps reach 3 count cells; one more is left for the rows' sliding, (|g| + |k|) t times that reach. The
    // middle cell is free of it all.
    const int count = dim == 2 ? 8 : 4;
    const int ppc = dim == 2 ? 2 : 1;
    const int reach = 3 * count + 1;
    const int cells = 2 * reach + 1;
    const double h = 0.1;
    const double dt = 0.01;
    Tensor<dim> A = Tensor<dim>::Zero();
    A(0, 1) = 0.45;
    if constexpr (dim == 3) A(0, 2) = -1.3;
    const Vec<dim> flight = Vec<dim>(Vec<3>(5, -4, 3.5).head<dim>());  // 0.35 to 0.5 cells a step
    const auto velocity = [A, flight](const Vec<dim>& X) -> Vec<dim> { return A * X + flight; };
    auto scene = box<dim>(Vec<dim>::Constant(cells * h), Face::free,
                          pointwise<dim>([velocity](const Vec<dim>& X, double) { return velocity(X); }));
    const auto law = std::get<LogarithmicLaw>(scene.law);
    const auto body =
        started(scene, {{"stress_update", stress_update}, {"strain_increment", strain_increment}, {"margin", 0.5}},
                {{"cells", double(cells)}, {"ppc", double(ppc)}, {"dt", dt}});
    body->advance_to(count * dt, never);

    Expected<dim> expected;
    expected.displacement = [&](const Vec<dim>& X) -> Vec<dim> { return count * dt * velocity(X); };
    expected.velocity = velocity;
    expected.strain = count * dt * A;
    // A A = 0: the moved mesh gives the same increment, and F = I + t A.
    const int updates = stress_update == "usavg" ? 2 : 1;
    for (int k = 0; k < count * updates; ++k)
        expected.stress = law.template updated<dim>(expected.stress, Tensor<dim>(dt / updates * A));
    const Deviation most = compare<dim>(body->snapshot(), scene, reach * h, expected);
    CHECK(most.particles == std::lround(std::pow(ppc, dim)));
    CHECK(body->work()[2].value > 0);
    CHECK(expected.stress.cwiseAbs().maxCoeff() > 1e-3);
    check_below(most, 1e-13);  // velocities near 5 rounded `count` times, over h = 0.1 in the gradients
}

TEMPLATE_TEST_CASE_SIG("patch: uniform pre-stress between fixed faces stays at rest to the bit", "[property]",
                       ((int dim), dim), 1, 2, 3) {
    const auto stress_update = GENERATE(from_range(stress_updates));
    const auto strain_increment = GENERATE(from_range(strain_increments));
    INFO(stress_update << ", " << strain_increment);
    // Lengths, volumes and stresses are short binary fractions: every sum of forces is exact, and exactly zero.
    SolidScene<dim> scene = box<dim>(Vec<dim>::Ones(), Face::fixed, uniform<dim>(Vec<dim>::Zero()));
    scene.lower = Vec<dim>::Constant(0.5);
    scene.upper = Vec<dim>::Constant(1.5);
    scene.rho = 1;
    Mpm<dim> body(scene, options_of({{"stress_update", stress_update}, {"strain_increment", strain_increment}}),
                  {.cells = 4, .ppc = 2, .h = 0.25, .dt = 0.1}, true);
    Tensor<3> full;
    full << 0.75, -0.5, 0.25, -0.5, 1.25, 0.375, 0.25, 0.375, -0.625;
    const Tensor<dim> pre_stress = leading_block<dim>(full);
    for (auto& sigma : body.particles().sigma) sigma = pre_stress;
    for (int k = 0; k < 100; ++k) body.step(0.1 * k, 0.1, 0.1);
    for (std::size_t p = 0; p < body.particles().size(); ++p) {
        REQUIRE(body.particles().x[p] == body.particles().X[p]);
        REQUIRE(body.particles().v[p].isZero(0));
        REQUIRE(body.particles().sigma[p] == pre_stress);
        REQUIRE(body.particles().F[p].isIdentity(0));
    }
}

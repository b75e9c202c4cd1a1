// How the grid gives velocity back, kind by kind, in one step of a body without forces.
#include <Eigen/Eigenvalues>
#include <random>

#include "tests/catch.hpp"
#include "tests/solvers/mpm/variants.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

constexpr double dt = 1e-3;
const Resolution sixth{.cells = 6, .ppc = 2, .h = 1.0 / 6, .dt = dt};

template <int dim>
SolidScene<dim> plate() {
    return box<dim>(Vec<dim>::Ones(), Face::free, uniform<dim>(Vec<dim>::Zero()));
}

/// A body whose particles lie off their lattice and have the velocities v(x).
template <int dim, class Velocity>
Mpm<dim> scattered(const Given& options, Velocity v) {
    Mpm<dim> body(plate<dim>(), options_of(options), sixth, true);
    std::mt19937 bits(9);
    std::uniform_real_distribution<double> any(-0.02, 0.02);
    auto& p = body.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (int axis = 0; axis < dim; ++axis) p.x[i][axis] += any(bits);
        p.v[i] = v(p.x[i]);
    }
    return body;
}

Vec<1> wavy(const Vec<1>& x) { return Vec<1>(std::sin(9 * x[0]) + 0.4 * std::cos(31 * x[0])); }

std::vector<double> velocities_after_a_step(const Given& options) {
    auto body = scattered<1>(options, wavy);
    body.step(0, dt, dt);
    std::vector<double> v;
    for (const auto& value : body.particles().v) v.push_back(value[0]);
    return v;
}

std::vector<double> positions_after_a_step(const Given& options) {
    auto body = scattered<1>(options, wavy);
    body.step(0, dt, dt);
    std::vector<double> x;
    for (const auto& value : body.particles().x) x.push_back(value[0]);
    return x;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
    return most;
}

/// Velocities and gradients of an affine field after a step, as far as a node of one cell inside is concerned.
template <int dim>
double affine_defect(const Given& options) {
    Tensor<3> full;
    full << 0.2, -1.1, 0.3, 0.9, -0.4, 0.5, -0.7, 0.1, 0.3;  // mostly a rotation
    const Tensor<dim> A = full.topLeftCorner<dim, dim>();
    const auto field = [&](const Vec<dim>& x) -> Vec<dim> { return A * x + Vec<dim>::Constant(0.3); };
    auto body = scattered<dim>(options, field);
    for (auto& L : body.particles().L) L = A;
    const auto x = body.particles().x;
    body.step(0, dt, dt);
    double worst = 0;
    const auto& p = body.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
        worst = std::max(worst, (p.v[i] - field(x[i])).norm());
        if (!p.L.empty()) worst = std::max(worst, 0.1 * (p.L[i] - A).norm());
        worst = std::max(worst, 0.1 * (p.F[i] - Tensor<dim>::Identity() - dt * A).norm() / dt);
    }
    return worst;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("transfers: affine ones keep an affine field of a body off its lattice", "[property]",
                       ((int dim), dim), 1, 2, 3) {
    struct Kind {
        std::string transfer, basis, stress_update;
    };
    // The new stress of USF would pull within the step; USL's strain is that of the mapped field.
    const auto kind = GENERATE(values<Kind>({{"tpic", "linear", "usl"},
                                             {"tpic", "quadratic", "usl"},
                                             {"tpic", "cubic", "musl"},
                                             {"apic", "quadratic", "usl"},
                                             {"apic", "cubic", "musl"},
                                             {"mls", "quadratic", "usl"},
                                             {"mls", "cubic", "usl"}}));
    INFO(kind.transfer << ", " << kind.basis << ", " << kind.stress_update);
    const double defect =
        affine_defect<dim>({{"transfer", kind.transfer}, {"basis", kind.basis}, {"stress_update", kind.stress_update}});
    CHECK(defect < 1e-11);  // MLS and APIC divide by the spread, MUSL's strain by light nodes' mass
}

TEST_CASE("transfers: the others lose the affine field there", "[alarm]") {
    CHECK(affine_defect<2>({{"transfer", "pic"}, {"stress_update", "usl"}}) > 1e-2);
    CHECK(affine_defect<2>({{"transfer", "flip"}, {"stress_update", "usl"}}) > 1e-2);  // in its strain
}

TEST_CASE("transfers: a blend is its shares of flip and pic", "[unit]") {
    const auto flip = velocities_after_a_step({{"transfer", "flip"}});
    const auto pic = velocities_after_a_step({{"transfer", "pic"}});
    const auto blend = velocities_after_a_step({{"transfer", "blend"}, {"flip_share", 0.7}});
    for (std::size_t k = 0; k < flip.size(); ++k) CHECK(blend[k] == Approx(0.7 * flip[k] + 0.3 * pic[k]).margin(1e-14));
    CHECK(distance(flip, pic) > 0.01);
}

TEST_CASE("transfers: of one term XPIC and FMPM have the velocities of pic, and means for the positions", "[unit]") {
    const Given usl{{"stress_update", "usl"}, {"k", 1.0}};
    const Given xpic = Variant{{{"transfer", "xpic"}}}.with(usl);
    const Given fmpm = Variant{{{"transfer", "fmpm"}, {"mass", "fmpm"}}}.with(usl);
    const Given pic = Variant{{{"transfer", "pic"}}}.with(usl);
    const auto v = velocities_after_a_step(pic);
    CHECK(distance(velocities_after_a_step(xpic), v) < 1e-14);
    CHECK(distance(velocities_after_a_step(fmpm), v) < 1e-14);
    const auto before = scattered<1>(pic, wavy);
    const auto x_pic = positions_after_a_step(pic);
    const auto x_xpic = positions_after_a_step(xpic);
    const auto x_fmpm = positions_after_a_step(fmpm);
    for (std::size_t k = 0; k < v.size(); ++k) {
        // Without force S m^-1 p is pic's own velocity v: x + dt v + dt (v - v_old) / 2, and x + dt (v + v_old) / 2.
        const double x = before.particles().x[k][0];
        const double v_old = before.particles().v[k][0];
        CHECK(x_pic[k] == Approx(x + dt * v[k]).epsilon(1e-14));
        CHECK(x_xpic[k] == Approx(x + dt * v[k] + 0.5 * dt * (v[k] - v_old)).epsilon(1e-14));
        CHECK(x_fmpm[k] == Approx(x + 0.5 * dt * (v[k] + v_old)).epsilon(1e-14));
    }
}

TEST_CASE("transfers: FMPM and XPIC of many terms tend to the consistent mass matrix's velocities", "[property]") {
    const auto of = [](const std::string& transfer, const std::string& mass, double k) {
        return velocities_after_a_step({{"transfer", transfer}, {"mass", mass}, {"k", k}, {"stress_update", "usl"}});
    };
    const auto limit = of("fmpm", "consistent", 1);
    for (const auto& [transfer, mass] : {std::pair{"fmpm", "fmpm"}, {"xpic", "lumped"}}) {
        double last = distance(of(transfer, mass, 1), limit);
        for (const double k : {4.0, 16.0, 64.0}) {
            const double now = distance(of(transfer, mass, k), limit);
            CHECK(now < 0.8 * last);
            last = now;
        }
    }
}

TEST_CASE("transfers: pic damps, and the more filtered ones less", "[property]") {
    const auto energy = [](const Given& options) {
        auto body = scattered<1>(options, wavy);
        for (auto& sigma : body.particles().sigma) sigma.setZero();
        double sum = 0;
        body.step(0, dt, dt);
        for (std::size_t i = 0; i < body.particles().size(); ++i)
            sum += 0.5 * body.particles().m[i] * body.particles().v[i].squaredNorm();
        return sum;
    };
    const double flip = energy({{"transfer", "flip"}, {"stress_update", "usl"}});
    const double pic = energy({{"transfer", "pic"}, {"stress_update", "usl"}});
    const double xpic2 = energy({{"transfer", "xpic"}, {"k", 2.0}, {"stress_update", "usl"}});
    const double xpic8 = energy({{"transfer", "xpic"}, {"k", 8.0}, {"stress_update", "usl"}});
    const double tpic = energy({{"transfer", "tpic"}, {"stress_update", "usl"}});
    CHECK(flip > xpic8);
    CHECK(xpic8 > xpic2);
    CHECK(xpic2 > pic);
    CHECK(pic < 0.9 * flip);
    CHECK(tpic <= pic * 1.0000001);  // in the first step no gradient is known yet
}

TEST_CASE("transfers: MLS-MPM's gradients are those of the least squares in the spread", "[property]") {
    // Its internal force is that of S D^-1 (x_i - x_p): with the stress of one particle alone, f_i = -V sigma grad S_i.
    auto body = scattered<2>({{"transfer", "mls"}, {"basis", "quadratic"}, {"stress_update", "usl"}},
                             [](const Vec<2>&) { return Vec<2>(0, 0); });
    auto& p = body.particles();
    const std::size_t one = p.size() / 2 + 3;
    p.sigma[one] << 2, 0.5, 0.5, -1;
    const Vec<2> x = p.x[one];
    const double V = p.volume[one];
    const Tensor<2> sigma = p.sigma[one];
    body.step(0, dt, dt);
    Vec<2> force = Vec<2>::Zero();
    Tensor<2> moment = Tensor<2>::Zero();
    const auto& grid = body.grid();
    for (int i = 0; i < grid.nodes(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (!(grid.m[k] > 0)) continue;
        force += grid.m[k] * grid.a[k];
        moment += grid.m[k] * grid.a[k] * (grid.position(i) - x).transpose();
    }
    CHECK(force.norm() < 1e-13);
    CHECK((moment + V * sigma).norm() < 1e-13);  // sum grad S_i (x) x_i = 1
}

TEST_CASE("transfers: a composed step blends once, by the share of a whole step", "[unit]") {
    // In so short a step nothing else happens: shares of 0.7 in each of three stages would leave 0.34 of flip.
    const double moment = 1e-9;
    const auto pic = velocities_after_a_step({{"transfer", "pic"}});
    auto body = scattered<1>({{"time", "yoshida4"}, {"transfer", "blend"}, {"flip_share", 0.7}}, wavy);
    const auto before = body.particles().v;
    body.composed_step(0, moment);
    for (std::size_t k = 0; k < pic.size(); ++k)
        CHECK(body.particles().v[k][0] == Approx(0.7 * before[k][0] + 0.3 * pic[k]).margin(1e-7));
}

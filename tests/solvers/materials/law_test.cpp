#include "solvers/materials/law.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracles/plasticity/j2_simple_shear.hpp"
#include "oracles/plasticity/j2_uniaxial_strain.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using namespace ordo::solvers;

namespace {

constexpr double E = 3.0;      // Young's modulus of the 1D bar
constexpr double F_end = 1.6;  // a strain at which the three laws differ by tens of percent

struct Case {
    std::string name;
    double sigma;  ///< what the increments integrate to at F_end
};
const std::vector<Case> cases{
    {"E ln F", E* std::log(F_end)}, {"E(1-1/F)", E*(1 - 1 / F_end)}, {"E(F-1)", E*(F_end - 1)}};

template <int dim>
Tensor<dim> updated(const Law& law, const Tensor<dim>& sigma, const Tensor<dim>& dL) {
    return std::visit(
        [&]<class L>(const L& kind) -> Tensor<dim> {
            if constexpr (IncrementLaw<L, dim>) return kind.template updated<dim>(sigma, dL);
            else throw std::logic_error("no law in increments");
        },
        law);
}

template <int dim>
Tensor<dim> cauchy(const Law& law, const Tensor<dim>& F) {
    return std::visit(
        [&]<class L>(const L& kind) -> Tensor<dim> {
            if constexpr (ClosedLaw<L, dim>) return kind.template cauchy<dim>(F);
            else throw std::logic_error("no law in closed form");
        },
        law);
}

/// Stress at F_end after `count` equal steps of F; the increment is measured on the mesh before or after each step.
double integrated(const Law& law, int count, bool moved_mesh) {
    Tensor<1> sigma = Tensor<1>::Zero();
    for (int k = 0; k < count; ++k) {
        const double before = 1 + (F_end - 1) * k / count;
        const double after = 1 + (F_end - 1) * (k + 1) / count;
        sigma = updated<1>(law, sigma, Tensor<1>((after - before) / (moved_mesh ? after : before)));
    }
    return sigma(0, 0);
}

const Moduli C{.lambda = 0.7, .mu = 0.4};
const std::vector<std::string> law_names{"E ln F", "E(1-1/F)", "E(F-1)"};  // those in rates
const std::vector<std::string> closed_names{"E ln F / F", "E(F-1/F)/2"};

template <int dim>
Tensor<dim> some_stress() {
    Tensor<dim> sigma;
    for (int i = 0; i < dim; ++i) {
        for (int j = 0; j < dim; ++j) sigma(i, j) = 0.3 + 0.2 * (i + j) - 0.1 * i * j;
    }
    return sigma;
}

}  // namespace

TEST_CASE("law: the increments integrate to the law's name, at first order in the increment", "[unit]") {
    for (const auto& [name, sigma] : cases) {
        for (const bool moved_mesh : {false, true}) {
            const Law law = make_law(name, {.lambda = 0, .mu = E / 2});
            INFO(name << (moved_mesh ? ", moved mesh" : ", undeformed mesh"));
            const double coarse = integrated(law, 1000, moved_mesh) - sigma;
            const double fine = integrated(law, 2000, moved_mesh) - sigma;
            // (E + sigma) d eps multiplies E + sigma by the step's own F on the mesh before it, and (E - sigma) d eps
            // divides E - sigma by it on the moved mesh: these two pairs are exact, up to 2000 roundings.
            const bool exact = (name == "E(F-1)" && !moved_mesh) || (name == "E(1-1/F)" && moved_mesh);
            if (exact) {
                CHECK(std::abs(coarse) < 2000 * 2.3e-16 * E);
                CHECK(std::abs(fine) < 2000 * 2.3e-16 * E);
            } else {
                CHECK(std::abs(fine) < 1e-3 * sigma);
                CHECK(std::log2(coarse / fine) == Approx(1).margin(0.01));  // next term is 1e-3 of the leading one
            }
        }
    }
}

TEST_CASE("law: from zero stress every law is isotropic Hooke, component by component", "[unit]") {
    Tensor<3> dL;
    dL << 1e-3, 2e-3, -4e-3, 5e-3, -7e-3, 3e-3, 6e-3, 8e-3, 2e-3;  // no symmetry
    const double trace = 1e-3 - 7e-3 + 2e-3;
    for (const auto& name : law_names) {
        const Tensor<3> sigma = updated<3>(make_law(name, C), Tensor<3>::Zero(), dL);
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                const double hooke = (i == j ? C.lambda * trace : 0) + C.mu * (dL(i, j) + dL(j, i));
                CHECK(sigma(i, j) == Approx(hooke).epsilon(1e-14));
            }
        }
    }
    CHECK(C.p_wave() == Approx(0.7 + 2 * 0.4));
}

TEST_CASE("law: a rotation turns the stress with it, up to second order in the angle", "[unit]") {
    const Tensor<2> sigma = some_stress<2>();
    const auto defect = [&](const Law& law, double angle) {
        const Tensor<2> R = Eigen::Rotation2Dd(angle).toRotationMatrix();
        const Tensor<2> dL = R - Tensor<2>::Identity();
        return (updated<2>(law, sigma, dL) - R * sigma * R.transpose()).norm();
    };
    for (const auto& name : law_names) {
        const Law law = make_law(name, C);
        INFO(name);
        const double coarse = defect(law, 2e-3);
        const double fine = defect(law, 1e-3);
        CHECK(fine < 1e-5);
        CHECK(std::log2(coarse / fine) == Approx(2).margin(0.01));  // next term is 1e-3 of the leading one
    }
}

TEST_CASE("law: an even swelling integrates to each rate's own closed form", "[unit]") {
    // 3D, dL = dF/F times identity, bulk stiffness K = 3 lambda + 2 mu. Jaumann of Cauchy: d sigma = K d eps. Jaumann
    // of Kirchhoff: d(J sigma) = J K d eps with J = F^3. Truesdell: the terms in sigma leave - d eps sigma.
    const double K = 3 * C.lambda + 2 * C.mu;
    const std::vector<double> expected{K * std::log(F_end), K / 3 * (1 - std::pow(F_end, -3)), K * (1 - 1 / F_end)};
    for (std::size_t n = 0; n < law_names.size(); ++n) {
        const auto at_end = [&](int count) {
            Tensor<3> sigma = Tensor<3>::Zero();
            for (int k = 0; k < count; ++k) {
                const double dF = (F_end - 1) / count;
                const double d_eps = dF / (1 + dF * k);
                sigma = updated<3>(make_law(law_names[n], C), sigma, d_eps * Tensor<3>::Identity());
            }
            return sigma(2, 2);
        };
        INFO(law_names[n]);
        const double coarse = at_end(1000) - expected[n];
        const double fine = at_end(2000) - expected[n];
        CHECK(std::abs(fine) < 1e-3 * expected[n]);
        CHECK(std::log2(coarse / fine) == Approx(1).margin(0.01));
    }
}

TEST_CASE("law: the declared words are the ones that can be made", "[unit]") {
    const Parameter law = law_parameter("E(F-1)");
    CHECK(law.default_text() == "E(F-1)");
    auto names = law_names;
    names.insert(names.end(), closed_names.begin(), closed_names.end());
    CHECK(law.word_names() == names);
    for (const auto& name : law.word_names()) CHECK_NOTHROW(make_law(name, C));
    CHECK_THROWS_AS(make_law("E F", C), std::logic_error);
}

TEST_CASE("law: in one dimension the closed form is the law's name", "[unit]") {
    for (const double F : {0.3, 0.99, 1.0, 1.6, 7.0}) {
        const auto stress = [F](const std::string& name) {
            return cauchy<1>(make_law(name, {.lambda = 0, .mu = E / 2}), Tensor<1>(F))(0, 0);
        };
        CHECK(stress("E ln F") == Approx(E * std::log(F)).margin(1e-15));
        CHECK(stress("E(1-1/F)") == Approx(E * (1 - 1 / F)).margin(1e-15));
        CHECK(stress("E(F-1)") == Approx(E * (F - 1)).margin(1e-15));
        CHECK(stress("E ln F / F") == Approx(E * std::log(F) / F).margin(1e-15));
        CHECK(stress("E(F-1/F)/2") == Approx(E / 2 * (F - 1 / F)).margin(1e-15));
    }
}

TEST_CASE("law: neo-Hookean and Hencky by hand, along the axes and in simple shear", "[unit]") {
    const Tensor<3> F = Vec<3>(1.3, 0.8, 1.1).asDiagonal();
    const double J = 1.3 * 0.8 * 1.1;
    const Tensor<3> neo = cauchy<3>(NeoHookeanLaw{C}, F);
    const Tensor<3> hencky = cauchy<3>(HenckyLaw{C}, F);
    for (int i = 0; i < 3; ++i) {
        const double a = F(i, i);
        CHECK(neo(i, i) == Approx((C.lambda * std::log(J) + C.mu * (a * a - 1)) / J));
        CHECK(hencky(i, i) == Approx((C.lambda * std::log(J) + 2 * C.mu * std::log(a)) / J));
    }
    CHECK((neo.norm() == Approx(neo.diagonal().norm()) && hencky.norm() == Approx(hencky.diagonal().norm())));
    const double gamma = 0.9;
    Tensor<2> shear = Tensor<2>::Identity();
    shear(0, 1) = gamma;
    const Tensor<2> a = cauchy<2>(NeoHookeanLaw{C}, shear);
    CHECK(a(0, 0) == Approx(C.mu * gamma * gamma));
    CHECK((a(0, 1) == Approx(C.mu * gamma) && a(1, 0) == Approx(C.mu * gamma)));
    CHECK(std::abs(a(1, 1)) < 1e-15);
    // Principal stretches k and 1/k, k = (gamma + r) / 2, r = sqrt(gamma^2 + 4), at the angle tan 2 theta = 2 / gamma.
    const double r = std::sqrt(gamma * gamma + 4);
    const double tau = 2 * C.mu * std::log((gamma + r) / 2);
    const Tensor<2> b = cauchy<2>(HenckyLaw{C}, shear);
    CHECK((b(0, 0) == Approx(tau * gamma / r) && b(1, 1) == Approx(-tau * gamma / r)));
    CHECK((b(0, 1) == Approx(tau * 2 / r) && b(1, 0) == Approx(tau * 2 / r)));
}

TEST_CASE("law: closed forms turn with the body, know no direction, and begin as Hooke's law", "[unit]") {
    const Tensor<3> R = (Eigen::AngleAxisd(0.7, Vec<3>::UnitX()) * Eigen::AngleAxisd(-1.1, Vec<3>::UnitZ())).matrix();
    Tensor<3> F;
    F << 1.2, 0.3, -0.1, 0.05, 0.9, 0.2, -0.15, 0.1, 1.05;
    for (const auto& name : closed_names) {
        const Law law = make_law(name, C);
        const Tensor<3> sigma = cauchy<3>(law, F);
        CHECK((cauchy<3>(law, R * F) - R * sigma * R.transpose()).norm() < 1e-14);
        CHECK((cauchy<3>(law, F * R) - sigma).norm() < 1e-14);
        CHECK((sigma - sigma.transpose()).norm() < 1e-15);
        const Tensor<3> small = 1e-6 * (F - Tensor<3>::Identity());
        const Tensor<3> hooke = C.lambda * small.trace() * Tensor<3>::Identity() + C.mu * (small + small.transpose());
        CHECK((cauchy<3>(law, Tensor<3>::Identity() + small) - hooke).norm() < 1e-11);  // (1e-6)^2
        CHECK(stiffness(law) == Approx(0.7 + 2 * 0.4));
    }
}

namespace {

constexpr double G = 0.4, K = 0.7 + 2.0 / 3 * 0.4;  // of C

/// Takes a J2 solid to and fro between +-peak in steps of peak / n, dL = strain increment times `mode`; look(t, sigma,
/// history) after each.
template <int dim, class Look>
void cycle(const J2Law& law, const Tensor<dim>& mode, int n, double peak, Look&& look) {
    J2Law::History history;
    for (int k = 1; k <= 7 * n; ++k) {
        const int leg = (k - 1 + n) / (2 * n);  // reversed at peak, after n, 3n, 5n, ... steps
        const double d = peak / n * (leg % 2 == 0 ? 1 : -1);
        const Tensor<dim> sigma = law.updated<dim>(history, Tensor<dim>(d * mode));
        look(k * peak / n, sigma, history);
    }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("law: J2 in uniaxial strain is exact for any step, there and back", "[unit]", ((int dim), dim),
                       1, 2, 3) {
    const double H = GENERATE(0.0, 0.15);
    const int n = GENERATE(1, 3, 20);
    const J2Law law{.C = C, .yield = 0.02, .hardening = H};
    const oracles::J2UniaxialStrain exact{
        .K = K, .G = G, .Y0 = 0.02, .H = H, .path = {.kind = oracles::StrainPath::Kind::cycle, .rate = 1, .peak = 0.1}};
    Tensor<dim> mode = Tensor<dim>::Zero();
    mode(0, 0) = 1;
    bool yielded = false;
    cycle<dim>(law, mode, n, 0.1, [&](double t, const Tensor<dim>& sigma, const J2Law::History& history) {
        const auto state = exact.at(t);
        // 140 steps of stresses up to 0.15.
        CHECK(sigma(0, 0) == Approx(state.stress).margin(1e-15 * 140));
        CHECK(history.sigma(0, 0) == sigma(0, 0));
        CHECK(history.sigma(1, 1) == Approx(state.lateral_stress).margin(1e-15 * 140));
        CHECK(history.sigma(2, 2) == Approx(state.lateral_stress).margin(1e-15 * 140));
        CHECK(history.plastic_strain == Approx(state.plastic_strain).margin(1e-15 * 140));
        yielded = yielded || state.plastic_strain > 0.05;
    });
    CHECK(yielded);
}

TEMPLATE_TEST_CASE_SIG("law: J2 in simple shear is exact for any step, there and back", "[unit]", ((int dim), dim), 2,
                       3) {
    const double H = GENERATE(0.0, 0.15);
    const int n = GENERATE(1, 3, 20);
    const J2Law law{.C = C, .yield = 0.02, .hardening = H};
    const oracles::J2SimpleShear exact{
        .G = G, .Y0 = 0.02, .H = H, .path = {.kind = oracles::StrainPath::Kind::cycle, .rate = 1, .peak = 0.1}};
    Tensor<dim> mode = Tensor<dim>::Zero();
    mode(0, 1) = mode(1, 0) = 0.5;  // without spin: the strain is small, and no axes turn
    cycle<dim>(law, mode, n, 0.1, [&](double t, const Tensor<dim>& sigma, const J2Law::History& history) {
        const auto state = exact.at(t);
        CHECK(sigma(0, 1) == Approx(state.stress).margin(1e-15 * 140));
        CHECK(std::abs(sigma(0, 0)) < 1e-15);
        CHECK(history.plastic_strain == Approx(state.plastic_strain).margin(1e-15 * 140));
    });
}

TEST_CASE("law: J2 turns its stress with the body, and yields nowhere meanwhile", "[unit]") {
    const J2Law law{.C = C, .yield = 10, .hardening = 0};
    const auto defect = [&](double angle) {
        J2Law::History history;
        history.sigma = some_stress<3>();
        const Tensor<3> R = Eigen::AngleAxisd(angle, Vec<3>(1, 2, -1).normalized()).matrix();
        const Tensor<3> before = history.sigma;
        law.updated<3>(history, Tensor<3>(R - Tensor<3>::Identity()));
        CHECK(history.plastic_strain == 0);
        return (history.sigma - R * before * R.transpose()).norm();
    };
    CHECK(std::log2(defect(2e-3) / defect(1e-3)) == Approx(2).margin(0.01));
}

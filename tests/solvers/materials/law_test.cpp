#include "solvers/materials/law.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

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
    return std::visit([&](const auto& kind) -> Tensor<dim> { return kind.template updated<dim>(sigma, dL); }, law);
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
const std::vector<std::string> law_names{"E ln F", "E(1-1/F)", "E(F-1)"};

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
    CHECK(law.word_names() == law_names);
    for (const auto& name : law.word_names()) CHECK_NOTHROW(make_law(name, C));
    CHECK_THROWS_AS(make_law("E F", C), std::logic_error);
}

// Rates under finite rotation: what a body that only turns must not feel.
#include <cmath>

#include "solvers/materials/law.hpp"
#include "tests/catch.hpp"

using namespace ordo::solvers;

TEST_CASE("law: rates turn with the body, whatever the angle of a step, where dL is taken amid it", "[property]") {
    // A body stressed at rest, then turned once round in eight steps: dL = (R - I)(I + (R - I)/2)^-1 has no strain.
    const double angle = std::atan(1.0);
    Tensor<2> R;
    R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const Tensor<2> I = Tensor<2>::Identity();
    const Tensor<2> dL = (R - I) * (I + 0.5 * (R - I)).inverse();
    const Moduli C{.lambda = 0.7, .mu = 0.4};
    Tensor<2> start;
    start << 0.3, 0.5, 0.5, 0.6;
    Tensor<2> sigma = start;
    const J2Law plastic{C, 1e-3, 0};
    J2Law::History history;
    plastic.updated<2>(history, Tensor<2>(1e-2 * start));
    const double plastic_strain = history.plastic_strain;
    CHECK(plastic_strain > 0);
    for (int k = 0; k < 8; ++k) {
        sigma = LogarithmicLaw{C}.updated<2>(sigma, dL);
        plastic.updated<2>(history, dL);
        if (k == 1) CHECK(sigma(0, 0) == Approx(start(1, 1)).epsilon(1e-13));  // a quarter turn
    }
    CHECK((sigma - start).norm() < 1e-14);
    CHECK(history.plastic_strain == Approx(plastic_strain).epsilon(1e-12));
}

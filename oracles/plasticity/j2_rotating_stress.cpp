#include "oracles/plasticity/j2_rotating_stress.hpp"

#include <algorithm>
#include <boost/math/special_functions/sinc.hpp>
#include <cmath>
#include <limits>

#include "core/elastic_constants.hpp"
#include "oracles/plasticity/uniform.hpp"

namespace ordo::oracles {
namespace {

const std::vector<FieldInfo> fields{
    {"strain", "-", 2}, {"stress", "Pa", 2}, {"plastic_strain", "-", 0}, {"plastic_work", "J/m^3", 0}};

/// [a + c, s, 0; s, a - c, 0; 0, 0, b]
J2RotatingStress::Tensor in_plane(double a, double c, double s, double b) {
    return {a + c, s, 0, s, a - c, 0, 0, 0, b};
}

/// Half of the difference of the two principal stresses in the plane.
double radius(const J2RotatingStress& solid) { return solid.Y0 * std::sqrt((1 - solid.share) * (1 + solid.share) / 3); }

Constants constants_of(const J2RotatingStress& solid) {
    const double s3 = 2 * solid.Y0 * solid.share / 3;
    return {{"K", solid.K},
            {"G", solid.G},
            {"sigma_1", -s3 / 2 + radius(solid) - solid.pressure},
            {"sigma_2", -s3 / 2 - radius(solid) - solid.pressure},
            {"sigma_3", s3 - solid.pressure}};
}

Exact bind(const Values& values) {
    const auto elastic = elastic_constants(values, elastic_constants({Elastic::E, 2e11}, {Elastic::nu, 0.3}, ""),
                                           "oracle j2_rotating_stress");
    const J2RotatingStress solid{.K = elastic.K,
                                 .G = elastic.G,
                                 .Y0 = values.number("Y0"),
                                 .spin = values.number("spin"),
                                 .plastic_rate = values.number("plastic_rate"),
                                 .share = values.number("share"),
                                 .pressure = values.number("pressure")};
    const auto everywhere = [solid](double t) {
        std::array<double, 20> row{};
        std::ranges::copy(solid.strain(t), row.begin());
        std::ranges::copy(solid.stress(t), row.begin() + 9);
        row[18] = solid.plastic_rate * t;
        row[19] = solid.Y0 * row[18];
        return row;
    };
    constexpr double anywhere = std::numeric_limits<double>::max();
    return {.dim = 3,
            .coordinates = Coordinates::material,
            .lower = std::vector<double>(3, -anywhere),
            .upper = std::vector<double>(3, anywhere),
            .times = between(0, 1e15 / std::max(std::abs(solid.spin), solid.plastic_rate)),
            .fields = fields,
            .sample = uniform(everywhere),
            .jumps = no_jumps,
            .features = no_features,
            .constants = [solid](std::optional<double>) { return constants_of(solid); }};
}

}  // namespace

J2RotatingStress::Tensor J2RotatingStress::stress(double t) const {
    const double s3 = 2 * Y0 * share / 3;
    const double d = radius(*this);
    return in_plane(-s3 / 2 - pressure, d * std::cos(2 * spin * t), d * std::sin(2 * spin * t), s3 - pressure);
}

J2RotatingStress::Tensor J2RotatingStress::strain(double t) const {
    const double s3 = 2 * Y0 * share / 3;
    const double d = radius(*this);
    const double theta = spin * t;
    const double flow = 1.5 * plastic_rate * t / Y0;  // plastic strain per mean deviator
    // Means over [0, t]: of cos 2 theta, sinc(theta) cos(theta); of sin 2 theta, sinc(theta) sin(theta).
    const double sinc = boost::math::sinc_pi(theta);
    const double c = std::cos(2 * theta) / (2 * G) + flow * sinc * std::cos(theta);
    const double s = std::sin(2 * theta) / (2 * G) + flow * sinc * std::sin(theta);
    const double out = s3 / (2 * G) + flow * s3;
    const double volume = -pressure / (3 * K);
    return in_plane(volume - out / 2, d * c, d * s, volume + out);
}

Oracle j2_rotating_stress() {
    const auto parameters =
        appended(elastic_parameters("E 2e11, nu 0.3"),
                 {number("Y0", "Pa", 4e8, between(1e-100, 1e100), "yield stress in tension, constant"),
                  number("spin", "rad/s", 1, finite, "angular velocity of the principal axes about e3"),
                  number("plastic_rate", "1/s", 0.01, at_least(0), "d (equivalent plastic strain) / dt"),
                  number("share", "-", 0, between(-1, 1), "s3 / (2 Y0 / 3); 0 is pure shear in the plane"),
                  number("pressure", "Pa", 0, between(-1e100, 1e100), "mean stress, compression positive")});
    return {
        .name = "j2_rotating_stress",
        .about = "Perfect von Mises plasticity with resting principal stresses and spinning principal axes",
        .source = {"BrannonLeelavanichkul2010", "SimoHughes1998"},
        .explanation =
            "Small strain, isotropic elasticity with K and G, von Mises yield q = Y0 without hardening, associated\n"
            "flow. The strain (prescribe it) is such that the stress (the answer) keeps its principal values while\n"
            "its axes turn about e3 by theta = spin t, with plastic flow at a constant rate all the time:\n"
            "  stress = R(theta) (diag(s1, s2, s3) - pressure I) R(theta)^T,   s1 + s2 + s3 = 0\n"
            "  s3 = 2 Y0 share / 3,   s1, s2 = -s3 / 2 +- Y0 sqrt((1 - share^2) / 3)\n"
            "  strain = s / (2 G) - pressure / (3 K) I + 3 plastic_rate / (2 Y0) (integral of s dt from 0),  s = dev "
            "stress\n"
            "The turning s is orthogonal to its rate: the yield function stays 0 for any plastic_rate >= 0; 0 is\n"
            "neutral loading. At t = 0 the solid stands at yield: reach strain(0) elastically, then follow\n"
            "strain(t). A backward Euler radial return converges to the stress with order 1; where plastic_rate or\n"
            "spin is 0 it is exact.\n"
            "Tensors are 3 x 3, row by row, tension positive; plastic_strain = plastic_rate t is the equivalent one,\n"
            "plastic_work Y0 plastic_strain. Nothing depends on x, a point of three coordinates.\n"
            "Refused: an angle or plastic strain beyond 1e15, where a double t tells no place.\n"
            "constants: K, G, sigma_1, sigma_2, sigma_3 (principal stresses)",
        .example = "j2_rotating_stress --set spin=2 --t 0.4 --x 0:0:0",
        .parameters = parameters,
        .fields = fields,
        .smoothness = "constant in x, analytic in t",
        .accuracy =
            "4 ulp of Y0 + |pressure| (stress) and of Y0 / G + |pressure| / K + plastic_rate t (strain), times 1 + "
            "|spin| t",
        .bind = bind};
}

}  // namespace ordo::oracles

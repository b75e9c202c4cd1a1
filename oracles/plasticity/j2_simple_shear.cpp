#include "oracles/plasticity/j2_simple_shear.hpp"

#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "core/elastic_constants.hpp"
#include "oracles/plasticity/uniform.hpp"

namespace ordo::oracles {
namespace {

constexpr double root_three = boost::math::constants::root_three<double>();

const std::vector<FieldInfo> fields{{"strain", "-", 2},
                                    {"stress", "Pa", 2},
                                    {"plastic_strain", "-", 0},
                                    {"yield_stress", "Pa", 0},
                                    {"equivalent_stress", "Pa", 0},
                                    {"plastic_work", "J/m^3", 0},
                                    {"elastic_energy", "J/m^3", 0}};

Constants constants_of(const J2SimpleShear& solid) {
    return {{"G", solid.G},
            {"yield_strain", solid.yield_strain()},
            {"elastic_slope", solid.G},
            {"plastic_slope", solid.plastic_slope()}};
}

Exact bind(const Values& values) {
    const auto elastic = elastic_constants(values, elastic_constants({Elastic::E, 2e11}, {Elastic::nu, 0.3}, ""),
                                           "oracle j2_simple_shear");
    const J2SimpleShear solid{
        .G = elastic.G, .Y0 = values.number("Y0"), .H = values.number("H"), .path = strain_path(values)};
    const auto row = [solid](double t) {
        const auto s = solid.at(t);
        return std::array{s.strain,       s.stress,        s.plastic_strain, s.yield_stress, s.equivalent_stress,
                          s.plastic_work, s.elastic_energy};
    };
    return on_strain_path(solid.path, fields, row, constants_of(solid));
}

}  // namespace

J2SimpleShear::State J2SimpleShear::at(double t) const {
    const ScalarJ2 law{.k = root_three * G, .G = G, .Y0 = Y0, .H = H, .path = path};
    const auto [strain, q, p] = law.at(t);
    return {.strain = strain,
            .stress = q / root_three,
            .plastic_strain = p,
            .yield_stress = Y0 + H * p,
            .equivalent_stress = std::abs(q),
            .plastic_work = law.plastic_work(p),
            .elastic_energy = q * q / (6 * G)};
}

double J2SimpleShear::yield_strain() const { return Y0 / (root_three * G); }
double J2SimpleShear::plastic_slope() const { return G * H / (3 * G + H); }

Oracle j2_simple_shear() {
    return {
        .name = "j2_simple_shear",
        .about = "Von Mises plasticity in simple shear: hardening, unloading, any number of reversals",
        .source = {"SimoHughes1998"},
        .explanation =
            "Small strain: gamma = du_x/dy alone (twice the tensor component), the field `strain`; `stress` is the\n"
            "shear stress tau. Von Mises yield sqrt(3) |tau| <= Y = Y0 + H p, associated flow; p is the equivalent\n"
            "plastic strain, accumulated in either direction (isotropic hardening: the yield stress never falls).\n"
            "  first loading: tau = G gamma to gamma_y = Y0 / (sqrt(3) G),\n"
            "  then p = (sqrt(3) G gamma - Y0) / (3 G + H), tau = Y / sqrt(3)\n"
            "  after a reversal at tau: elastic over a strain 2 |tau| / G, then plastic with slope G H / (3 G + H)\n"
            "plastic_work is the integral of Y dp, elastic_energy tau^2 / (2 G), both per volume. Of the elastic\n"
            "constants only G matters.\n" +
            strain_path_text() +
            "\nNothing depends on x. constants: G, yield_strain, elastic_slope, plastic_slope (d stress / d strain)",
        .example = "j2_simple_shear --set path=cycle --set H=1e9 --t 0.025 --x 0",
        .parameters = j2_parameters(),
        .fields = fields,
        .smoothness = "constant in x; piecewise linear in t, kinks at reversals and at yield",
        .accuracy = "8 ulp of Y0 + G s in stress and of s in strain, with s = |rate| t",
        .bind = bind};
}

}  // namespace ordo::oracles

#include "oracles/plasticity/j2_uniaxial_strain.hpp"

#include <array>
#include <cmath>

#include "core/elastic_constants.hpp"
#include "oracles/plasticity/uniform.hpp"

namespace ordo::oracles {
namespace {

const std::vector<FieldInfo> fields{{"strain", "-", 2},           {"stress", "Pa", 2},
                                    {"lateral_stress", "Pa", 0},  {"plastic_strain", "-", 0},
                                    {"yield_stress", "Pa", 0},    {"equivalent_stress", "Pa", 0},
                                    {"plastic_work", "J/m^3", 0}, {"elastic_energy", "J/m^3", 0}};

Constants constants_of(const J2UniaxialStrain& solid) {
    return {{"K", solid.K},
            {"G", solid.G},
            {"yield_strain", solid.yield_strain()},
            {"elastic_slope", solid.elastic_slope()},
            {"plastic_slope", solid.plastic_slope()}};
}

Exact bind(const Values& values) {
    const J2UniaxialStrain fallback;
    const auto elastic = elastic_constants(
        values, elastic_constants({Elastic::K, fallback.K}, {Elastic::G, fallback.G}, ""), "oracle j2_uniaxial_strain");
    const J2UniaxialStrain solid{.K = elastic.K,
                                 .G = elastic.G,
                                 .Y0 = values.number("Y0"),
                                 .H = values.number("H"),
                                 .path = strain_path(values)};
    const auto row = [solid](double t) {
        const auto s = solid.at(t);
        return std::array{s.strain,         s.stress,        s.lateral_stress,
                          s.plastic_strain, s.yield_stress,  s.equivalent_stress,
                          s.plastic_work,   s.elastic_energy};
    };
    return on_strain_path(solid.path, fields, row, constants_of(solid));
}

}  // namespace

J2UniaxialStrain::State J2UniaxialStrain::at(double t) const {
    const ScalarJ2 law{.k = 2 * G, .G = G, .Y0 = Y0, .H = H, .path = path};
    const auto [strain, q, p] = law.at(t);
    const double mean = K * strain;
    return {.strain = strain,
            .stress = mean + 2 * q / 3,
            .lateral_stress = mean - q / 3,
            .plastic_strain = p,
            .yield_stress = Y0 + H * p,
            .equivalent_stress = std::abs(q),
            .plastic_work = law.plastic_work(p),
            .elastic_energy = 0.5 * mean * strain + q * q / (6 * G)};
}

double J2UniaxialStrain::yield_strain() const { return Y0 / (2 * G); }
double J2UniaxialStrain::elastic_slope() const { return K + 4 * G / 3; }
double J2UniaxialStrain::plastic_slope() const { return K + 4 * G * H / (9 * G + 3 * H); }

Oracle j2_uniaxial_strain() {
    return {
        .name = "j2_uniaxial_strain",
        .about = "Von Mises plasticity under uniaxial strain: hardening, unloading, any number of reversals",
        .source = {"SimoHughes1998"},
        .explanation =
            "Small strain: axial eps, none sideways. Isotropic elasticity with K and G, von Mises yield\n"
            "|q| <= Y = Y0 + H p with q = axial - lateral stress, associated flow; p is the equivalent plastic\n"
            "strain, accumulated in either direction (isotropic hardening: the yield stress never falls).\n"
            "  stress (axial) = K eps + 2 q / 3,   lateral_stress = K eps - q / 3;   tension is positive\n"
            "  first loading: elastic to eps_y = Y0 / (2 G), then p = (2 G eps - Y0) / (3 G + H), q = Y\n"
            "  after a reversal at q: elastic with slope K + 4 G / 3 over a strain |q| / G, then plastic with slope\n"
            "  K + 4 G H / (9 G + 3 H), which is K in perfect plasticity, H = 0, with the offset 2 Y0 / 3\n"
            "plastic_work is the integral of Y dp, elastic_energy K eps^2 / 2 + q^2 / (6 G), both per volume.\n" +
            strain_path_text() +
            "\nNothing depends on x. constants: K, G, yield_strain, elastic_slope, plastic_slope (d stress / d strain)",
        .example = "j2_uniaxial_strain --set path=cycle --set H=1e9 --t 0.025 --x 0",
        .parameters = j2_parameters(),
        .fields = fields,
        .smoothness = "constant in x; piecewise linear in t, kinks at reversals and at yield",
        .accuracy = "8 ulp of Y0 + M s in stress and of s in strain, with M = K + 4 G / 3 and s = |rate| t",
        .bind = bind};
}

}  // namespace ordo::oracles

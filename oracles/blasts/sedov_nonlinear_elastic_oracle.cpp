// The strong blast in an elastic material as the catalogue knows it.
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/blasts/sedov_nonlinear_elastic.hpp"
#include "oracles/features.hpp"

namespace ordo::oracles {
namespace {

const std::vector<FieldInfo> solid_fields{{"velocity", "m/s", 1}, {"density", "kg/m^3", 0}, {"stress", "Pa", 2},
                                          {"pressure", "Pa", 0},  {"temperature", "K", 0},  {"energy", "J/kg", 0},
                                          {"strain", "-", 2}};

constexpr double largest_share = 0.1;  // of elastic stress in the pressure behind the shock

Constants constants_of(const SedovNonlinearElastic& solid, double m2_min, std::optional<double> t) {
    const double t_max = solid.time_of(m2_min);
    const auto& blast = solid.blast();
    Constants constants{{"alpha", blast.integrals().alpha},
                        {"gamma", blast.given().gamma},
                        {"t_max", t_max},
                        {"r_max", blast.front(t_max).r}};
    if (!t) return constants;
    const auto [r, speed, core, behind] = blast.front(*t);
    constants.insert(constants.end(), {{"r_shock", r},
                                       {"shock_speed", speed},
                                       {"m2", solid.strength(*t)},
                                       {"elastic_share", solid.given().elastic_share() / solid.strength(*t)},
                                       {"v_post", behind.velocity},
                                       {"rho_post", behind.density},
                                       {"p_post", behind.pressure}});
    return constants;
}

void sample(const SedovNonlinearElastic& solid, std::span<const double> x, double t, std::span<double> values) {
    const auto front = solid.blast().front(t);
    auto out = values.begin();
    for (const double place : x) {
        const auto [velocity, density, stress, pressure, temperature, energy, strain] = solid.at(place, front);
        for (const double value : {velocity, density, stress, pressure, temperature, energy, strain}) *out++ = value;
    }
}

void check_coupling(const ElasticBlast& given, double m2_min) {
    const auto refuse = [](const std::string& problem) { throw InputError("oracle sedov_nonlinear_elastic", problem); };
    if (!(given.k + 1 > 1)) refuse("k = " + shortest(given.k) + ", but gamma = k + 1 must be > 1; nearest: k = 1e-15");
    const double share = given.elastic_share();
    if (share > largest_share * m2_min)
        refuse("m2_min = " + shortest(m2_min) + " lets the elastic stress behind the shock grow to " +
               shortest(share / m2_min) + " of the pressure, but must keep it below " + shortest(largest_share) +
               " for this material; nearest: m2_min = " + shortest(std::ceil(share / largest_share)));
}

ElasticBlast given_by(const Values& values) {
    using Material = ElasticBlast::Material;
    const auto& word = values.word("material");
    return {.E = values.number("E"),
            .rho0 = values.number("rho0"),
            .c_v = values.number("c_v"),
            .k = values.number("k"),
            .material = word == "A"   ? Material::A
                        : word == "B" ? Material::B
                                      : Material::C,
            .energy = values.number("energy")};
}

Exact bind(const Values& values) {
    const ElasticBlast given = given_by(values);
    const double m2_min = values.number("m2_min");
    check_coupling(given, m2_min);
    const SedovNonlinearElastic solid(given);
    constexpr double far = std::numeric_limits<double>::max();
    Exact exact{.dim = 1,
                .coordinates = Coordinates::spatial,
                .lower = {-far},
                .upper = {far},
                .times = {.low = 0, .high = solid.time_of(m2_min), .low_excluded = true},
                .fields = solid_fields,
                .sample = [solid](std::span<const double> x, double t,
                                  std::span<double> values) { sample(solid, x, t, values); },
                .jumps =
                    [solid](double t) {
                        const double r = solid.blast().front(t).r;
                        return std::vector{-r, r};
                    },
                .waves =
                    [solid](double t) {
                        const double r = solid.blast().front(t).r;
                        return std::vector<Wave>{{Wave::Kind::shock, -r, -r}, {Wave::Kind::shock, r, r}};
                    },
                .constants = [solid, m2_min](std::optional<double> t) { return constants_of(solid, m2_min, t); }};
    exact.features = with_singular_centre(features_of_waves(exact), true);
    return exact;
}

const std::string explanation =
    "rho_t + (rho u)_x = 0,  (rho u)_t + (rho u^2 - sigma)_x = 0,  e_t + ((e - sigma) u)_x = 0,  lambda = rho0 / rho,\n"
    "C = C_s(lambda) + c_v lambda^-k T per reference volume, sigma = C_lambda, e = rho u^2 / 2 + C / lambda.\n"
    "At t = 0 heat is released in the plane x = 0 of cold, relaxed material. `energy` counts ONE side [J/m^2].\n"
    "Two speeds, the blast's U and sqrt(E / rho0), forbid a similarity solution; where M^2 = rho0 U^2 / E is large "
    "the\n"
    "flow is Sedov's planar blast (oracle sedov) with gamma = k + 1, and the strain energy an O(1/M^2) correction:\n"
    "  R = (energy t^2 / (alpha rho0))^(1/3),  U = 2 R / (3 t),  M^2 = 4 energy / (9 alpha E R): it falls as R grows\n"
    "  u, rho, p of the gas;  T = (p + C_s'(lambda)) / (k c_v lambda^-(k + 1)),  energy = (C_s + c_v lambda^-k T) / "
    "rho0\n"
    "The law sigma = -p holds exactly, the balance laws to O(1/M^2).\n"
    "Validity: M^2 >= m2_min, that is 0 < t <= t_max = (alpha rho0 / energy)^(1/2) (4 energy / (9 alpha E "
    "m2_min))^(3/2);\n"
    "a t beyond it is refused (nearest: t_max, see the constants), and so is an m2_min that lets the elastic stress\n"
    "behind the shock exceed a tenth of the pressure. Within some 2 R / M^2 of x = 0 the stretch is so large that the\n"
    "elastic tension is no correction: there the fields are those of the limit only.\n"
    "x is the position in space on either side, u is odd in x. At a shock the state on the right holds. At x = 0 "
    "density\n"
    "is 0, and temperature, energy and strain, which grow without limit, have no value.\n"
    "constants: alpha, gamma, t_max, r_max, and with t: r_shock, shock_speed, m2 (M^2 now), elastic_share (of elastic\n"
    "stress in the pressure behind the shock), v_post, rho_post, p_post";

}  // namespace

Oracle sedov_nonlinear_elastic() {
    return {
        .name = "sedov_nonlinear_elastic",
        .about = "Blast from a plane in a nonlinear elastic material with heat, while the shock is strong",
        .source = {"Sedov1959", "KammTimmes2007", "Walker2017"},
        .explanation = explanation,
        .example = "sedov_nonlinear_elastic --t 1 --grid -0.75:0.75:101",
        .parameters =
            {number("E", "Pa", 1e-4, between(1e-100, 1e100), "Young's modulus at lambda = 1"),
             number("rho0", "kg/m^3", 1, between(1e-100, 1e100), "density at lambda = 1"),
             number("c_v", "J/(m^3 K)", 1, between(1e-100, 1e100), "heat capacity per reference volume at lambda = 1"),
             number("k", "-", 1, positive, "heat's pressure is k times its energy: gamma = k + 1"),
             word("material", "A",
                  {{"A", "C_s' = (E/3) (lambda - lambda^-2)"},
                   {"B", "C_s' = (E/2) (lambda - 1/lambda)"},
                   {"C", "C_s' = E ln lambda"}},
                  "the elastic part of the stress"),
             number("energy", "J/m^2", 0.0228957348, between(1e-100, 1e100), "released at t = 0, to one side"),
             number("m2_min", "-", 1000, at_least(10), "smallest M^2 = rho0 U^2 / E for which values are given")},
        .fields = solid_fields,
        .smoothness = "shocks at x = -r_shock and r_shock; analytic between them but for x = 0",
        .accuracy = "of the limit as oracle sedov; the limit itself is off by a few 1/M^2, relative",
        .bind = bind};
}

}  // namespace ordo::oracles

#include "oracles/riemann/riemann_nonlinear_elastic.hpp"

#include <limits>
#include <memory>

#include "oracles/features.hpp"
#include "oracles/riemann/elastic_laws.hpp"
#include "oracles/riemann/elastic_record.hpp"

namespace ordo::oracles {
namespace {

using namespace elastic;

template <class Problem>
Constants constants_of(const Problem& problem, double rho0, double x0, std::optional<double> t) {
    const auto& speeds = problem.speeds();
    std::vector<Constants> waves;
    const auto add = [&](const elastic::Wave& wave, const std::string& side, double head, double tail) {
        if (wave.pressure_rise > 0) waves.push_back(wave_record("shock", side, head, x0, t));
        if (wave.pressure_rise < 0) waves.push_back(fan_record(side, head, tail, x0, t));
    };
    add(problem.star().left, "left", speeds[0], speeds[1]);
    if (problem.has_contact()) waves.push_back(wave_record("contact", "middle", speeds[2], x0, t));
    add(problem.star().right, "right", speeds[4], speeds[3]);
    return {{"sigma_star", problem.star().sigma},
            {"v_star", problem.star().v},
            {"rho_star_L", rho0 / problem.star_left().lambda},
            {"rho_star_R", rho0 / problem.star_right().lambda},
            {"T_star_L", problem.star_left().T},
            {"T_star_R", problem.star_right().T},
            {"waves", waves}};
}

template <class Strain>
Exact exact_of(const Values& values) {
    using M = Material<Strain, PowerHeat>;
    const auto state = [&](const std::string& side) {
        return State{values.number("lambda_" + side), values.number("v_" + side), values.number("T_" + side)};
    };
    const M material{{values.number("E")}, {values.number("c_v"), values.number("k")}, values.number("rho0")};
    const double x0 = values.number("x0");
    const auto problem = std::make_shared<const RiemannNonlinearElastic<M>>(material, state("L"), state("R"), x0);
    constexpr double furthest = std::numeric_limits<double>::max();
    Exact exact{.dim = 1,
                .coordinates = Coordinates::spatial,
                .lower = {-furthest},
                .upper = {furthest},
                .fields = fields(),
                .sample = along_a_line([problem](double x, double t) { return problem->fields(x, t); }),
                .averages = over_cells([problem](double a, double b, double t) { return problem->averages(a, b, t); }),
                .jumps = [problem](double t) { return problem->jumps(t); },
                .waves = [problem](double t) { return problem->waves(t); },
                .constants = [problem, rho0 = material.rho0,
                              x0](std::optional<double> t) { return constants_of(*problem, rho0, x0, t); }};
    exact.features = features_of_waves(exact);
    return exact;
}

Exact bind(const Values& values) {
    const std::string& material = values.word("material");
    if (material == "A") return exact_of<NeoHookean>(values);
    return material == "B" ? exact_of<Reciprocal>(values) : exact_of<Logarithmic>(values);
}

std::vector<Parameter> parameters() {
    constexpr Range stretches = between(1e-3, 1e3);
    return appended(
        elastic::state_parameters(stretches),
        {number("E", "Pa", 1, positive, "stiffness where lambda = 1, T = 0"),
         number("rho0", "kg/m^3", 1, positive, "density where lambda = 1"),
         number("c_v", "J/(m^3 K)", 1, positive, "heat capacity per reference volume where lambda = 1"),
         number("k", "-", 1, between(0, 20), "how heat pushes: its pressure over its energy density; 0 not at all"),
         word("material", "A",
              {{"A", "neo-Hookean, C_s' = (E/3)(lambda - lambda^-2)"},
               {"B", "C_s' = (E/2)(lambda - 1/lambda)"},
               {"C", "logarithmic strain, C_s' = E ln lambda"}},
              "strain energy"),
         number("x0", "m", 0, finite, "where the states meet at t = 0")});
}

}  // namespace

Oracle riemann_nonlinear_elastic() {
    return {
        .name = "riemann_nonlinear_elastic",
        .about = "Riemann problem of a nonlinear elastic material with heat: shocks, fans and a contact",
        .source = {"Walker2017", "Toro2009"},
        .explanation =
            "rho_t + (rho v)_x = 0,  (rho v)_t + (rho v^2 - sigma)_x = 0,  e_t + ((e - sigma) v)_x = 0\n"
            "lambda = rho0 / rho = dx/dX,  C = C_s(lambda) + c_v lambda^-k T,  sigma = dC/dlambda at fixed T,\n"
            "e = rho v^2 / 2 + C / lambda (per length or volume in space, total_energy); energy = C / rho0 (per mass)\n"
            "  A: C_s' = (E/3)(lambda - lambda^-2)    B: C_s' = (E/2)(lambda - 1/lambda)    C: C_s' = E ln lambda\n"
            "  k: heat pushes outwards as an ideal gas with gamma = k + 1 does; 0: heat is only stored\n"
            "Two uniform states meet at x0 at t = 0; the fields depend on (x - x0)/t. sigma_lambda > 0 and\n"
            "sigma_lambda_lambda < 0 for every lambda > 0, T >= 0, k >= 0: shocks compress, rarefactions stretch, the\n"
            "solution is unique. With p = -sigma, f(p*) the velocity that a wave gives, p* solves\n"
            "  f_L(p*) + f_R(p*) + v_R - v_L = 0,   v* = v_L - f_L = v_R + f_R\n"
            "  shock p* > p_K:   [C] = -(p* + p_K)/2 [lambda],  f = sqrt(-[p][lambda] / rho0),\n"
            "                    speed v_K -+ lambda_K sqrt([p] / (-[lambda] rho0));  T rises\n"
            "  rarefaction:      T = T_K,  f = -integral of a dlambda/lambda,  a = lambda sqrt(sigma_lambda / rho0)\n"
            "T is constant along particles outside of shocks. Stress: tension positive. x is the position in space; "
            "at\n"
            "a jump the state on its right holds. These laws carry any tension, so no vacuum forms, and none is\n"
            "crushed to nothing. Refused: collisions of C (k near 0) so strong, or partings so fast, that no double\n"
            "holds the stretch.\n"
            "constants: sigma_star, v_star, rho_star_L, rho_star_R, T_star_L, T_star_R, waves [{kind shock |\n"
            "rarefaction | contact, side, speed or head and tail}]; with t their places too",
        .example = "riemann_nonlinear_elastic --t 1 --grid -4:4:17",
        .parameters = parameters(),
        .fields = fields(),
        .smoothness = "jumps at shocks and the contact, kinks at the ends of fans, analytic between",
        .accuracy =
            "sigma_star 1e-13 of Z_L c_L + Z_R c_R + rho0 (v_R - v_L)^2, v_star 1e-13 of |v_L| + |v_R| + a_L + "
            "a_R; fields 1e-13 of their largest value, times 1 + k |ln lambda|; in fans for an x that differs "
            "by 1e-14 of (|v| + a) t",
        .bind = bind};
}

}  // namespace ordo::oracles

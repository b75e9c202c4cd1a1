// riemann_gas as a line of the catalogue: declarations, constants, and how to fill in the numbers.
#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "oracles/features.hpp"
#include "oracles/riemann/gas_record.hpp"
#include "oracles/riemann/riemann_gas.hpp"

namespace ordo::oracles {
namespace {

const char* word_of(GasWave::Kind kind) {
    switch (kind) {
        case GasWave::Kind::shock: return "shock";
        case GasWave::Kind::rarefaction: return "rarefaction";
        case GasWave::Kind::contact: return "contact";
        default: return "vacuum";
    }
}

const char* word_of(GasWave::Side side) {
    return side == GasWave::Side::left ? "left" : side == GasWave::Side::right ? "right" : "middle";
}

/// One record of `waves`; positions where a time is given.
Constants record_of(const GasWave& wave, const RiemannGas& problem, std::optional<double> t) {
    Constants record{{"kind", word_of(wave.kind)}, {"side", word_of(wave.side)}};
    const auto add = [&](const std::string& speed, const std::string& place, double value) {
        record.push_back({speed, value});
        if (t) record.push_back({place, problem.position(value, *t)});
    };
    if (wave.spread()) {
        add("head", "x_head", wave.head);
        add("tail", "x_tail", wave.tail);
    } else {
        add("speed", "x", wave.head);
    }
    return record;
}

Constants constants_of(const RiemannGas& problem, std::optional<double> t) {
    const GasStar& star = problem.star();
    const auto waves = problem.waves();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    Constants constants{{"p_star", star.p}, {"v_star", star.vacuum ? none : star.v}};
    constants.push_back({"rho_star_L", star.left.rho});
    constants.push_back({"rho_star_R", star.right.rho});
    std::vector<Constants> records;
    for (const auto& wave : waves) records.push_back(record_of(wave, problem, t));
    constants.push_back({"waves", std::move(records)});
    return constants;
}

/// Its waves at time t; a vacuum's edge is one where the density jumps there: a contact between matter and nothing.
std::vector<Wave> waves_of(const RiemannGas& problem, double t) {
    std::vector<Wave> waves;
    const auto add = [&](Wave::Kind kind, double one, double other) {
        const auto [left, right] = std::minmax({problem.position(one, t), problem.position(other, t)});
        waves.push_back({kind, left, right});
    };
    const auto jumps = problem.jumps(t);
    for (const GasWave& wave : problem.waves()) {
        switch (wave.kind) {
            case GasWave::Kind::shock: add(Wave::Kind::shock, wave.head, wave.tail); break;
            case GasWave::Kind::rarefaction: add(Wave::Kind::fan, wave.head, wave.tail); break;
            case GasWave::Kind::contact:
                if (std::ranges::find(jumps, problem.position(wave.head, t)) != jumps.end())
                    add(Wave::Kind::contact, wave.head, wave.tail);
                break;
            case GasWave::Kind::vacuum:
                if (problem.star().left.rho > 0) add(Wave::Kind::contact, wave.head, wave.head);
                if (problem.star().right.rho > 0) add(Wave::Kind::contact, wave.tail, wave.tail);
                break;
        }
    }
    return waves;
}

/// gamma of one side: that of both, its own, or the default.
double gamma_of(const Values& values, const std::string& own) {
    if (values.has("gamma") && values.has(own))
        throw InputError("oracle riemann_gas",
                         "gamma and " + own +
                             " are both given, but gamma is that of both sides: give gamma, or gamma_L "
                             "and gamma_R");
    return values.has(own) ? values.number(own) : values.has("gamma") ? values.number("gamma") : Gas{}.gamma;
}

Gas side_of(const Values& values, const std::string& side) {
    return {.rho = values.number("rho_" + side),
            .v = values.number("v_" + side),
            .p = values.number("p_" + side),
            .gamma = gamma_of(values, "gamma_" + side),
            .p_inf = values.number("p_inf_" + side)};
}

Exact bind(const Values& values) {
    const RiemannGas problem(side_of(values, "L"), side_of(values, "R"), values.number("x0"));
    constexpr double furthest = std::numeric_limits<double>::max();
    Exact exact{.dim = 1,
                .coordinates = Coordinates::spatial,
                .lower = {-furthest},
                .upper = {furthest},
                .fields = gas_fields(),
                .sample = along_a_line([problem](double x, double t) { return problem.at(x, t).row(); }),
                .averages = over_cells([problem](double a, double b, double t) { return problem.mean(a, b, t).row(); }),
                .jumps = [problem](double t) { return problem.jumps(t); },
                .waves = [problem](double t) { return waves_of(problem, t); },
                .constants = [problem](std::optional<double> t) { return constants_of(problem, t); }};
    exact.features = features_of_waves(exact);
    return exact;
}

}  // namespace

Oracle riemann_gas() {
    constexpr Range above_one{.low = 1, .low_excluded = true};
    return {
        .name = "riemann_gas",
        .about = "Riemann problem of gas dynamics: ideal gases, two gammas, stiffened gases, vacuum",
        .source = {"Toro2009", "MenikoffPlohr1989"},
        .explanation =
            "Two uniform gases that touch at x0 at t = 0; what follows depends on (x - x0) / t only.\n"
            "  rho_t + (rho v)_x = 0,  (rho v)_t + (rho v^2 + p)_x = 0,  E_t + ((E + p) v)_x = 0,\n"
            "  E = rho e + rho v^2 / 2 (total_energy),  rho e = (p + gamma p_inf) / (gamma - 1) (energy is e)\n"
            "A wave runs into each gas, and between them the contact; p* and v* are the same on both sides of it:\n"
            "  F(p*) = f_L(p*) + f_R(p*) + v_R - v_L = 0,  v* = v_L - f_L = v_R + f_R,  with P = p + p_inf:\n"
            "  shock, p* > p:  f = (p* - p) / sqrt(rho (gamma P + (gamma + 1) (p* - p) / 2))\n"
            "  rarefaction:    f = 2 a / (gamma - 1) ((P* / P)^((gamma - 1) / (2 gamma)) - 1),  a^2 = gamma P / rho\n"
            "p may be negative down to -p_inf. At p + p_inf = 0 (cold) a gas bears shocks, but no rarefaction.\n"
            "Vacuum: a side with rho = 0 (and p = 0) is empty. Between the gases one opens when they part faster than\n"
            "they expand, v_R - v_L >= 2 a_L / (gamma_L - 1) + 2 a_R / (gamma_R - 1) for ideal gases; its pressure is\n"
            "0, or for stiffened gases -p_inf, the smaller one (total_energy is then p_inf). Density and momentum are "
            "0\n"
            "there, velocity and energy have no value.\n"
            "x is the position in space, velocity to the right positive. At a jump the state on its right holds.\n"
            "gamma is that of both gases; gamma_L and gamma_R are their own ones (not together with gamma).\n"
            "Refused: gamma <= 1, rho < 0, p + p_inf < 0, pressure in a vacuum, and what no double can hold.\n"
            "Means over cells are exact in all fields, through shocks and rarefactions; no quadrature.\n"
            "Constants: p_star, v_star (none where a vacuum lies between or beside the gases), rho_star_L, rho_star_R\n"
            "(at the edge of a vacuum 0, but for a free surface), waves: kind shock, rarefaction, contact or vacuum;\n"
            "side; speed, or head and tail of a rarefaction and left and right edge of a vacuum between the gases.\n"
            "With a time their places too: x, or x_head and x_tail. Waves of no strength are left out.",
        .example = "riemann_gas --t 0.2 --grid -0.5:0.5:11",
        .parameters =
            {number("rho_L", "kg/m^3", 1, at_least(0), "density on the left; 0 is a vacuum"),
             number("v_L", "m/s", 0, finite, "velocity on the left"),
             number("p_L", "Pa", 1, finite, "pressure on the left, p_L + p_inf_L >= 0"),
             number("rho_R", "kg/m^3", 0.125, at_least(0), "density on the right; 0 is a vacuum"),
             number("v_R", "m/s", 0, finite, "velocity on the right"),
             number("p_R", "Pa", 0.1, finite, "pressure on the right, p_R + p_inf_R >= 0"),
             without_default(number("gamma", "-", 1.4, above_one,
                                    "ratio of the specific heats on both sides; 1.4 where none is given")),
             without_default(number("gamma_L", "-", 1.4, above_one, "that of the left gas, instead of gamma")),
             without_default(number("gamma_R", "-", 1.4, above_one, "that of the right gas, instead of gamma")),
             number("p_inf_L", "Pa", 0, at_least(0), "stiffness of the left gas; 0 is an ideal gas"),
             number("p_inf_R", "Pa", 0, at_least(0), "stiffness of the right gas; 0 is an ideal gas"),
             number("x0", "m", 0, finite, "where the gases touch at t = 0")},
        .fields = gas_fields(),
        .smoothness = "fields jump at shocks and contacts; fans have kinks at head and tail, and are analytic inside",
        .accuracy =
            "1e-13 of p* (of |p*| and the tension in the data, where p < 0) and of |v_L| + |v_R| + a_L + a_R; near a "
            "vacuum and in rarefactions exact for data that differ by less than 1e-14",
        .bind = bind};
}

}  // namespace ordo::oracles

#include "oracles/lines/elastic_end.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/features.hpp"
#include "oracles/riemann/elastic_laws.hpp"
#include "oracles/riemann/riemann_linear_elastic.hpp"
#include "oracles/riemann/riemann_nonlinear_elastic.hpp"

namespace ordo::oracles {
namespace {

using elastic::Row;
using elastic::State;

const char* where = "oracle elastic_end";

/// The right half of a Riemann problem, from its contact on, with the one wave that is there.
template <class Problem>
struct HalfLine {
    Problem problem;
    double x0;
    double v_end;         ///< velocity of the end [m/s]
    double inner, outer;  ///< speeds of the wave's two edges; of a jump they are equal [m/s]
    bool wave;            ///< whether there is one

    double end(double t) const { return x0 + v_end * t; }
    bool is_fan() const { return inner < outer; }

    void check(double x, double t) const {
        const double round_off = 1e-12 * (std::abs(x) + std::abs(x0) + std::abs(v_end * t));
        if (x < end(t) - round_off)
            throw InputError(where, "x = " + shortest(x) + " m is beyond the end of the bar at t = " + shortest(t) +
                                        " s, nearest: x = " + shortest(end(t)));
    }
    Row at(double x, double t) const {
        check(x, t);
        return problem.fields(std::max(x, end(t)), t);
    }
    Row mean(double a, double b, double t) const {
        check(a, t);
        return a < b ? problem.averages(a, b, t) : at(a, t);
    }
    std::vector<Wave> waves(double t) const {
        if (!wave) return {};
        return {{is_fan() ? Wave::Kind::fan : Wave::Kind::shock, x0 + inner * t, x0 + outer * t}};
    }
    std::vector<double> jumps(double t) const {
        if (!wave || is_fan() || t == 0) return {};
        return {x0 + outer * t};
    }
    Constants constants(std::optional<double> t) const {
        const Row row = problem.fields(x0 + 0.5 * (v_end + inner), 1);
        Constants list{{"v_end", v_end}, {"rho_end", row[1]}, {"sigma_end", row[2]}, {"T_end", row[4]}};
        if (wave) {
            list.push_back({"wave", is_fan() ? "rarefaction" : "jump"});
            list.push_back({"tail", inner});
            list.push_back({"head", outer});
        }
        if (t) list.push_back({"x_end", end(*t)});
        return list;
    }
};

template <class Problem>
Exact exact_of(HalfLine<Problem>&& given, Feature::Kind acoustic) {
    const auto half = std::make_shared<const HalfLine<Problem>>(std::move(given));
    constexpr double furthest = std::numeric_limits<double>::max();
    Exact exact{.dim = 1,
                .coordinates = Coordinates::spatial,
                .lower = {-furthest},
                .upper = {furthest},
                .fields = elastic::fields(),
                .sample = along_a_line([half](double x, double t) { return half->at(x, t); }),
                .averages = over_cells([half](double a, double b, double t) { return half->mean(a, b, t); }),
                .jumps = [half](double t) { return half->jumps(t); },
                .waves = [half](double t) { return half->waves(t); },
                .constants = [half](std::optional<double> t) { return half->constants(t); }};
    exact.features = features_of_waves(exact, acoustic);
    return exact;
}

/// What is given, but for the law.
struct Given {
    State bar;
    bool free;
    double V, x0, rho0, c_v;
};

Exact linear(const Given& given, double E) {
    const auto& [bar, free, V, x0, rho0, c_v] = given;
    const double c0 = std::sqrt(E / rho0);
    const double closing = V - bar.v;
    if (!free && !(closing < c0 * bar.lambda))
        throw InputError(where, "V - v = " + shortest(closing) + " m/s crushes the bar to zero length, but must be " +
                                    "< c0 lambda = " + shortest(c0 * bar.lambda) +
                                    " m/s; nearest: V = " + shortest(bar.v + 0.5 * c0 * bar.lambda));
    const double v_end = free ? bar.v + c0 * (bar.lambda - 1) : V;
    const RiemannLinearElastic problem(E, rho0, c_v, elastic::mirror_image(bar, v_end), bar, x0);
    const double outer = problem.speeds()[2];
    return exact_of(HalfLine<RiemannLinearElastic>{problem, x0, v_end, outer, outer, v_end != bar.v},
                    Feature::Kind::linear);
}

template <class Strain>
Exact nonlinear(const Given& given, double E, double k) {
    using M = elastic::Material<Strain, elastic::PowerHeat>;
    const auto& [bar, free, V, x0, rho0, c_v] = given;
    const M material{{E}, {c_v, k}, rho0};
    const double v_end = free ? elastic::released_velocity(material, bar) : V;
    const RiemannNonlinearElastic<M> problem(material, elastic::mirror_image(bar, v_end), bar, x0);
    const auto& speeds = problem.speeds();
    return exact_of(HalfLine<RiemannNonlinearElastic<M>>{problem, x0, v_end, speeds[3], speeds[4], v_end != bar.v},
                    Feature::Kind::shock);
}

Exact bind(const Values& values) {
    const Given given{.bar = {values.number("lambda"), values.number("v"), values.number("T")},
                      .free = values.word("end") == "free",
                      .V = values.number("V"),
                      .x0 = values.number("x0"),
                      .rho0 = values.number("rho0"),
                      .c_v = values.number("c_v")};
    if (given.free && given.V != 0)
        throw InputError(
            where, "V = " + shortest(given.V) + " is the velocity of a wall, but the end is free; " + "nearest: V = 0");
    const double E = values.number("E");
    const double k = values.number("k");
    const std::string& material = values.word("material");
    if (material == "linear") return linear(given, E);
    if (material == "A") return nonlinear<elastic::NeoHookean>(given, E, k);
    return material == "B" ? nonlinear<elastic::Reciprocal>(given, E, k) : nonlinear<elastic::Logarithmic>(given, E, k);
}

std::vector<Parameter> parameters() {
    return {
        word("end", "wall",
             {{"wall", "a rigid wall that moves with V and holds the bar"}, {"free", "let go: no stress acts on it"}},
             "what is at the bar's left end from t = 0 on"),
        number("V", "m/s", 0.3, finite, "velocity of the wall; of a free end 0"),
        number("lambda", "-", 1, between(1e-3, 1e3), "stretch of the bar at t = 0"),
        number("v", "m/s", 0, finite, "velocity of the bar at t = 0"),
        number("T", "K", 0.5, at_least(0), "temperature of the bar at t = 0"),
        number("E", "Pa", 1, positive, "stiffness where lambda = 1, T = 0"),
        number("rho0", "kg/m^3", 1, positive, "density where lambda = 1"),
        number("c_v", "J/(m^3 K)", 1, positive, "heat capacity per reference volume where lambda = 1"),
        number("k", "-", 1, between(0, 20), "how heat pushes, not in the linear law; 0 not at all"),
        word("material", "A",
             {{"linear", "C_s' = E (lambda - 1); heat exerts no stress"},
              {"A", "neo-Hookean, C_s' = (E/3)(lambda - lambda^-2)"},
              {"B", "C_s' = (E/2)(lambda - 1/lambda)"},
              {"C", "logarithmic strain, C_s' = E ln lambda"}},
             "strain energy"),
        number("x0", "m", 0, finite, "where the end is at t = 0")};
}

}  // namespace

Oracle elastic_end() {
    return {.name = "elastic_end",
            .about = "An elastic bar that a wall pushes, pulls or stops at its end, or whose end is let go",
            .source = {"Walker2017", "Toro2009"},
            .explanation =
                "lambda = rho0 / rho = dx/dX,  C = C_s(lambda) + c_v lambda^-k T,  sigma = dC/dlambda at fixed T\n"
                "A uniform bar (lambda, v, T) fills x > x0 at t = 0. From then on a wall that moves with V holds its "
                "left end, or\n"
                "the end is free: sigma = 0. One wave runs into the bar; behind it the material moves with the end.\n"
                "  linear (k = 0), c0 = sqrt(E / rho0): a jump at (x - x0)/t = v + c0 lambda, T as it was\n"
                "    wall  lambda* = lambda - (V - v) / c0          free  lambda* = 1,  v* = v + c0 (lambda - 1)\n"
                "  A, B, C: a shock where the end compresses the bar (V > v; or it was stretched and is let go), else "
                "a fan: one\n"
                "    half of the Riemann problem of the bar and its mirror image in the end (oracle "
                "riemann_nonlinear_elastic)\n"
                "A wall holds the bar: where it retreats it pulls. Stress: tension positive. energy is internal, per "
                "mass.\n"
                "x is the position in space, x >= x0 + v_end t: points beyond the end are refused. At a jump the state "
                "ahead holds.\n"
                "Refused: V of a free end; a wall that crushes the linear bar to nothing, V - v >= c0 lambda; and what "
                "no double\n"
                "holds.\n"
                "constants: v_end, rho_end, sigma_end, T_end; wave (jump or rarefaction), tail and head (its speeds); "
                "with t x_end",
            .example = "elastic_end --t 1 --grid 0.5:2.5:21",
            .parameters = parameters(),
            .fields = elastic::fields(),
            .smoothness = "uniform beside a jump; a fan has kinks at head and tail, and is analytic inside",
            .accuracy = "as riemann_linear_elastic and riemann_nonlinear_elastic",
            .bind = bind};
}

}  // namespace ordo::oracles

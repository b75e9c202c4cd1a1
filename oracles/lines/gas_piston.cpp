#include "oracles/lines/gas_piston.hpp"

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/features.hpp"
#include "oracles/riemann/gas_record.hpp"

namespace ordo::oracles {
namespace {

Gas mirrored(Gas gas, double V) {
    gas.v = 2 * V - gas.v;
    return gas;
}

Constants constants_of(const GasPiston& piston, std::optional<double> t) {
    Constants constants{{"p_wall", piston.wall_pressure()}};
    const auto waves = piston.waves(1);
    const double x0 = piston.wall(0);
    if (!waves.empty()) {
        const auto& [kind, left, right] = waves.front();
        constants.push_back({"wave", kind == Wave::Kind::shock ? "shock" : "rarefaction"});
        constants.push_back({"tail", left - x0});
        constants.push_back({"head", right - x0});
    }
    if (t) constants.push_back({"x_wall", piston.wall(*t)});
    return constants;
}

Exact bind(const Values& values) {
    const GasPiston piston(gas_from(values, ""), values.number("V"), values.number("x0"));
    constexpr double furthest = std::numeric_limits<double>::max();
    Exact exact{.dim = 1,
                .coordinates = Coordinates::spatial,
                .lower = {-furthest},
                .upper = {furthest},
                .fields = gas_fields(),
                .sample = along_a_line([piston](double x, double t) { return piston.at(x, t).row(); }),
                .averages = over_cells([piston](double a, double b, double t) { return piston.mean(a, b, t).row(); }),
                .jumps = [piston](double t) { return piston.jumps(t); },
                .waves = [piston](double t) { return piston.waves(t); },
                .constants = [piston](std::optional<double> t) { return constants_of(piston, t); }};
    exact.features = features_of_waves(exact);
    return exact;
}

}  // namespace

GasPiston::GasPiston(const Gas& gas, double V, double x0) : x0_(x0), V_(V), both_(mirrored(gas, V), gas, x0) {}

void GasPiston::check(double x, double t) const {
    const double round_off = 1e-12 * (std::abs(x) + std::abs(x0_) + std::abs(V_ * t));
    if (x < wall(t) - round_off)
        throw InputError("oracle gas_piston", "x = " + shortest(x) + " m is behind the wall at t = " + shortest(t) +
                                                  " s, nearest: x = " + shortest(wall(t)));
}

GasFields GasPiston::at(double x, double t) const {
    check(x, t);
    return both_.at(std::max(x, wall(t)), t);
}

GasFields GasPiston::mean(double a, double b, double t) const {
    check(a, t);
    return both_.mean(a, b, t);
}

std::vector<Wave> GasPiston::waves(double t) const {
    const auto outermost = both_.waves().back();
    if (outermost.side != GasWave::Side::right) return {};
    return {wave_at(outermost, x0_, t)};
}

std::vector<double> GasPiston::jumps(double t) const {
    const auto list = waves(t);
    if (t == 0 || list.empty() || list.front().kind != Wave::Kind::shock) return {};
    return {list.front().left};
}

Oracle gas_piston() {
    return {
        .name = "gas_piston",
        .about = "A gas whose wall starts to move, into it or away from it; or that streams against a wall at rest",
        .source = {"Toro2009"},
        .explanation =
            "A uniform ideal gas (rho, v, p) fills x > x0 at t = 0; from then on its left wall moves with V.\n"
            "One wave runs into the gas, and behind it the gas moves with the wall. a^2 = gamma p / rho, M = |V - v| / "
            "a:\n"
            "  V > v, shock:        p* = p (1 + gamma (gamma + 1) / 4 M^2 + gamma M sqrt(1 + ((gamma + 1) M / 4)^2))\n"
            "  V < v, rarefaction:  p* = p (1 - (gamma - 1) / 2 M)^(2 gamma / (gamma - 1))\n"
            "and from M = 2 / (gamma - 1) on the wall runs away from the gas: between them is a vacuum. V = 0, v < 0 "
            "is a\n"
            "stream that a wall reflects. Computed as the Riemann problem of the gas with its mirror image in the "
            "wall,\n"
            "which has the velocity 2 V - v (oracle riemann_gas).\n"
            "x is the position in space, x >= x0 + V t: points behind the wall are refused. At a shock the state ahead "
            "of it\n"
            "holds. In a vacuum density and momentum are 0, velocity and energy have no value. energy is internal, per "
            "mass.\n"
            "Means over cells are exact in all fields.\n"
            "constants: p_wall; wave (shock or rarefaction), tail and head (its speeds); with t x_wall",
        .example = "gas_piston --t 1 --grid 0.5:2.5:21",
        .parameters = appended(gas_parameters("", {.rho = 1, .v = 0, .p = 1}, "of the gas at t = 0"),
                               {gamma_parameter(), number("V", "m/s", 0.5, finite, "velocity of the wall"),
                                number("x0", "m", 0, finite, "where the wall is at t = 0")}),
        .fields = gas_fields(),
        .smoothness = "uniform beside a shock; a fan has kinks at head and tail, and is analytic inside",
        .accuracy = "1e-13 of p* and of |v| + |V| + a; near a vacuum exact for data that differ by less than 1e-14",
        .bind = bind};
}

}  // namespace ordo::oracles

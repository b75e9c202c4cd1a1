#pragma once
// What the exact flows of an ideal gas along a line say of themselves: fields, states as parameters, waves.
#include <algorithm>
#include <string>
#include <vector>

#include "oracles/oracle.hpp"
#include "oracles/riemann/riemann_gas.hpp"

namespace ordo::oracles {

/// The fields of GasFields::row(), in its order.
inline const std::vector<FieldInfo>& gas_fields() {
    static const std::vector<FieldInfo> list{{"density", "kg/m^3", 0},      {"velocity", "m/s", 1},
                                             {"pressure", "Pa", 0},         {"energy", "J/kg", 0},
                                             {"momentum", "kg/(m^2 s)", 1}, {"total_energy", "J/m^3", 0}};
    return list;
}

/// rho, v and p of one uniform gas; `ending` tells it from others ("_L"), `place` says where it is ("on the left").
inline std::vector<Parameter> gas_parameters(const std::string& ending, const Gas& fallback, const std::string& place) {
    return {number("rho" + ending, "kg/m^3", fallback.rho, positive, "density " + place),
            number("v" + ending, "m/s", fallback.v, finite, "velocity " + place),
            number("p" + ending, "Pa", fallback.p, positive, "pressure " + place)};
}

inline Parameter gamma_parameter() {
    return number("gamma", "-", 1.4, {.low = 1, .low_excluded = true}, "ratio of the specific heats");
}

inline Gas gas_from(const Values& values, const std::string& ending) {
    return {.rho = values.number("rho" + ending),
            .v = values.number("v" + ending),
            .p = values.number("p" + ending),
            .gamma = values.number("gamma")};
}

/// A wave of a Riemann problem at time t, on its way from x0.
inline Wave wave_at(const GasWave& wave, double x0, double t) {
    const double head = x0 + wave.head * t;
    const double tail = x0 + wave.tail * t;
    if (wave.kind == GasWave::Kind::contact) return {Wave::Kind::contact, head, head};
    if (wave.kind == GasWave::Kind::shock) return {Wave::Kind::shock, head, head};
    return {Wave::Kind::fan, std::min(head, tail), std::max(head, tail)};
}

}  // namespace ordo::oracles

#pragma once
// A state of an elastic line and the fields that follow from it: shared by all exact solutions of such lines.
#include <array>
#include <vector>

#include "core/field.hpp"
#include "oracles/riemann/elastic_material.hpp"

namespace ordo::oracles::elastic {

struct State {
    double lambda;  ///< stretch dx/dX = rho0 / rho
    double v;       ///< velocity [m/s]
    double T;       ///< temperature [K]
};

inline constexpr std::size_t field_count = 8;
using Row = std::array<double, field_count>;

/// The fields of a Row, in its order.
inline const std::vector<FieldInfo>& fields() {
    static const std::vector<FieldInfo> list{
        {"velocity", "m/s", 1},  {"density", "kg/m^3", 0}, {"stress", "Pa", 2},           {"strain", "-", 2},
        {"temperature", "K", 0}, {"energy", "J/kg", 0},    {"momentum", "kg/(m^2 s)", 1}, {"total_energy", "J/m^3", 0}};
    return list;
}

/// Velocity, density, stress, strain lambda - 1, temperature, internal energy per mass, momentum and total energy per
/// volume in space.
template <class M>
Row fields_of(const M& material, const State& state) {
    const auto& [lambda, v, T] = state;
    const double rho = material.rho0 / lambda;
    const Stretch s = stretch(lambda);
    const double e = material.energy(s, T) / material.rho0;
    return {v, rho, material.at(s, T).slope, lambda - 1, T, e, rho * v, rho * (0.5 * v * v + e)};
}

}  // namespace ordo::oracles::elastic

#pragma once
// The bars that the tests of bar_traction ask, and their catalogue entry.
#include <string>
#include <vector>

#include "tests/oracles/bars/bar_traction_gate.hpp"

namespace ordo::oracles::gate::loaded {

inline constexpr double pi = 3.141592653589793;
using Profile = BarTraction::Profile;

/// A bar of the given wave count omega L / c.
inline BarTraction sine(double L, double E, double rho, double tau, double theta) {
    return {.L = L, .E = E, .rho = rho, .tau = tau, .omega = theta * std::sqrt(E / rho) / L};
}

/// Default and off default; slow and fast loads, at the first and fifth resonance, next to one, and steps.
inline std::vector<BarTraction> loaded_bars() {
    return {{},
            {.profile = Profile::step},
            {.L = 0.3, .E = 2.1e11, .rho = 7850, .tau = -3e6, .profile = Profile::step},
            sine(1.7, 0.02, 13, 1e-4, 1.1),
            sine(0.3, 2.1e11, 7850, -3e6, 5.3),
            sine(25, 100, 1, 0.3, 0.4),
            sine(1.3, 7, 2, 0.3, pi / 2),
            sine(1.3, 7, 2, -5, 1.5 * pi),
            sine(2.5, 3, 2, 0.3, pi / 2 * (1 + 1e-7)),
            sine(2.5, 3, 2, 0.3, pi / 2 * (1 - 1e-3))};
}

inline std::string name_of(const BarTraction& bar) {
    return (bar.profile == Profile::step ? "step" : "sine") + std::string(", L = ") + std::to_string(bar.L) +
           ", omega L / c = " + std::to_string(bar.omega * bar.L / bar.wave_speed());
}

inline Exact bound_bar(const Given& given) {
    const Oracle oracle = bar_traction();
    return oracle.bind(resolve(oracle.parameters, given, "", "bar_traction"));
}

inline Given given_by(const BarTraction& bar) {
    return {{"L", bar.L},     {"E", bar.E},         {"rho", bar.rho},
            {"tau", bar.tau}, {"omega", bar.omega}, {"profile", bar.profile == Profile::step ? "step" : "sine"}};
}

inline Row row_at(const Exact& exact, double X, double t) {
    Row row{};
    exact.sample({&X, 1}, t, row);
    return row;
}
inline Row mean_over(const Exact& exact, double a, double b, double t) {
    const std::array edges{a, b};
    Row row{};
    exact.averages(edges, t, row);
    return row;
}

}  // namespace ordo::oracles::gate::loaded

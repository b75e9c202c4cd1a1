#include "oracles/riemann/gas_side.hpp"

#include <cmath>

namespace ordo::oracles {

GasSide::Cooling GasSide::cooling(double s) const {
    const double exponent = m * s;
    if (exponent > -0.7) {
        const double change = std::expm1(exponent);
        return {1 + change, change};
    }
    const double c = std::exp(exponent);
    return {c, c - 1};
}

// Square roots are taken apart where a product or quotient of data could leave the range of double.
GasSide::GasSide(const Gas& ahead)
    : gas(ahead),
      P(ahead.p + ahead.p_inf),
      a(ahead.rho > 0 ? std::sqrt(ahead.gamma * P) / std::sqrt(ahead.rho) : 0),
      n(2 / (ahead.gamma - 1)),
      m((ahead.gamma - 1) / (2 * ahead.gamma)),
      root_rho(std::sqrt(ahead.rho)),
      fan_slope(a / ahead.gamma) {}

GasSide::Wave GasSide::shock(double d) const {
    const double rise = 0.5 * (gas.gamma + 1) * d;
    const double stiffness = gas.gamma * P + rise;
    const double by_flux = 1 / (root_rho * std::sqrt(stiffness));  // over the mass through the shock, rho S
    if (d == 0) return {0, by_flux};
    return {d * by_flux, (1 - 0.5 * rise / stiffness) * by_flux};
}

GasSide::Wave GasSide::fan(double s) const {
    const auto [c, change] = cooling(s);
    return {n * a * change, fan_slope * c};
}

GasSide::Wave GasSide::wave(double d, double P_star) const {
    if (d >= 0) return shock(d);
    const Wave by_s = fan(log_ratio(d, P_star));
    return {by_s.f, by_s.slope / P_star};
}

double GasSide::curvature(double d) const {
    const double rise = 0.5 * (gas.gamma + 1);
    const double stiffness = gas.gamma * P + rise * d;
    return -rise / stiffness * (1 - 0.75 * rise * d / stiffness) / (root_rho * std::sqrt(stiffness));
}

double GasSide::log_ratio(double d, double P_star) const {
    return d > -0.5 * P ? std::log1p(d / P) : std::log(P_star / P);
}

double GasSide::shock_speed(double d) const { return std::sqrt(gas.gamma * P + 0.5 * (gas.gamma + 1) * d) / root_rho; }

GasSide::Behind GasSide::behind_shock(double d) const {
    if (d == 0) return {.rho = gas.rho, .P = P, .a = a};
    const double rho = gas.rho * (1 + d / (gas.gamma * P + 0.5 * (gas.gamma - 1) * d));
    return {.rho = rho, .P = P + d, .a = std::sqrt(gas.gamma * (P + d)) / std::sqrt(rho), .f = shock(d).f, .d = d};
}

GasSide::Behind GasSide::behind_fan(double s) const {
    const auto [c, change] = cooling(s);
    const double thinning = std::exp(s / gas.gamma);
    const double share = thinning * c * c;
    return {.rho = gas.rho * thinning, .P = P * share, .a = a * c, .c = c, .f = n * a * change, .d = P * std::expm1(s)};
}

}  // namespace ordo::oracles

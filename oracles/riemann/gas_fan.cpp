#include "oracles/riemann/gas_fan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ordo::oracles {
namespace {

/// The integral of (1 + q x)^k over 0 < x < 1 for any k.
double mean_power(double k, double q) {
    if (q == 0) return 1;
    const double L = std::log1p(q);
    return k == -1 ? L / q : std::expm1((k + 1) * L) / ((k + 1) * q);
}

/// p from P = share of P_0 in a gas that had p_0 before, whichever way keeps the digits.
double pressure(double p_0, double P_0, double share, double p_inf) {
    return share > 0.5 ? p_0 + P_0 * (share - 1) : P_0 * share - p_inf;
}

}  // namespace

GasFields fields_of(const Gas& gas, double P) {
    const auto& [rho, v, p, gamma, p_inf] = gas;
    const double internal = P / (gamma - 1) + p_inf;  // rho e
    return {rho, v, p, internal / rho, rho * v, internal + 0.5 * rho * v * v};
}

GasFields nothing(double p) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {0, none, p, none, 0, 0 - p};
}

double GasFan::contraction(double depth) const { return std::max(least, 1 - depth / ((side.n + 1) * side.a)); }

GasFields GasFan::at(double depth) const {
    const double c = contraction(depth);
    if (c <= 0) return nothing(0 - side.gas.p_inf);
    const double log_c = c > 0.5 ? std::log1p(-depth / ((side.n + 1) * side.a)) : std::log(c);
    const double thinning = std::exp(side.n * log_c);
    Gas gas = side.gas;
    gas.rho *= thinning;
    gas.v += inwards * (side.n / (side.n + 1) * depth);
    gas.p = pressure(side.gas.p, side.P, thinning * c * c, gas.p_inf);
    GasFields fields = fields_of(gas, side.P * thinning * c * c);
    // Not from P / rho, which are both 0 where a fan has thinned out beyond the smallest double.
    fields.energy = side.P / side.gas.rho * c * c / (gas.gamma - 1);
    if (gas.p_inf > 0) fields.energy += gas.p_inf / gas.rho;
    return fields;
}

// Integrating (1 + q x)^(k + 1) x^j by parts gives (1 + q)^(k + 1) = q (k + 1 + j) J_j + j J_(j - 1). With q < 0 one
// direction subtracts and the other adds: a strong fall goes upwards in j, a weak one down from a series for J_2.
std::array<double, 3> moments(double k, double q) {
    const double fall = -q;
    const double J0 = mean_power(k, q);
    const double end = std::exp((k + 1) * std::log1p(q));
    if (fall > 0.5 || fall * (k + 1) > 1) {
        const double J1 = (J0 - end) / (fall * (k + 2));
        return {J0, J1, (2 * J1 - end) / (fall * (k + 3))};
    }
    constexpr int most_terms = 100;  // each is less than (1 + (k + 1) / j) / 2 of the one before
    double term = end / 3;
    double J2 = term;
    for (int j = 4; j < most_terms && term > 1e-17 * J2; ++j) {
        term *= fall * (k + j) / j;
        J2 += term;
    }
    return {J0, 0.5 * (end + fall * (k + 3) * J2), J2};
}

GasFields GasFan::mean(double outer, double inner) const {
    const auto& [rho, v, p, gamma, p_inf] = side.gas;
    const double width = (side.n + 1) * side.a;  // of a fan that ends in a vacuum
    const GasFields start = at(outer);
    const double c = contraction(outer);
    if (c <= 0) return start;
    const double q = -std::min(1.0, (inner - outer) / width / c);
    const double gain = inwards * (side.n / (side.n + 1) * (inner - outer));
    const auto [J0, J1, J2] = moments(side.n, q);
    const double share = mean_power(side.n + 2, q);
    const double P = side.P * (start.density / rho) * c * c;
    const double square = start.velocity * start.velocity * J0 + 2 * start.velocity * gain * J1 + gain * gain * J2;
    GasFields mean{.density = start.density * J0,
                   .velocity = start.velocity + 0.5 * gain,
                   .pressure = pressure(start.pressure, P, share, p_inf),
                   .energy = side.P / rho * c * c / (gamma - 1) * (1 + q + q * q / 3),
                   .momentum = start.density * (start.velocity * J0 + gain * J1),
                   .total_energy = P * share / (gamma - 1) + p_inf + 0.5 * start.density * square};
    if (p_inf > 0) mean.energy += p_inf / start.density * mean_power(-side.n, q);
    return mean;
}

}  // namespace ordo::oracles

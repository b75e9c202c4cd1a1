#pragma once
// A claimed solution of a Riemann problem of gases, and what its gates measure it by. Everything at t = 1, where x =
// xi.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "oracles/riemann/riemann_gas.hpp"

namespace ordo::oracles::gate {

inline constexpr double eps = std::numeric_limits<double>::epsilon();
inline constexpr double tiny = 1e-290;  // below, numbers lose digits
inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline double sound(const Gas& gas, double rho, double p) {
    return rho > 0 ? std::sqrt(gas.gamma * (p + gas.p_inf)) / std::sqrt(rho) : 0;
}

/// A claimed solution, with the data that it was claimed for.
struct GasClaim {
    Gas left, right;
    std::function<GasFields(double xi)> at;
    std::function<GasFields(double a, double b)> mean;
    std::vector<GasWave> waves;

    /// The largest speed that occurs [m/s].
    double speed() const {
        double most = std::max(sound(left, left.rho, left.p), sound(right, right.rho, right.p));
        if (left.rho > 0) most = std::max(most, std::abs(left.v));
        if (right.rho > 0) most = std::max(most, std::abs(right.v));
        for (const auto& wave : waves) most = std::max({most, std::abs(wave.head), std::abs(wave.tail)});
        return most;
    }
    /// Whose gas is at xi: that on its side of the contact or of the vacuum.
    const Gas& gas_at(double xi) const {
        for (const auto& wave : waves) {
            if (wave.kind == GasWave::Kind::contact || wave.kind == GasWave::Kind::vacuum)
                return xi < wave.head ? left : right;
        }
        return left;
    }
    bool in_fan(double xi) const {
        return std::any_of(waves.begin(), waves.end(), [&](const GasWave& wave) {
            return wave.kind == GasWave::Kind::rarefaction && std::min(wave.head, wave.tail) <= xi &&
                   xi <= std::max(wave.head, wave.tail);
        });
    }
    /// Relative round-off of a flux at xi: some forty roundings of numbers of the size of its scale. In a fan
    /// that of xi comes on top, times rho' / rho <= 1 / a.
    double roundoff(double xi) const {
        if (!in_fan(xi)) return 40 * eps;
        const auto f = at(std::nextafter(xi, 0));
        const double a = sound(gas_at(xi), f.density, f.pressure);
        return (40 + 4 * std::min(1e6, speed() / a)) * eps;  // behind a millionth nothing is left to flow
    }
    /// Speeds of all waves, heads and tails, rising.
    std::vector<double> places() const {
        std::vector<double> list;
        for (const auto& wave : waves) {
            list.push_back(std::min(wave.head, wave.tail));
            if (wave.spread()) list.push_back(std::max(wave.head, wave.tail));
        }
        return list;
    }
};

inline GasClaim claim_of(const std::pair<Gas, Gas>& data) {
    const RiemannGas problem(data.first, data.second);
    return {data.first, data.second, [problem](double xi) { return problem.at(xi, 1); },
            [problem](double a, double b) { return problem.mean(a, b, 1); }, problem.waves()};
}

/// Densities of mass, momentum and energy and their fluxes, in a frame that moves with speed s.
struct Conserved {
    std::array<double, 3> q, flux;
};
inline Conserved conserved(const GasFields& f, double s) {
    // Nothing flows in a vacuum; its walls are pushed by its pressure, which its energy of -p pays for.
    if (f.density == 0) return {{0, 0, f.total_energy}, {0, f.pressure, -s * (f.total_energy + f.pressure)}};
    const double w = f.velocity - s;
    const double E = f.density * (f.energy + 0.5 * w * w);
    return {{f.density, f.density * w, E}, {f.density * w, f.density * w * w + f.pressure, (E + f.pressure) * w}};
}

/// What fluxes of mass, momentum and energy are measured by.
inline std::array<double, 3> scales(const GasClaim& claim, const std::vector<GasFields>& states) {
    std::array<double, 3> scale{};
    const double speed = claim.speed();
    for (const auto& f : states) {
        const double inner = f.density > 0 ? std::abs(f.density * f.energy) : 0;
        const double force = f.density * speed * speed + std::abs(f.pressure) + inner;
        scale[0] = std::max(scale[0], f.density * speed);
        scale[1] = std::max(scale[1], force);
        scale[2] = std::max(scale[2], force * speed);
    }
    return scale;
}

}  // namespace ordo::oracles::gate

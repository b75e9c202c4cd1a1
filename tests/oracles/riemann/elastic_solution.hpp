#pragma once
// What is true of the Riemann problem of an elastic line with heat, said without the solver's formulas: balance laws
// over jumps, fans and boxes with the material's law written anew, entropy, symmetry. Functions over callables, so that
// faulty solutions can be passed too.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "oracles/oracle.hpp"

namespace ordo::oracles::gate::elastic {

inline constexpr double eps = std::numeric_limits<double>::epsilon();

/// The law as a textbook prints it. 'L' is linear, its k is 0.
struct ElasticLaw {
    char material;
    double E, rho0, c_v, k;

    double C(double lambda, double T) const {
        const double heat = c_v * std::pow(lambda, -k) * T;
        switch (material) {
            case 'A': return E / 3 * (lambda * lambda / 2 + 1 / lambda - 1.5) + heat;
            case 'B': return E / 2 * (lambda * lambda / 2 - std::log(lambda) - 0.5) + heat;
            case 'C': return E * (lambda * std::log(lambda) - lambda + 1) + heat;
            default: return E / 2 * (lambda - 1) * (lambda - 1) + heat;
        }
    }
    double sigma(double lambda, double T) const {
        const double heat = -k * c_v * std::pow(lambda, -k - 1) * T;
        switch (material) {
            case 'A': return E / 3 * (lambda - std::pow(lambda, -2)) + heat;
            case 'B': return E / 2 * (lambda - 1 / lambda) + heat;
            case 'C': return E * std::log(lambda) + heat;
            default: return E * (lambda - 1) + heat;
        }
    }
    double sound_speed(double lambda, double T) const {
        const double heat = k * (k + 1) * c_v * std::pow(lambda, -k - 2) * T;
        const double stiffness = material == 'A'   ? E / 3 * (1 + 2 * std::pow(lambda, -3))
                                 : material == 'B' ? E / 2 * (1 + std::pow(lambda, -2))
                                 : material == 'C' ? E / lambda
                                                   : E;
        return lambda * std::sqrt((stiffness + heat) / rho0);
    }
};

struct ElasticState {
    double lambda, v, T;
};

struct ElasticWave {
    std::string kind, side;
    double head, tail;
};

using ElasticRow = std::array<double, 8>;
enum : std::size_t { velocity, density, stress, strain, temperature, energy, momentum, total_energy };

/// A claimed solution at t = 1, x0 = 0, with the data that it was claimed for.
struct ElasticSolution {
    ElasticLaw law;
    ElasticState left, right;
    double sigma_star, v_star, rho_star_L, rho_star_R, T_star_L, T_star_R;
    std::vector<ElasticWave> waves;  ///< from left to right
    std::function<ElasticRow(double xi)> at;
    std::function<ElasticRow(double a, double b)> mean;

    /// Scales that the largest values of the problem have, the star state's included.
    double speed() const {
        const double star_L = law.sound_speed(law.rho0 / rho_star_L, T_star_L);
        const double star_R = law.sound_speed(law.rho0 / rho_star_R, T_star_R);
        return std::abs(left.v) + std::abs(right.v) + law.sound_speed(left.lambda, left.T) +
               law.sound_speed(right.lambda, right.T) + star_L + star_R;
    }
    /// A distance that no wave has come to.
    double reach() const {
        double most = speed();
        for (const auto& wave : waves) most = std::max(most, std::abs(wave.head));
        return 1.5 * most;
    }
    double rho() const { return std::max({law.rho0 / left.lambda, law.rho0 / right.lambda, rho_star_L, rho_star_R}); }
    double least_rho() const {
        return std::min({law.rho0 / left.lambda, law.rho0 / right.lambda, rho_star_L, rho_star_R});
    }
    /// Of p and e: rho v^2 alone misses the stored energy of a hot soft material.
    double pressure() const {
        double most = rho() * speed() * speed() + law.E;
        for (const auto& [lambda, T] :
             {std::pair{left.lambda, left.T}, std::pair{right.lambda, right.T},
              std::pair{law.rho0 / rho_star_L, T_star_L}, std::pair{law.rho0 / rho_star_R, T_star_R}})
            most = std::max(most, std::abs(law.C(lambda, T)) / lambda);
        return most;
    }
    const ElasticWave* wave(const std::string& side) const {
        for (const auto& wave : waves) {
            if (wave.side == side) return &wave;
        }
        return nullptr;
    }
};

inline double number_of(const Constants& record, const std::string& name) {
    for (const auto& constant : record) {
        if (constant.name == name) return std::get<double>(constant.value);
    }
    return std::nan("");
}

/// What an oracle of the catalogue says of these data.
inline ElasticSolution solution_of(const Exact& exact, const ElasticLaw& law, const ElasticState& left,
                                   const ElasticState& right) {
    const Constants constants = exact.constants(std::nullopt);
    std::vector<ElasticWave> waves;
    for (const auto& constant : constants) {
        if (constant.name != "waves") continue;
        for (const auto& record : std::get<std::vector<Constants>>(constant.value)) {
            const auto word = [&](std::size_t i) { return std::get<std::string>(record[i].value); };
            const bool fan = word(0) == "rarefaction";
            waves.push_back({word(0), word(1), number_of(record, fan ? "head" : "speed"),
                             number_of(record, fan ? "tail" : "speed")});
        }
    }
    const auto value = [&](const char* name) { return number_of(constants, name); };
    return {law,
            left,
            right,
            value("sigma_star"),
            value("v_star"),
            value("rho_star_L"),
            value("rho_star_R"),
            value("T_star_L"),
            value("T_star_R"),
            waves,
            [exact](double xi) {
                ElasticRow row;
                exact.sample({&xi, 1}, 1, row);
                return row;
            },
            [exact](double a, double b) {
                ElasticRow row;
                const std::array edges{a, b};
                exact.averages(edges, 1, row);
                return row;
            }};
}

/// Whether doubles tell the places of its waves apart: a star region may be crushed to less than an ulp of v*.
inline bool resolved(const ElasticSolution& s) {
    for (const auto& wave : s.waves) {
        if (wave.kind != "contact" && !(std::abs(wave.tail - s.v_star) > 16 * eps * s.reach())) return false;
    }
    return true;
}

inline double below(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

/// Means of density, momentum, energy and their fluxes, from velocity, density and temperature alone.
inline std::array<double, 3> content(const ElasticLaw& law, const ElasticRow& row) {
    const double rho = row[density];
    const double v = row[velocity];
    return {rho, rho * v, rho * (v * v / 2 + law.C(law.rho0 / rho, row[temperature]) / law.rho0)};
}
inline std::array<double, 3> flux(const ElasticLaw& law, const ElasticRow& row) {
    const double v = row[velocity];
    const double sigma = law.sigma(law.rho0 / row[density], row[temperature]);
    const auto [mass, p, e] = content(law, row);
    return {mass * v, p * v - sigma, (e - sigma) * v};
}
inline std::array<double, 3> scales(const ElasticSolution& s) {
    return {s.rho() * s.speed(), s.pressure(), s.pressure() * s.speed()};
}

}  // namespace ordo::oracles::gate::elastic

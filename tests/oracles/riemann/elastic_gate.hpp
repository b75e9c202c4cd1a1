#pragma once
// What is true of the Riemann problem of an elastic line with heat, said without the solver's formulas: balance laws
// over jumps, fans and boxes with the material's law written anew, and entropy. Functions over callables, so that
// faulty solutions can be passed too.
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/oracles/differences.hpp"
#include "tests/oracles/riemann/elastic_solution.hpp"

namespace ordo::oracles::gate::elastic {

/// The data outside of the waves, up to where they are said to be; all fields of a row from three of them; the star
/// values at the contact.
inline Defect states(const ElasticSolution& s) {
    Defect defect;
    const auto expect = [&](const ElasticRow& row, const ElasticState& state) {
        const auto& [lambda, v, T] = state;
        const double rho = s.law.rho0 / lambda;
        const double C = s.law.C(lambda, T);
        const double p = s.pressure();
        defect.add(row[velocity] - v, 4 * eps * s.speed(), s.speed());
        defect.add(row[density] / rho - 1, 4 * eps, 1);
        defect.add(row[temperature] - T, 4 * eps * T, T + std::numeric_limits<double>::min());
        defect.add(row[strain] - (lambda - 1), 4 * eps * (1 + lambda), 1 + lambda);
        defect.add(row[stress] - s.law.sigma(lambda, T), 64 * eps * p, p);
        defect.add(row[energy] - C / s.law.rho0, 64 * eps * p / s.least_rho(), p / s.least_rho());
        defect.add(row[momentum] - rho * v, 8 * eps * s.rho() * s.speed(), s.rho() * s.speed());
        defect.add(row[total_energy] - rho * (v * v / 2 + C / s.law.rho0), 64 * eps * p, p);
    };
    expect(s.at(-s.reach()), s.left);
    expect(s.at(s.reach()), s.right);
    const ElasticState star_L{s.law.rho0 / s.rho_star_L, s.v_star, s.T_star_L};
    const ElasticState star_R{s.law.rho0 / s.rho_star_R, s.v_star, s.T_star_R};
    expect(s.at(below(s.v_star)), star_L);
    expect(s.at(s.v_star), star_R);
    for (const auto& wave : s.waves) {
        if (wave.side == "left") {
            expect(s.at(below(wave.head)), s.left);
            expect(s.at(wave.tail), star_L);
        }
        if (wave.side == "right") {
            expect(s.at(below(wave.tail)), star_R);
            expect(s.at(wave.head), s.right);
        }
    }
    defect.add(s.at(s.v_star)[stress] - s.sigma_star, 64 * eps * s.pressure(), s.pressure());
    defect.add(s.at(below(s.v_star))[stress] - s.sigma_star, 64 * eps * s.pressure(), s.pressure());
    return defect;
}

/// Mass, momentum and energy pass every jump: [flux] = speed [content].
inline Defect rankine_hugoniot(const ElasticSolution& s) {
    Defect defect;
    for (const auto& wave : s.waves) {
        if (wave.kind == "rarefaction") continue;
        const ElasticRow before = s.at(below(wave.head));
        const ElasticRow behind = s.at(wave.head);
        const auto U = content(s.law, before);
        const auto V = content(s.law, behind);
        const auto F = flux(s.law, before);
        const auto G = flux(s.law, behind);
        for (std::size_t i = 0; i < 3; ++i)
            defect.add((G[i] - F[i]) - wave.head * (V[i] - U[i]), 64 * eps * scales(s)[i], scales(s)[i]);
    }
    return defect;
}

/// Sides compress in shocks and stretch in rarefactions; sound runs into a shock from both sides; T rises in it. The
/// waves do not overlap.
inline Defect entropy(const ElasticSolution& s) {
    Defect defect;
    // The power lambda^-k multiplies the relative error of lambda by k, that of an exponential by k ln(lambda).
    double power = 0;
    for (const double rho : {s.law.rho0 / s.left.lambda, s.law.rho0 / s.right.lambda, s.rho_star_L, s.rho_star_R})
        power = std::max(power, s.law.k * (1 + std::abs(std::log(s.law.rho0 / rho))));
    const double slack = (16 + 4 * power) * eps * s.speed();
    const auto demand = [&](bool holds) { defect.add(holds ? 0 : 1, 0, 1); };
    for (const bool left : {true, false}) {
        const ElasticWave* wave = s.wave(left ? "left" : "right");
        if (wave == nullptr) continue;
        const auto& [lambda, v, T] = left ? s.left : s.right;
        const double sign = left ? -1 : 1;
        const double star = s.law.rho0 / (left ? s.rho_star_L : s.rho_star_R);
        const double T_star = left ? s.T_star_L : s.T_star_R;
        const double before = sign * v + s.law.sound_speed(lambda, T);
        const double behind = sign * s.v_star + s.law.sound_speed(star, T_star);
        if (wave->kind == "shock") {
            demand(star <= lambda && T_star >= T);
            demand(before <= sign * wave->head + slack && sign * wave->head <= behind + slack);
            if (star < 0.99 * lambda) demand(T_star > T && before < behind);
        }
        if (wave->kind == "rarefaction") {
            demand(star >= lambda && T_star == T);
            defect.add(sign * wave->head - before, slack, s.speed());
            defect.add(sign * wave->tail - behind, slack, s.speed());
        }
    }
    for (std::size_t i = 0; i < s.waves.size(); ++i) {
        const double low = std::min(s.waves[i].head, s.waves[i].tail);
        if (i > 0) demand(std::max(s.waves[i - 1].head, s.waves[i - 1].tail) <= low);
    }
    return defect;
}

/// In a fan: T = T_K, xi = v -+ a, and dv = -+ a d(rho)/rho, by differences.
inline Defect fans(const ElasticSolution& s) {
    Defect defect;
    for (const auto& wave : s.waves) {
        if (wave.kind != "rarefaction") continue;
        const bool left = wave.side == "left";
        const double sign = left ? 1 : -1;
        const double low = std::min(wave.head, wave.tail);
        const double width = std::abs(wave.tail - wave.head);
        for (const double share : {0.1, 0.37, 0.5, 0.81}) {
            const double xi = low + share * width;
            const ElasticRow row = s.at(xi);
            const double a = s.law.sound_speed(s.law.rho0 / row[density], row[temperature]);
            defect.add(row[temperature] - (left ? s.left.T : s.right.T), 0, 1);
            defect.add(row[velocity] - sign * a - xi, 16 * eps * s.speed(), s.speed());
            // Four steps to each side stay within the fan; xi itself is known to an ulp of the speeds only, which
            // moves ln(rho) by the slope that is being measured.
            const double step = width / 45;
            const auto v = first_derivative([&](double y) { return s.at(y)[velocity]; }, xi, step, 8 * eps * s.speed());
            const auto log_rho = [&](double y) { return std::log(s.at(y)[density]); };
            const double slope = first_derivative(log_rho, xi, step, 0).value;
            const auto r = first_derivative(log_rho, xi, step, 8 * eps * (1 + s.speed() * std::abs(slope)));
            // v_xi is between 0 and 1.
            const double allowed = v.error + a * r.error + 16 * eps * s.speed() * std::abs(slope);
            if (allowed < 1e-8) defect.add(v.value + sign * a * r.value, allowed, 1);
        }
    }
    return defect;
}

/// Content of a box at t = 1 = content at t = 0 + what came through its ends: by the stated cell averages over uneven
/// cells that cut through every wave.
inline Defect balance(const ElasticSolution& s) {
    const double box = s.reach();
    std::array<double, 3> sum{};
    constexpr int cells = 7;
    double from = -box;
    for (int i = 1; i <= cells; ++i) {
        const double to = i == cells ? box : -box + 2 * box * (i + 0.3 * std::sin(5.0 * i)) / cells;
        const ElasticRow mean = s.mean(from, to);
        sum[0] += mean[density] * (to - from);
        sum[1] += mean[momentum] * (to - from);
        sum[2] += mean[total_energy] * (to - from);
        from = to;
    }
    const ElasticRow L = s.at(-box);
    const ElasticRow R = s.at(box);
    Defect defect;
    for (std::size_t i = 0; i < 3; ++i) {
        const double before = box * (content(s.law, L)[i] + content(s.law, R)[i]);
        const double scale = scales(s)[i] * box / s.speed();
        const double through = flux(s.law, L)[i] - flux(s.law, R)[i];
        defect.add(sum[i] - before - through, 128 * eps * scale, scale);
    }
    return defect;
}

/// The stated averages are those of the sampled fields: every field, each smooth piece by 30 Gauss nodes on 16 panels
/// that halve towards a fan's tail, near which it bends most.
inline Defect averages(const ElasticSolution& s) {
    const double box = s.reach();
    std::vector<double> cuts{-box};
    for (const auto& wave : s.waves) {
        std::vector<double> inner{wave.head};
        for (int i = 1; i < 16 && wave.head != wave.tail; ++i)
            inner.push_back(wave.tail + (wave.head - wave.tail) * std::pow(0.5, i));
        if (wave.head != wave.tail) inner.push_back(wave.tail);
        if (wave.tail < wave.head) std::reverse(inner.begin(), inner.end());
        cuts.insert(cuts.end(), inner.begin(), inner.end());
    }
    cuts.push_back(box);
    ElasticRow sum{};
    ElasticRow largest{};
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double width = cuts[i + 1] - cuts[i];
        const double middle = cuts[i] + 0.5 * width;
        using Gauss = boost::math::quadrature::gauss<double, 30>;
        for (std::size_t node = 0; node < Gauss::abscissa().size(); ++node) {
            for (const double side : {-0.5, 0.5}) {
                const ElasticRow row = s.at(middle + side * width * Gauss::abscissa()[node]);
                for (std::size_t k = 0; k < row.size(); ++k) {
                    sum[k] += 0.5 * width * Gauss::weights()[node] * row[k];
                    largest[k] = std::max(largest[k], std::abs(row[k]));
                }
            }
        }
    }
    const ElasticRow mean = s.mean(-box, box);
    Defect defect;
    for (std::size_t k = 0; k < mean.size(); ++k)
        defect.add(mean[k] - sum[k] / (2 * box), 1e-12 * largest[k], largest[k] + std::numeric_limits<double>::min());
    return defect;
}

struct ElasticGate {
    std::string name;
    Defect (*defect)(const ElasticSolution&);
};
inline const std::vector<ElasticGate> elastic_gates{{"states", states},   {"Rankine-Hugoniot", rankine_hugoniot},
                                                    {"entropy", entropy}, {"fans", fans},
                                                    {"balance", balance}, {"averages", averages}};

}  // namespace ordo::oracles::gate::elastic

#pragma once
// The state between the two waves of a Riemann problem.
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "oracles/riemann/elastic_state.hpp"
#include "oracles/riemann/elastic_wave.hpp"

namespace ordo::oracles::elastic {

/// The star state: stress and velocity are equal on both sides of the contact, stretch and temperature are not.
struct Star {
    double sigma;
    double v;
    Wave left;
    Wave right;
};

/// Solves f_L(p*) + f_R(p*) + v_R - v_L = 0. The unknown is the strength of the wave on the side of lower pressure, so
/// that weak waves keep their digits; the result is symmetric in the two sides to the bit. NaN without a solution.
template <class M>
Star star_state(const M& material, const State& left, const State& right) {
    const WaveCurve<M> of_left(material, {stretch(left.lambda), left.T});
    const WaveCurve<M> of_right(material, {stretch(right.lambda), right.T});
    const bool left_is_soft =
        std::tuple(of_left.pressure(), left.lambda, left.T) <= std::tuple(of_right.pressure(), right.lambda, right.T);
    WaveCurve<M> soft = left_is_soft ? of_left : of_right;
    WaveCurve<M> hard = left_is_soft ? of_right : of_left;
    const double gap = hard.pressure() - soft.pressure();
    const double parting = right.v - left.v;
    const auto misfit = [&](const Wave& wave) {
        const Wave other = hard.wave(wave.pressure_rise - gap, wave.pressure);
        return std::pair{wave.push + other.push + parting,
                         wave.push_slope + other.push_slope / other.pressure_slope * wave.pressure_slope};
    };

    const double without = misfit(soft.wave(0, soft.pressure())).first;
    const double acoustic = std::abs(without) / (1 / soft.impedance() + 1 / hard.impedance());
    Wave found = soft.wave(0, soft.pressure());
    if (without < 0) {
        const double inertia = 0.25 * material.rho0 * without * without / std::max(left.lambda, right.lambda);
        const double w = positive_root([&](double strength) { return misfit(soft.shock(strength)); },
                                       soft.shock_strength(acoustic + inertia));
        found = soft.shock(w);
    } else if (without > 0) {
        const auto opening = [&](double strength) {
            const auto [value, slope] = misfit(soft.rarefaction(strength));
            return std::pair{-value, -slope};
        };
        found = soft.rarefaction(positive_root(opening, soft.rarefaction_strength(acoustic)));
    }
    const auto fresh = [&](WaveCurve<M> side, bool is_soft) {
        return side.wave(found.pressure_rise - (is_soft ? 0 : gap), found.pressure);
    };
    const Wave left_wave = fresh(of_left, left_is_soft);
    const Wave right_wave = fresh(of_right, !left_is_soft);
    const double v = 0.5 * (left.v + right.v) + 0.5 * (right_wave.push - left_wave.push);
    return {-found.pressure, v, left_wave, right_wave};
}

}  // namespace ordo::oracles::elastic

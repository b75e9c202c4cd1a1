#pragma once
// Elastic materials with heat in one dimension, as the exact solvers of Riemann problems want them: the plug-in
// concept, and the materials that stand. A new one is a struct like NeoHookean below.
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <concepts>

namespace ordo::oracles::elastic {

inline constexpr double pi = boost::math::constants::pi<double>();

/// A stretch lambda = dx/dX > 0 and its logarithm.
struct Stretch {
    double lambda;
    double log;
};

inline Stretch stretch(double lambda) { return {lambda, std::log(lambda)}; }

/// A change of stretch with its differences kept apart, so that a weak wave loses no digit.
struct Change {
    Stretch from;
    Stretch to;
    double rise;  ///< to.lambda - from.lambda
    double log;   ///< to.log - from.log
};

/// The change by `rise` that ends at `to`; both are given because either may be the one that is known exactly.
inline Change change(const Stretch& from, double to, double rise) {
    const double log = std::abs(rise) < 0.5 * from.lambda ? std::log1p(rise / from.lambda) : std::log(to) - from.log;
    return {from, {to, from.log + log}, rise, log};
}

/// The derivatives of a function of the stretch: f', f'', f'''.
struct Jet {
    double slope;
    double curvature;
    double third;
};

/// A part of the energy per reference length or volume as a function f of the stretch: C_s(lambda), or c_v g(lambda)
/// which the temperature multiplies.
///   value, at         f; its derivatives
///   slope_rise        f'(to) - f'(from) without cancellation, from the jet where the change begins
///   trapezoid_excess  integral_to^from f' - (f'(to) + f'(from)) (from - to) / 2 without cancellation, in compression:
///                     of third order in the change, positive where f''' < 0
///   low, high         lambda^2 f'' is a sum of terms c lambda^m, c > 0, with low <= m <= high
template <class P>
concept Potential = requires(const P part, const Stretch& s, const Change& c, const Jet& from) {
    { part.value(s) } -> std::same_as<double>;
    { part.at(s) } -> std::same_as<Jet>;
    { part.slope_rise(c, from) } -> std::same_as<double>;
    { part.trapezoid_excess(c) } -> std::same_as<double>;
    { part.low() } -> std::same_as<double>;
    { part.high() } -> std::same_as<double>;
};

/// The part that the temperature multiplies also says where its shocks end.
///   shock_limit    the stretch that no shock from `from` can reach, as (gamma - 1) / (gamma + 1) is for a gas
///   shock_divisor  f - f' (to - from) / 2 at the end of a shock without cancellation, from how far `to` is above that
template <class P>
concept HeatPotential = Potential<P> && requires(const P part, double lambda, const Stretch& to) {
    { part.shock_limit(lambda) } -> std::same_as<double>;
    { part.shock_divisor(to, lambda) } -> std::same_as<double>;
};

/// sinh x - x to the last bits.
inline double sinh_excess(double x) {
    if (std::abs(x) >= 1) return std::sinh(x) - x;
    const double y = x * x;
    double sum = 1;
    for (const double divisor : {272.0, 210.0, 156.0, 110.0, 72.0, 42.0, 20.0}) sum = 1 + sum * y / divisor;
    return x * y / 6 * sum;
}

/// e^x - 1 - x to the last bits.
inline double exp_excess(double x) {
    if (std::abs(x) >= 1) return std::expm1(x) - x;
    const double half = std::sinh(0.5 * x);
    return sinh_excess(x) + 2 * half * half;
}

/// Energy per reference volume C = C_s(lambda) + c_v g(lambda) T, stress sigma = C_lambda at fixed T.
template <Potential Strain, HeatPotential Heat>
struct Material {
    Strain strain;
    Heat heat;
    double rho0;  ///< density where lambda = 1

    double energy(const Stretch& s, double T) const { return strain.value(s) + T * heat.value(s); }  ///< C
    /// sigma, sigma_lambda, sigma_lambda_lambda.
    Jet at(const Stretch& s, double T) const {
        const Jet a = strain.at(s);
        const Jet b = heat.at(s);
        return {a.slope + T * b.slope, a.curvature + T * b.curvature, a.third + T * b.third};
    }
    /// a = lambda sqrt(sigma_lambda / rho0), in space.
    double sound_speed(const Stretch& s, const Jet& jet) const { return s.lambda * std::sqrt(jet.curvature / rho0); }
    /// d(v -+ a) / d ln lambda through a simple wave: -lambda^3 sigma_lambda_lambda / (2 rho0 a), for a given a.
    double fan_spread(const Stretch& s, const Jet& jet, double a) const {
        return -s.lambda * s.lambda * s.lambda * jet.third / (2 * rho0 * a);
    }
    /// a(ln lambda) has no singularity within this distance of the real axis: where the terms of a^2, powers of lambda
    /// with positive factors, turn by less than half a circle against each other they do not cancel.
    double analytic_strip() const {
        const double spread = std::max(strain.high(), heat.high()) - std::min(strain.low(), heat.low());
        return pi / std::max(2.0, spread);
    }
};

}  // namespace ordo::oracles::elastic

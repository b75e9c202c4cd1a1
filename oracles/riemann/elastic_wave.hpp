#pragma once
// The wave curve of one side of a Riemann problem: which states its wave can lead to.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "oracles/numerics/root.hpp"
#include "oracles/riemann/elastic_fan.hpp"

namespace ordo::oracles::elastic {

/// The root x > 0 of a rising f, f(0) < 0, by Newton's method; f gives value and slope, and no number where x is too
/// large. Where a step leaves the bracket known so far, GSL's Brent-Dekker ends the search. NaN if there is no root.
template <class F>
double positive_root(F&& f, double x) {
    constexpr int most_steps = 200;
    constexpr double converged = 1e-9;  // relative; the next step of a quadratic iteration is below round-off
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double low = 0;
    double high = infinity;
    double beyond = infinity;
    for (int i = 0; i < most_steps; ++i) {
        const auto [value, slope] = f(x);
        if (!std::isfinite(value)) beyond = x;
        else (value < 0 ? low : high) = x;
        const double next = x - value / slope;
        if (std::abs(next - x) <= converged * x) return next;
        if (next > low && next < std::min(high, beyond)) x = next;
        else if (std::isfinite(high)) return bracketed_root([&](double trial) { return f(trial).first; }, low, high);
        else x = std::isfinite(beyond) ? 0.5 * (low + beyond) : 2 * x;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// What a wave does to the state that it runs into.
struct Wave {
    double pressure_rise = 0;  ///< p* - p_K: > 0 in a shock, < 0 in a rarefaction
    double pressure = 0;       ///< p*, which a strong wave knows better than p_K + rise
    Change stretch{};          ///< from lambda_K to lambda*
    double T = 0;              ///< temperature behind it
    double push = 0;           ///< f with v* = v_L - f_L = v_R + f_R
    double speed = 0;          ///< at which it runs into the state, in space; the head's in a rarefaction
    double pressure_slope = 0, push_slope = 0;  ///< derivatives by the wave's strength
};

/// The waves that can run into one state. Their strength is
///   shock:        w = (lambda_K - lambda) / (lambda - limit); for an ideal gas p rises in proportion to it
///   rarefaction:  lambda - lambda_K
/// and nothing cancels in them, however weak or strong they are. Across a shock, with p = -sigma,
///   [C] = -(p + p_K) / 2 [lambda]:  T = T_K + trapezoid_excess / shock_divisor,  f^2 = -[p] [lambda] / rho0.
/// It starts each search from its last answer; a copy made before the first one gives bits that depend on no history.
template <class M>
class WaveCurve {
public:
    WaveCurve(const M& material, const Origin& origin)
        : material_(material),
          origin_(origin),
          strain_(material.strain.at(origin.stretch)),
          heat_(material.heat.at(origin.stretch)),
          limit_(material.heat.shock_limit(origin.stretch.lambda)),
          stiffness_(strain_.curvature + origin.T * heat_.curvature) {}

    double pressure() const { return -(strain_.slope + origin_.T * heat_.slope); }
    double impedance() const { return std::sqrt(material_.rho0 * stiffness_); }  ///< rho a

    /// First guesses of the strength, from a pressure rise or fall > 0: exact for weak waves.
    double shock_strength(double rise) const { return rise / (stiffness_ * room()); }
    double rarefaction_strength(double fall) const { return fall / stiffness_; }

    Wave shock(double w) const {
        if (w == 0) return none();
        const double above_limit = room() / (1 + w);
        const double lambda = limit_ + above_limit;
        const Change c = change(origin_.stretch, lambda, -w * above_limit);
        const Jet strain = material_.strain.at(c.to);
        const Jet heat = material_.heat.at(c.to);
        const double divisor = material_.heat.shock_divisor(c.to, above_limit);
        const double excess = material_.strain.trapezoid_excess(c) + origin_.T * material_.heat.trapezoid_excess(c);
        const double T_rise = excess / divisor;
        const double rise = -stress_rise(c) - T_rise * heat.slope;
        const double stiffness = strain.curvature + (origin_.T + T_rise) * heat.curvature;
        const double T_slope = (rise + c.rise * stiffness) / (2 * divisor);  // along lambda
        const double slope = (stiffness + heat.slope * T_slope) * above_limit / (1 + w);
        const double speed = std::sqrt(rise / (-c.rise * material_.rho0));  // in the reference
        const double push = -c.rise * speed;
        return {rise,  behind(rise, strain.slope + (origin_.T + T_rise) * heat.slope),
                c,     origin_.T + T_rise,
                push,  origin_.stretch.lambda * speed,
                slope, 0.5 * push * (slope / rise + 1 / (w * (1 + w)))};
    }

    Wave rarefaction(double lengthening) {
        const Change c = lengthened(lengthening);
        const Jet jet = material_.at(c.to, origin_.T);
        const double rise = -stress_rise(c);
        return {rise,
                behind(rise, jet.slope),
                c,
                origin_.T,
                -integral_to(c.log),
                head_speed(),
                -jet.curvature,
                -std::sqrt(jet.curvature / material_.rho0)};
    }

    /// The wave of that pressure rise, which leads to that pressure: the rise is what a weak wave is found from, the
    /// pressure a strong one. Its push is not finite where the material cannot follow.
    Wave wave(double pressure_rise, double pressure) {
        if (pressure_rise == 0) return none();
        if (pressure_rise > 0) {
            const auto f = [&](double w) {
                const Wave trial = shock(w);
                const double excess =
                    weak(pressure_rise) ? trial.pressure_rise - pressure_rise : trial.pressure - pressure;
                return std::pair{excess, trial.pressure_slope};
            };
            w_ = positive_root(f, w_ > 0 ? w_ : shock_strength(pressure_rise));
            return shock(w_);
        }
        const auto f = [&](double lengthening) {
            const Change c = lengthened(lengthening);
            const Jet jet = material_.at(c.to, origin_.T);
            return std::pair{weak(pressure_rise) ? stress_rise(c) + pressure_rise : jet.slope + pressure,
                             jet.curvature};
        };
        lengthening_ = positive_root(f, lengthening_ > 0 ? lengthening_ : rarefaction_strength(-pressure_rise));
        return rarefaction(lengthening_);
    }

private:
    Wave none() const { return {0, pressure(), lengthened(0), origin_.T, 0, head_speed(), 1, 1 / impedance()}; }
    bool weak(double pressure_rise) const { return std::abs(pressure_rise) < 0.5 * std::abs(pressure()); }
    double behind(double rise, double stress) const { return weak(rise) ? pressure() + rise : -stress; }
    Change lengthened(double rise) const { return change(origin_.stretch, origin_.stretch.lambda + rise, rise); }
    double room() const { return origin_.stretch.lambda - limit_; }
    double head_speed() const { return origin_.stretch.lambda * std::sqrt(stiffness_ / material_.rho0); }
    double stress_rise(const Change& c) const {
        return material_.strain.slope_rise(c, strain_) + origin_.T * material_.heat.slope_rise(c, heat_);
    }

    /// Integral of a d ln lambda up to there, carried on from the last place.
    double integral_to(double h) {
        if (!(h < most_stretch)) return std::numeric_limits<double>::infinity();
        integral_ += speed_integral(material_, origin_, integrated_to_, h);
        integrated_to_ = h;
        return integral_;
    }

    static constexpr double most_stretch = 100;  ///< ln(lambda* / lambda_K): bounds the panels of the integral

    const M& material_;
    Origin origin_;
    Jet strain_, heat_;  ///< at the origin
    double limit_;       ///< stretch that no shock reaches
    double stiffness_;
    double w_ = 0, lengthening_ = 0;           ///< last answers of wave()
    double integral_ = 0, integrated_to_ = 0;  ///< of a d ln lambda
};

}  // namespace ordo::oracles::elastic

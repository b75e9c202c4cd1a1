#pragma once
// The strain energies and the heat that stand; each meets elastic::Potential.
#include "oracles/riemann/elastic_material.hpp"

namespace ordo::oracles::elastic {

/// C_s = E (lambda - 1)^2 / 2: linear elasticity [Walker2017].
struct Linear {
    double E;
    double value(const Stretch& s) const { return 0.5 * E * (s.lambda - 1) * (s.lambda - 1); }
    Jet at(const Stretch& s) const { return {E * (s.lambda - 1), E, 0}; }
    double slope_rise(const Change& c, const Jet&) const { return E * c.rise; }
    double trapezoid_excess(const Change&) const { return 0; }
    static double low() { return 2; }
    static double high() { return 2; }
};

/// Material A, C_s' = (E/3) (lambda - lambda^-2): the incompressible neo-Hookean law of rubber under tension.
struct NeoHookean {
    double E;
    double value(const Stretch& s) const { return E / 6 * (s.lambda - 1) * (s.lambda - 1) * (1 + 2 / s.lambda); }
    Jet at(const Stretch& s) const {
        const double inverse = 1 / s.lambda;
        const double cube = inverse * inverse * inverse;
        return {E / 3 * (s.lambda - inverse * inverse), E / 3 * (1 + 2 * cube), -2 * E * cube * inverse};
    }
    double slope_rise(const Change& c, const Jet&) const {
        const double a = 1 / c.from.lambda;
        const double b = 1 / c.to.lambda;
        return E / 3 * c.rise * (1 + (a + b) * a * b);
    }
    double trapezoid_excess(const Change& c) const {
        const double ratio = c.rise / (c.from.lambda * c.to.lambda);
        return -E / 6 * c.rise * ratio * ratio;
    }
    static double low() { return -1; }
    static double high() { return 2; }
};

/// Material B, C_s' = (E/2) (lambda - 1/lambda).
struct Reciprocal {
    double E;
    double value(const Stretch& s) const { return E / 4 * exp_excess(2 * s.log); }
    Jet at(const Stretch& s) const {
        const double inverse = 1 / s.lambda;
        const double square = inverse * inverse;
        return {E / 2 * (s.lambda - inverse), E / 2 * (1 + square), -E * square * inverse};
    }
    double slope_rise(const Change& c, const Jet&) const {
        return E / 2 * c.rise * (1 + 1 / (c.from.lambda * c.to.lambda));
    }
    double trapezoid_excess(const Change& c) const { return E / 2 * sinh_excess(-c.log); }
    static double low() { return 0; }
    static double high() { return 2; }
};

/// Material C, C_s' = E ln lambda: logarithmic strain. The only one that finite work crushes to nothing.
struct Logarithmic {
    double E;
    double value(const Stretch& s) const { return E * s.lambda * exp_excess(-s.log); }
    Jet at(const Stretch& s) const { return {E * s.log, E / s.lambda, -E / (s.lambda * s.lambda)}; }
    double slope_rise(const Change& c, const Jet&) const { return E * c.log; }
    double trapezoid_excess(const Change& c) const {
        if (std::abs(c.log) >= 1) return E * (c.rise - 0.5 * (c.from.lambda + c.to.lambda) * c.log);
        const double y = -0.5 * c.log;
        const double s = std::sinh(0.5 * y);
        const double middle = std::sqrt(c.from.lambda * c.to.lambda);
        return 2 * E * middle * (2 * y * s * s - sinh_excess(y));  // 2 (y cosh y - sinh y)
    }
    static double low() { return 1; }
    static double high() { return 1; }
};

/// c_v g, g = lambda^-k: heat that pushes outwards as an ideal gas with gamma = k + 1 would; k = 0 only stores it.
struct PowerHeat {
    double c_v;
    double k;
    double value(const Stretch& s) const { return c_v * std::exp(-k * s.log); }
    Jet at(const Stretch& s) const {
        const double inverse = 1 / s.lambda;
        const double slope = -k * value(s) * inverse;
        const double curvature = -(k + 1) * slope * inverse;
        return {slope, curvature, -(k + 2) * curvature * inverse};
    }
    double slope_rise(const Change& c, const Jet& from) const { return from.slope * std::expm1(-(k + 1) * c.log); }
    double trapezoid_excess(const Change& c) const {
        const double x = -0.5 * c.log;
        const double at_start = value(c.from);
        if ((k + 2) * std::abs(x) < 1)
            return at_start * std::exp(k * x) * (k * sinh_excess((k + 2) * x) - (k + 2) * sinh_excess(k * x));
        const double growth = std::expm1(2 * k * x);
        const double squeeze = c.from.lambda / c.to.lambda;
        return at_start * (-growth - 0.5 * k * c.rise / c.from.lambda * (1 + (1 + growth) * squeeze));
    }
    double low() const { return -k; }
    double high() const { return -k; }
    double shock_limit(double from) const { return from * k / (k + 2); }
    double shock_divisor(const Stretch& to, double above_limit) const {
        return value(to) * (k + 2) / 2 * (above_limit / to.lambda);
    }
};

}  // namespace ordo::oracles::elastic

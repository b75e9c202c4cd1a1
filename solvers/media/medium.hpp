#pragma once
// Media of a line: what a gas or an elastic line holds a unit of length, and what follows from that. Every law here is
// a value struct with the same members, so that a kernel is written once and knows no medium by name.
#include <cmath>
#include <string>
#include <variant>

namespace ordo::solvers {

/// What a unit of length holds. Additive: contents of an interval are these integrated over it.
struct Contents {
    double mass = 0;      ///< rho [kg/m]
    double momentum = 0;  ///< rho v [kg/s]
    double energy = 0;    ///< total, kinetic and internal [J/m]

    Contents& operator+=(const Contents& other) {
        mass += other.mass;
        momentum += other.momentum;
        energy += other.energy;
        return *this;
    }
    friend Contents operator+(Contents a, const Contents& b) { return a += b; }
    friend Contents operator-(const Contents& a, const Contents& b) {
        return {a.mass - b.mass, a.momentum - b.momentum, a.energy - b.energy};
    }
    friend Contents operator*(double s, const Contents& a) { return {s * a.mass, s * a.momentum, s * a.energy}; }
    bool operator==(const Contents&) const = default;
};

/// The state that contents stand for. `T` is the temperature of an elastic line; of a gas it stays 0.
struct Flow {
    double rho = 0;  ///< density [kg/m]
    double v = 0;    ///< velocity [m/s]
    double p = 0;    ///< pressure, that is minus the stress [Pa]
    double a = 0;    ///< speed of sound relative to the material [m/s]
    double T = 0;    ///< temperature [K]
    /// Matter that is there and that waves can run through. False for NaN.
    bool physical() const { return rho > 0 && a > 0 && std::isfinite(rho + std::abs(v) + std::abs(p) + a); }
};

/// What passes a place at rest in a unit of time.
inline Contents flux(const Contents& q, const Flow& f) {
    return {q.momentum, q.momentum * f.v + f.p, (q.energy + f.p) * f.v};
}

/// p = (gamma - 1) (energy - rho v^2 / 2).
struct IdealGas {
    static constexpr bool has_temperature = false;
    double gamma = 1.4;  ///< ratio of the specific heats, > 1 [-]

    Contents contents(double rho, double v, double p) const {
        return {rho, rho * v, p / (gamma - 1) + 0.5 * rho * v * v};
    }
    Flow flow(const Contents& q) const {
        const double v = q.momentum / q.mass;
        const double p = (gamma - 1) * (q.energy - 0.5 * q.momentum * v);
        return {q.mass, v, p, std::sqrt(gamma * p / q.mass), 0};
    }
    /// dp/d(internal energy a unit of length) at fixed density [-].
    double grueneisen() const { return gamma - 1; }
};

/// C_s = E (lambda - 1)^2 / 2: linear elasticity [Walker2017].
struct HookeEnergy {
    static double value(double l) { return 0.5 * (l - 1) * (l - 1); }
    static double slope(double l) { return l - 1; }
    static double curvature(double) { return 1; }
};
/// Material A, C_s' = (E/3) (lambda - lambda^-2).
struct RubberEnergy {
    static double value(double l) { return (0.5 * l * l + 1 / l - 1.5) / 3; }
    static double slope(double l) { return (l - 1 / (l * l)) / 3; }
    static double curvature(double l) { return (1 + 2 / (l * l * l)) / 3; }
};
/// Material B, C_s' = (E/2) (lambda - 1/lambda).
struct ReciprocalEnergy {
    static double value(double l) { return 0.25 * (l * l - 1) - 0.5 * std::log(l); }
    static double slope(double l) { return 0.5 * (l - 1 / l); }
    static double curvature(double l) { return 0.5 * (1 + 1 / (l * l)); }
};
/// Material C, C_s' = E ln lambda.
struct LogarithmicEnergy {
    static double value(double l) { return l * std::log(l) - l + 1; }
    static double slope(double l) { return std::log(l); }
    static double curvature(double l) { return 1 / l; }
};

/// An elastic line with heat: internal energy a unit of undeformed length C = E C_s(lambda) + c_v lambda^-k T, stress
/// sigma = dC/dlambda, stretch lambda = rho0 / rho. k = 0 is heat that exerts no stress.
template <class Energy>
struct ElasticMedium {
    static constexpr bool has_temperature = true;
    double E = 1;     ///< [N]
    double rho0 = 1;  ///< density of the unstretched line [kg/m]
    double c_v = 1;   ///< heat capacity a unit of unstretched length [J/(m K)]
    double k = 0;     ///< thermal coupling [-]

    Contents contents(double lambda, double v, double T) const {
        const double rho = rho0 / lambda;
        return {rho, rho * v, 0.5 * rho * v * v + (E * Energy::value(lambda) + c_v * heat(lambda) * T) / lambda};
    }
    Flow flow(const Contents& q) const {
        const double lambda = rho0 / q.mass;
        const double v = q.momentum / q.mass;
        const double g = heat(lambda);
        const double thermal = lambda * (q.energy - 0.5 * q.momentum * v) - E * Energy::value(lambda);  // c_v g T
        const double p = k * thermal / lambda - E * Energy::slope(lambda);
        const double stiffness = E * Energy::curvature(lambda) + k * (k + 1) * thermal / (lambda * lambda);
        return {q.mass, v, p, lambda * std::sqrt(stiffness / rho0), thermal / (c_v * g)};
    }
    double grueneisen() const { return k; }

private:
    double heat(double lambda) const { return k == 0 ? 1 : k == 1 ? 1 / lambda : std::pow(lambda, -k); }
};

using Medium = std::variant<IdealGas, ElasticMedium<HookeEnergy>, ElasticMedium<RubberEnergy>,
                            ElasticMedium<ReciprocalEnergy>, ElasticMedium<LogarithmicEnergy>>;

}  // namespace ordo::solvers

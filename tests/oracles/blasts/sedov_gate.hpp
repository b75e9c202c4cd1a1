#pragma once
// What is true of a point blast in a cold gas, said without its similarity solution: functions over callables, so that
// faulty blasts can be passed too.
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "oracles/blasts/sedov.hpp"
#include "tests/oracles/differences.hpp"

namespace ordo::oracles::gate::point_blast {

inline constexpr double eps = std::numeric_limits<double>::epsilon();

/// A claimed blast, with the data that it was claimed for.
struct ClaimedBlast {
    Sedov given;
    std::function<SedovBlast::State(double r, double t)> at;
    std::function<double(double t)> shock, core;

    int j() const { return static_cast<int>(given.geometry); }
    double ahead(double r) const { return given.rho0 * std::pow(r, -given.omega); }

    /// The steepest power of r: density towards the centre of a standard blast.
    double steepest() const {
        return 1 + (j() + std::abs(given.omega) * given.gamma) / (given.gamma - 1) + j() + std::abs(given.omega);
    }
    /// Relative error of a value: some ulp of lambda times the steepest power, and times r / (r - core) near the core.
    double noise(double r, double t) const {
        return 16 * eps * steepest() * (1 + std::abs(std::log(r / shock(t)))) * r / (r - core(t));
    }
};

inline ClaimedBlast claim_of(const SedovBlast& blast) {
    return {blast.given(), [blast](double r, double t) { return blast.at(r, t); },
            [blast](double t) { return blast.front(t).r; }, [blast](double t) { return blast.front(t).core; }};
}
inline ClaimedBlast claim_of(const Sedov& given) { return claim_of(SedovBlast(given)); }

/// Places between core and shock, as shares of the way; and times. No round numbers.
inline constexpr std::array shares{0.0531, 0.2117, 0.5013, 0.7391, 0.9271};
inline constexpr std::array moments{0.137, 2.31};

template <class Visit>
void at_samples(const ClaimedBlast& blast, Visit&& visit) {
    for (const double t : moments) {
        for (const double share : shares) visit(blast.core(t) + share * (blast.shock(t) - blast.core(t)), t);
    }
}

/// The Euler equations by finite differences, each times t and divided by the size of its terms:
///   (ln rho)_t + u (ln rho)_r + u_r + (j - 1) u / r = 0,   u_t + u u_r + p_r / rho = 0,   s_t + u s_r = 0
/// with s = ln p - gamma ln rho. Deep inside, where p is uniform to the last bit and rho tiny, the second one can only
/// say that it is: p / (rho r) counts as one of its terms.
inline Defect euler_equations(const ClaimedBlast& blast) {
    Defect defect;
    at_samples(blast, [&](double r, double t) {
        const double room = std::min({r, r - blast.core(t), blast.shock(t) - r});
        const double in_r = 0.04 * room;
        const double in_t = 0.04 * room / blast.shock(t) * t;  // the shock and the core move as t^(2/n), 2/n < 1
        const auto both = [&](auto&& field, double scale) {
            const double noise = blast.noise(r - 4 * in_r, t) * scale;
            return std::pair{first_derivative([&](double x) { return field(blast.at(x, t)); }, r, in_r, noise),
                             first_derivative([&](double s) { return field(blast.at(r, s)); }, t, in_t, noise)};
        };
        const auto here = blast.at(r, t);
        const auto [u_r, u_t] = both([](const auto& s) { return s.velocity; }, std::abs(here.velocity));
        const auto [rho_r, rho_t] = both([](const auto& s) { return std::log(s.density); }, 1);
        const auto [p_r, p_t] = both([](const auto& s) { return std::log(s.pressure); }, 1);
        const double u = here.velocity;
        const double gamma = blast.given.gamma;
        const double c2 = here.pressure / here.density;

        const double mass = rho_t.value + u * rho_r.value + u_r.value + (blast.j() - 1) * u / r;
        const double mass_size = std::abs(rho_t.value) + std::abs(u_r.value) + std::abs(u / r);
        defect.add(mass, rho_t.error + std::abs(u) * rho_r.error + u_r.error + blast.noise(r, t) * mass_size,
                   mass_size);
        const double momentum = u_t.value + u * u_r.value + c2 * p_r.value;
        const double momentum_size = std::abs(u_t.value) + std::abs(u * u_r.value) + std::abs(c2 * p_r.value) + c2 / r;
        defect.add(momentum, u_t.error + u * u_r.error + c2 * p_r.error + blast.noise(r, t) * momentum_size,
                   momentum_size);
        const double entropy = p_t.value + u * p_r.value - gamma * (rho_t.value + u * rho_r.value);
        const double entropy_size = std::abs(p_t.value) + gamma * std::abs(rho_t.value) + 1 / t;
        defect.add(
            entropy,
            p_t.error + u * p_r.error + gamma * (rho_t.error + u * rho_r.error) + blast.noise(r, t) * entropy_size,
            entropy_size);
    });
    return defect;
}

/// p = (gamma - 1) rho e; nothing moves ahead of the shock, and the right state holds at it.
inline Defect states(const ClaimedBlast& blast) {
    Defect defect;
    at_samples(blast, [&](double r, double t) {
        const auto [u, rho, p, e] = blast.at(r, t);
        defect.add(p - (blast.given.gamma - 1) * rho * e, 2 * blast.noise(r, t) * p, p);
        defect.add(u > 0 && rho > 0 && p > 0 && e > 0 ? 0 : 1, 0, 1);
        for (const double outside : {blast.shock(t), 1.7 * blast.shock(t)}) {
            const auto rest = blast.at(outside, t);
            defect.add(rest.density - blast.ahead(outside), 4 * eps * rest.density, rest.density);
            defect.add(std::abs(rest.velocity) + std::abs(rest.pressure) + std::abs(rest.energy), 0, 1);
        }
    });
    return defect;
}

/// Rankine-Hugoniot for a shock that moves at dr_shock/dt into cold gas at rest:
///   rho (D - u) = rho_ahead D,   p = rho_ahead D u,   e = u^2 / 2
inline Defect jump_conditions(const ClaimedBlast& blast) {
    Defect defect;
    for (const double t : moments) {
        const double r = blast.shock(t);
        const auto speed = first_derivative([&](double s) { return blast.shock(s); }, t, 0.05 * t, 4 * eps * r);
        const auto [u, rho, p, e] = blast.at(r * (1 - eps), t);
        const double D = speed.value;
        const double allowed = speed.error / D + 8 * eps * (1 + std::abs(blast.given.omega)) +
                               8 * eps * blast.steepest() * 2 / (blast.given.gamma - 1);
        defect.add(rho * (D - u) / (blast.ahead(r) * D) - 1, allowed, 1);
        defect.add(p / (blast.ahead(r) * D * u) - 1, allowed, 1);
        defect.add(e / (u * u / 2) - 1, allowed, 1);
    }
    return defect;
}

inline double area(int j) { return j == 1 ? 1 : 2 * (j - 1) * 3.14159265358979323846; }

/// The integral of f(r) dV from the core to the shock; f may be singular, but integrable, at both ends.
template <class F>
double over_volume(const ClaimedBlast& blast, double t, F&& f, double* error) {
    boost::math::quadrature::tanh_sinh<double> quadrature;
    const double from = blast.core(t);
    const double to = blast.shock(t);
    const auto shell = [&](double r) {
        const double value = r < to && r > from ? f(blast.at(r, t)) * std::pow(r, blast.j() - 1) : 0;
        return std::isfinite(value) ? value : 0;
    };
    return area(blast.j()) * quadrature.integrate(shell, from, to, 1e-12, error);
}

/// All energy released is in the gas, kinetic and internal; all mass that the shock has passed is in it.
inline Defect integrals(const ClaimedBlast& blast) {
    Defect defect;
    const auto& [geometry, gamma, omega, released, rho0] = blast.given;
    for (const double t : moments) {
        double error = 0;
        const double energy = over_volume(
            blast, t, [&](const auto& s) { return s.density * s.velocity * s.velocity / 2 + s.pressure / (gamma - 1); },
            &error);
        defect.add(energy - released, 1e-11 * released, released);
        const double mass = over_volume(
            blast, t, [](const auto& s) { return s.density; }, &error);
        const double swept = area(blast.j()) * rho0 * std::pow(blast.shock(t), blast.j() - omega) / (blast.j() - omega);
        defect.add(mass - swept, 1e-11 * swept, swept);
    }
    return defect;
}

/// Entropy along particles: h m^((j - gamma omega)/(j - omega)) = g^gamma, with m the share of the swept mass within r.
/// Energy: as much flows through a surface r ~ r_shock as stays within it, (r D / r_shock - u) (rho u^2 / 2 + rho e) =
/// p u. Both relative to the values behind the shock, and as differences of logarithms.
inline Defect identities(const ClaimedBlast& blast) {
    Defect defect;
    const double j = blast.j();
    const auto& [geometry, gamma, omega, released, rho0] = blast.given;
    at_samples(blast, [&](double r, double t) {
        const auto behind = blast.at(blast.shock(t) * (1 - eps), t);
        const auto here = blast.at(r, t);
        const double lambda = r / blast.shock(t);
        const double D = 2 / (j + 2 - omega) * blast.shock(t) / t;
        const double slip = lambda * D - here.velocity;  // of the gas against a surface of fixed lambda
        const double m = here.density / behind.density * std::pow(lambda, j - 1) * slip / (D - behind.velocity);
        const double noise =
            4 * blast.noise(r, t) * (1 + lambda * D / slip) * (gamma + std::abs(j - gamma * omega) / (j - omega));
        defect.add(std::log(here.pressure / behind.pressure) + (j - gamma * omega) / (j - omega) * std::log(m) -
                       gamma * std::log(here.density / behind.density),
                   noise, 1);
        const double inside = here.density * here.velocity * here.velocity / 2 + here.pressure / (gamma - 1);
        defect.add(slip * inside / (here.pressure * here.velocity) - 1, noise, 1);
    });
    return defect;
}

struct BlastGate {
    std::string name;
    Defect (*defect)(const ClaimedBlast&);
};
inline const std::vector<BlastGate> blast_gates{{"Euler equations", euler_equations},
                                                {"states", states},
                                                {"jump conditions", jump_conditions},
                                                {"integrals", integrals},
                                                {"identities", identities}};

}  // namespace ordo::oracles::gate::point_blast

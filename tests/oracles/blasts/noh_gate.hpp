#pragma once
// What is true of a gas that implodes, said without the oracle's formulas: balance laws of the Euler equations, written
// for any one-dimensional flow with one front, so that faulty flows can be passed too.
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "oracles/blasts/noh.hpp"
#include "tests/oracles/differences.hpp"

namespace ordo::oracles::gate::implosion {

inline constexpr double eps = std::numeric_limits<double>::epsilon();

/// A claimed flow with the data that it was claimed for.
struct Flow {
    Noh gas;
    std::function<Noh::State(double r, double t)> at;
    std::function<double(double t)> front;
    std::function<Noh::State(double a, double b, double t)> mean;

    int j() const { return static_cast<int>(gas.geometry); }
    double area(double r) const { return std::pow(r, j() - 1); }
};

inline Flow flow_of(const Noh& gas) {
    return {gas, [gas](double r, double t) { return gas.at(r, t); }, [gas](double t) { return gas.shock_speed() * t; },
            [gas](double a, double b, double t) { return gas.mean(a, b, t); }};
}

/// Mass, momentum and total energy in a unit of volume.
using Conserved = std::array<double, 3>;

inline Conserved densities(const Noh::State& s) {
    return {s.density, s.density * s.velocity, s.density * (s.energy + 0.5 * s.velocity * s.velocity)};
}
inline Conserved fluxes(const Noh::State& s) {
    const auto [mass, momentum, energy] = densities(s);
    return {momentum, momentum * s.velocity + s.pressure, (energy + s.pressure) * s.velocity};
}

inline constexpr std::array times{0.37, 1.0, 5.83};                                 ///< in units of 1 m / v0
inline constexpr std::array places{0.013, 0.41, 0.9999, 1.0001, 1.7, 13.0, 400.0};  ///< in units of the front's

template <class Visit>
void at_samples(const Flow& flow, Visit&& visit) {
    for (const double time : times) {
        const double t = time / flow.gas.v0;
        for (const double share : places) visit(share * flow.front(t), t);
    }
}

/// At t = 0 a cold gas of density rho0 flows inwards at v0, at r = 0 too; nothing moves at r = 0 later.
inline Defect data(const Flow& flow) {
    const auto& [geometry, gamma, rho0, v0] = flow.gas;
    Defect defect;
    for (const double r : {0.0, 1e-9, 0.3, 71.0}) {
        const auto s = flow.at(r, 0);
        defect.add(s.density - rho0, 0, rho0);
        defect.add(s.velocity + v0, 0, v0);
        defect.add(s.pressure, 0, rho0 * v0 * v0);
        defect.add(s.energy, 0, v0 * v0);
        defect.add(flow.at(0, 1e-9 + r).velocity, 0, v0);
    }
    return defect;
}

/// p = (gamma - 1) rho e.
inline Defect equation_of_state(const Flow& flow) {
    Defect defect;
    at_samples(flow, [&](double r, double t) {
        const auto s = flow.at(r, t);
        const double scale = s.density * flow.gas.v0 * flow.gas.v0 * (flow.gas.gamma - 1);
        defect.add(s.pressure - (flow.gas.gamma - 1) * s.density * s.energy, 8 * eps * scale, scale);
    });
    return defect;
}

/// Rankine-Hugoniot: what the front sweeps up, S [U], is the difference of the fluxes [F]; S from where the front is at
/// two times. The states differ by one ulp of r, the largest flux sets the scale.
inline Defect jump_conditions(const Flow& flow) {
    Defect defect;
    for (const double time : times) {
        const double t = time / flow.gas.v0;
        const double r = flow.front(t);
        const double S = (flow.front(2 * t) - r) / t;
        const auto ahead = flow.at(r, t);
        const auto behind = flow.at(std::nextafter(r, 0), t);
        defect.add(behind.density > ahead.density ? 0 : 1, 0, 1);
        const auto [U_a, U_b, F_a, F_b] =
            std::array{densities(ahead), densities(behind), fluxes(ahead), fluxes(behind)};
        for (std::size_t k = 0; k < 3; ++k) {
            const double scale =
                std::abs(F_a[k]) + std::abs(F_b[k]) + std::abs(S) * (std::abs(U_a[k]) + std::abs(U_b[k]));
            defect.add(S * (U_b[k] - U_a[k]) - (F_b[k] - F_a[k]), 16 * eps * scale, scale);
        }
    }
    return defect;
}

/// The Euler equations on either side of the front, each over what a flow of size v0 / r changes:
///   rho_t + u rho_r + rho d = 0,  rho (u_t + u u_r) + p_r = 0,  rho (e_t + u e_r) + p d = 0,  d = u_r + (j - 1) u / r
inline Defect euler_equations(const Flow& flow) {
    const double v0 = flow.gas.v0;
    Defect defect;
    at_samples(flow, [&](double r, double t) {
        const double distance = std::abs(r - flow.front(t));  // the differences reach over 0.2 of it
        const double in_r = 0.05 * std::min(distance, 0.5 * r);
        const double in_t = 0.05 * std::min(distance / flow.front(1), 0.5 * t);
        const auto s = flow.at(r, t);
        const auto rates = [&](double Noh::State::*field) {
            const double noise = 8 * eps * std::abs(s.*field);
            return std::pair{first_derivative([&](double q) { return flow.at(r, q).*field; }, t, in_t, noise),
                             first_derivative([&](double q) { return flow.at(q, t).*field; }, r, in_r, noise)};
        };
        const auto [rho_t, rho_r] = rates(&Noh::State::density);
        const auto [u_t, u_r] = rates(&Noh::State::velocity);
        const auto [p_t, p_r] = rates(&Noh::State::pressure);
        const auto [e_t, e_r] = rates(&Noh::State::energy);
        const double u = s.velocity;
        const double d = u_r.value + (flow.j() - 1) * u / r;
        const double scale = s.density * v0 / r;
        defect.add(rho_t.value + u * rho_r.value + s.density * d,
                   rho_t.error + std::abs(u) * rho_r.error + s.density * u_r.error + 16 * eps * scale, scale);
        defect.add(s.density * (u_t.value + u * u_r.value) + p_r.value,
                   s.density * (u_t.error + std::abs(u) * u_r.error) + p_r.error, scale * v0);
        defect.add(s.density * (e_t.value + u * e_r.value) + s.pressure * d,
                   s.density * (e_t.error + std::abs(u) * e_r.error) + s.pressure * u_r.error, scale * v0 * v0);
    });
    return defect;
}

struct Integral {
    double value;
    double error;
};

/// Over [0, 1] in b - a: the library's error estimate is that of an interval of length 2, whatever its own length.
template <class F>
Integral integral(F&& f, double a, double b) {
    double error = 0;
    const auto scaled = [&](double q) { return f(a + (b - a) * q); };
    const double mean = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(scaled, 0, 1, 6, 1e-13, &error);
    return {(b - a) * mean, (b - a) * (error + 32 * eps * std::abs(mean))};
}

/// The integral of f(state) r^(j-1) dr over [a, b], in two parts where the front lies between.
template <class F>
Integral shell(const Flow& flow, double a, double b, double t, F&& f) {
    const double s = std::clamp(flow.front(t), a, b);
    const auto weighted = [&](double r) { return f(flow.at(r, t)) * flow.area(r); };
    const auto [inner, outer] = std::pair{integral(weighted, a, s), integral(weighted, s, b)};
    return {inner.value + outer.value, inner.error + outer.error};
}

/// Mass and total energy of r < R grow by what flows in at R, from t = 0 on and between two times; R lies ahead of the
/// front. So does the momentum where no wall of a wedge pushes, that is in the plane, less what p at r = 0 gives.
inline Defect balances(const Flow& flow) {
    const double last = times.back() / flow.gas.v0;
    Defect defect;
    for (const double R : {1.0001 * flow.front(last), 3.7 * flow.front(last)}) {
        for (const double from : {0.0, 0.2 * last}) {
            for (const std::size_t k : {0, 1, 2}) {
                if (k == 1 && flow.j() > 1) continue;
                const auto content = [&](double t) {
                    return shell(flow, 0, R, t, [k](const Noh::State& s) { return densities(s)[k]; });
                };
                const auto flux = integral(
                    [&](double t) {
                        return fluxes(flow.at(0, t))[k] * (flow.j() == 1 ? 1 : 0) -
                               fluxes(flow.at(R, t))[k] * flow.area(R);
                    },
                    from, last);
                const auto [before, after] = std::pair{content(from), content(last)};
                const double scale = std::abs(before.value) + std::abs(after.value) + std::abs(flux.value);
                defect.add(after.value - before.value - flux.value, before.error + after.error + flux.error, scale);
            }
        }
    }
    return defect;
}

/// Means are the fields' integrals over a shell, over its volume.
inline Defect means(const Flow& flow) {
    Defect defect;
    for (const double time : times) {
        const double t = time / flow.gas.v0;
        const double s = flow.front(t);
        for (const auto& [a, b] :
             {std::pair{0.0, s / 3}, std::pair{0.0, 2 * s}, std::pair{s / 2, s}, std::pair{s, 1.01 * s},
              std::pair{0.9 * s, 1.3 * s}, std::pair{0.999 * s, 1.0001 * s}, std::pair{7 * s, 40 * s}}) {
            const auto mean = flow.mean(a, b, t);
            const auto volume = integral([&](double r) { return flow.area(r); }, a, b);
            const double share = 4 * eps * s / (b - a);  // of the front's own place, 2 ulp
            for (double Noh::State::*field :
                 {&Noh::State::velocity, &Noh::State::density, &Noh::State::pressure, &Noh::State::energy}) {
                const auto total = shell(flow, a, b, t, [field](const Noh::State& state) { return state.*field; });
                const double jump = std::abs(flow.at(s, t).*field) + std::abs(flow.at(0, t).*field);
                defect.add(mean.*field - total.value / volume.value,
                           (total.error + volume.error * jump) / volume.value + (share + 16 * eps) * jump, jump);
            }
        }
    }
    return defect;
}

/// There is no length in the data: only r / t matters.
inline Defect similarity(const Flow& flow) {
    Defect defect;
    at_samples(flow, [&](double r, double t) {
        const auto here = flow.at(r, t);
        for (const double k : {1e-3, 0.7, 91.0}) {
            const auto there = flow.at(k * r, k * t);
            defect.add(there.density - here.density, 16 * eps * here.density, here.density);
            defect.add(there.velocity - here.velocity, 0, flow.gas.v0);
            defect.add(there.energy - here.energy, 0, flow.gas.v0 * flow.gas.v0);
        }
    });
    return defect;
}

struct Gate {
    std::string name;
    Defect (*defect)(const Flow& flow);
};
inline const std::vector<Gate> gates{{"data", data},
                                     {"equation of state", equation_of_state},
                                     {"jump conditions", jump_conditions},
                                     {"Euler equations", euler_equations},
                                     {"balances", balances},
                                     {"means", means},
                                     {"similarity", similarity}};

/// Names of the gates that the flow does not pass, joined.
inline std::string ringing(const Flow& flow) {
    std::string names;
    for (const auto& [name, defect] : gates) {
        if (!defect(flow).holds()) names += name + "; ";
    }
    return names;
}

}  // namespace ordo::oracles::gate::implosion

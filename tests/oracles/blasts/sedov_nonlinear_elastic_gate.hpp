#pragma once
// What is true of a blast in a nonlinear elastic material, and how nearly what holds only in the limit of strong
// shocks.
#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "oracles/blasts/sedov_nonlinear_elastic.hpp"
#include "oracles/numerics/root.hpp"
#include "tests/oracles/differences.hpp"

namespace ordo::oracles::gate::elastic_blast {

inline constexpr double eps = std::numeric_limits<double>::epsilon();

/// A claimed blast in a material, with the data that it was claimed for.
struct ClaimedElasticBlast {
    ElasticBlast given;
    std::function<SedovNonlinearElastic::State(double x, double t)> at;
    std::function<double(double t)> shock;

    double strength(double t) const {  ///< M^2 by the shock's motion
        const double U = first_derivative(shock, t, 0.05 * t, 0).value;
        return given.rho0 * U * U / given.E;
    }
};

inline ClaimedElasticBlast claim_of(const ElasticBlast& given) {
    const SedovNonlinearElastic solid(given);
    return {given, [solid](double x, double t) { return solid.at(x, t); },
            [solid](double t) { return solid.blast().front(t).r; }};
}

/// C(lambda, T), the energy per reference volume, as printed with the materials.
inline double energy_of(const ElasticBlast& given, double lambda, double T) {
    const double E = given.E;
    const double heat = given.c_v * std::pow(lambda, -given.k) * T;
    switch (given.material) {
        case ElasticBlast::Material::A: return E / 3 * (lambda * lambda / 2 + 1 / lambda - 1.5) + heat;
        case ElasticBlast::Material::B: return E / 2 * (lambda * lambda / 2 - std::log(lambda) - 0.5) + heat;
        case ElasticBlast::Material::C: return E * (lambda * std::log(lambda) - lambda + 1) + heat;
    }
    return 0;
}

inline constexpr std::array places{-0.93, -0.6, -0.31, 0.22, 0.48, 0.77, 0.97};  ///< of the shock's radius

/// lambda = rho0 / rho, strain = lambda - 1, C = rho0 energy, -p = stress = dC/dlambda at fixed T.
inline Defect law(const ClaimedElasticBlast& blast) {
    Defect defect;
    const double t = 1.7;
    for (const double share : places) {
        const auto s = blast.at(share * blast.shock(t), t);
        const double lambda = blast.given.rho0 / s.density;
        const double C = energy_of(blast.given, lambda, s.temperature);
        const auto slope = first_derivative([&](double l) { return energy_of(blast.given, l, s.temperature); }, lambda,
                                            0.03 * lambda / (1 + 0.1 * blast.given.k), 8 * eps * C);
        defect.add(s.strain - (lambda - 1), 8 * eps * (1 + lambda), 1 + lambda);
        defect.add(blast.given.rho0 * s.energy - C, 1e-13 * C, C);
        defect.add(s.stress + s.pressure, 0, s.pressure);
        defect.add(s.stress - slope.value, slope.error + 1e-12 * s.pressure, s.pressure);
    }
    return defect;
}

/// rho_t + (rho u)_x = 0 and rho (u_t + u u_x) = sigma_x, times t over the size of their terms.
inline Defect balance(const ClaimedElasticBlast& blast) {
    Defect defect;
    const double t = 1.7;
    const double R = blast.shock(t);
    for (const double share : places) {
        const double x = share * R;
        const double in_x = 0.03 * std::min(std::abs(x), R - std::abs(x));
        const double in_t = in_x / R * t;
        const auto both = [&](auto&& field, double noise) {
            return std::pair{first_derivative([&](double y) { return field(blast.at(y, t)); }, x, in_x, noise),
                             first_derivative([&](double s) { return field(blast.at(x, s)); }, t, in_t, noise)};
        };
        const auto here = blast.at(x, t);
        const double steep = 1e-14 * (1 + 1 / blast.given.k);
        const auto [rho_x, rho_t] = both([](const auto& s) { return s.density; }, here.density * steep);
        const auto [u_x, u_t] = both([](const auto& s) { return s.velocity; }, std::abs(here.velocity) * steep);
        const auto [s_x, s_t] = both([](const auto& s) { return s.stress; }, here.pressure * steep);
        const double u = here.velocity;
        const double rho = here.density;
        defect.add((rho_t.value + u * rho_x.value + rho * u_x.value) * t / rho,
                   (rho_t.error + std::abs(u) * rho_x.error + rho * u_x.error) * t / rho + 1e-11, 1);
        const double size = here.pressure / R;
        defect.add(rho * (u_t.value + u * u_x.value) - s_x.value,
                   rho * (u_t.error + std::abs(u) * u_x.error) + s_x.error + 1e-11 * size, size);
    }
    return defect;
}

/// The other side is the mirror image; at both shocks the state on the right holds; ahead nothing has happened.
inline Defect two_sides(const ClaimedElasticBlast& blast) {
    Defect defect;
    const double t = 0.6;
    const double R = blast.shock(t);
    for (const double share : places) {
        const auto a = blast.at(share * R, t), b = blast.at(-share * R, t);
        defect.add(a.velocity + b.velocity, 0, 1);
        defect.add(std::abs(a.density - b.density) + std::abs(a.temperature - b.temperature), 0, 1);
        defect.add(a.velocity * share > 0 ? 0 : 1, 0, 1);
    }
    for (const double x : {R, 1.5 * R, -1.5 * R}) {
        const auto rest = blast.at(x, t);
        defect.add(std::abs(rest.velocity) + std::abs(rest.stress) + std::abs(rest.temperature) +
                       std::abs(rest.energy) + std::abs(rest.strain) + std::abs(rest.density - blast.given.rho0),
                   0, 1);
    }
    const auto inside = blast.at(-R, t), near = blast.at(-R * (1 - eps), t);
    defect.add(inside.density - near.density, 1e-12 * near.density * (1 + 1 / blast.given.k), near.density);
    defect.add(inside.velocity - near.velocity, 1e-12 * R / t, R / t);
    return defect;
}

struct ElasticGate {
    std::string name;
    Defect (*defect)(const ClaimedElasticBlast&);
};
inline const std::vector<ElasticGate> elastic_gates{{"law", law}, {"balance", balance}, {"two sides", two_sides}};

/// What holds only as M^2 grows: differences relative to their terms, at time t.
struct LimitErrors {
    double stretch;      ///< behind the shock, against the exact relations of a strong shock at this M^2
    double hugoniot;     ///< C - rho0 u^2 / 2 behind the shock
    double temperature;  ///< DT/Dt at x = 0.6 R
    double total;        ///< energy on one side against what was released, from x = R / 10 on
};

/// The stretch behind a shock of that M^2 into cold, relaxed material: -sigma = rho0 U^2 (1 - lambda),
/// C = rho0 U^2 (1 - lambda)^2 / 2, with T eliminated: g'/g = (sigma - C_s') / (C - C_s) over c_v.
inline double exact_stretch(const ElasticBlast& given, double m2) {
    const double k = given.k;
    const double scale = m2 * given.E;
    const auto defect = [&](double lambda) {
        const double C_s = energy_of(given, lambda, 0);
        const double C_s_slope =
            first_derivative([&](double l) { return energy_of(given, l, 0); }, lambda, 0.02 * lambda, 0).value;
        const double heat = scale * (1 - lambda) * (1 - lambda) / 2 - C_s;
        return -k / lambda * heat + scale * (1 - lambda) + C_s_slope;
    };
    return bracketed_root(defect, 0.5 * k / (k + 2), 0.5 * (1 + k / (k + 2)));
}

inline LimitErrors limit_errors(const ClaimedElasticBlast& blast, double t) {
    const double R = blast.shock(t);
    const auto behind = blast.at(R * (1 - eps), t);
    const double rho0 = blast.given.rho0;
    LimitErrors errors{};
    errors.stretch = rho0 / behind.density / exact_stretch(blast.given, blast.strength(t)) - 1;
    errors.hugoniot = 2 * behind.energy / (behind.velocity * behind.velocity) - 1;
    const double x = 0.6 * R;
    const auto here = blast.at(x, t);
    const double step = 0.005 * R;
    const auto T_x = first_derivative([&](double y) { return blast.at(y, t).temperature; }, x, step, 0);
    const auto T_t = first_derivative([&](double s) { return blast.at(x, s).temperature; }, t, step / R * t, 0);
    errors.temperature = (T_t.value + here.velocity * T_x.value) * t / here.temperature;
    boost::math::quadrature::tanh_sinh<double> quadrature;
    const auto density = [&](double y) {
        const auto s = blast.at(y, t);
        return s.density * (s.velocity * s.velocity / 2 + s.energy);
    };
    const auto gas = [&](double y) {
        const auto s = blast.at(y, t);
        return s.density * s.velocity * s.velocity / 2 + s.pressure / blast.given.k;
    };
    // The same gas's energy within R / 10, where the stretch is beyond the limit.
    errors.total = (quadrature.integrate(density, 0.1 * R, R * (1 - eps), 1e-11) +
                    quadrature.integrate(gas, 0.0, 0.1 * R, 1e-11)) /
                       blast.given.energy -
                   1;
    return errors;
}

}  // namespace ordo::oracles::gate::elastic_blast

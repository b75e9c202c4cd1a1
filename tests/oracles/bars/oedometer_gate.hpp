#pragma once
// What is true of the oedometer, dynamic and at rest: the gates of loaded bars with gravity as their pull, and balance,
// law and integral of the static columns.
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <utility>

#include "oracles/bars/oedometer.hpp"
#include "oracles/bars/oedometer_static.hpp"
#include "tests/oracles/bars/bar_traction_gate.hpp"

namespace ordo::oracles::gate::loaded {

/// The share of gravity at time t, by the words of the declaration: a quintic with two vanishing derivatives at 0 and
/// at T, which are its Hermite conditions (0, 0, 0) and (1, 0, 0); in Bernstein form.
inline double gravity_share(double T, double t) {
    if (t >= T) return 1;
    const double s = t / T, r = 1 - s;
    return 10 * s * s * s * r * r + 5 * s * s * s * s * r + s * s * s * s * s;
}

inline BarMotion motion_of(const Oedometer& column) {
    const double c_by_H = std::sqrt(column.E / column.rho) / column.H;
    BarMotion motion{
        .L = column.H,
        .E = column.E,
        .rho = column.rho,
        .load = [=](double) { return column.p0; },
        .pull = [=](double t) { return -column.g * gravity_share(column.ramp, t); },
        .starts = {0.0},
        .radians = c_by_H,
        .displacement = {},
        .velocity = {},
        .strain = {},
        .stress = {},
        .jumps = [=](double t) { return column.p0 != 0 ? std::vector{column.load_front(t)} : std::vector<double>{}; }};
    if (column.ramp > 0) motion.starts.push_back(column.ramp);
    return with_members(std::move(motion), column);
}

/// A claimed column at rest.
struct Column {
    using OfX = std::function<double(double X)>;

    OedometerStatic data;
    OfX displacement, strain, stress;
};

inline Column column_of(const OedometerStatic& data) {
    return {data, [data](double X) { return data.displacement(X); }, [data](double X) { return data.strain(X); },
            [data](double X) { return data.stress(X); }};
}

/// P of F, as each law is named.
inline double nominal_stress(const OedometerStatic& data, double F) {
    using Law = OedometerStatic::Law;
    switch (data.law) {
        case Law::nominal: return data.E * (F - 1);
        case Law::reciprocal: return data.E * (1 - 1 / F);
        case Law::logarithmic: return data.E * std::log(F);
        case Law::kirchhoff: return data.E * std::log(F) / F;
        case Law::neo_hookean: break;
    }
    return data.E / 2 * (F - 1 / F);
}

/// dP/dX = rho g and P(H) = p0; P is the law's at F = 1 + strain; u(0) = 0 and u(X) = int_0^X strain.
inline Defect column_at_rest(const Column& column) {
    const auto& data = column.data;
    const double load = std::abs(data.p0) + data.rho * data.g * data.H;
    const double most = std::max(std::abs(column.strain(0)), std::abs(column.strain(data.H)));
    Defect defect;
    defect.add(column.stress(data.H) - data.p0, 1e-15 * load, load);
    defect.add(column.displacement(0), 0, 1);
    for (const double share : bar_places) {
        const double X = share * data.H;
        const auto slope = first_derivative([&](double s) { return column.stress(s); }, X, 0.04 * data.H, 1e-15 * load);
        defect.add(slope.value - data.rho * data.g, slope.error, load / data.H);
        // P from F: 1 + strain is rounded, and with it P by 2 ulp of E (1 + F) dP/dF.
        const double F = 1 + column.strain(X);
        const double stiffness = std::abs(nominal_stress(data, F * (1 + 1e-6)) - nominal_stress(data, F)) / 1e-6;
        const double rounding = 1e-15 * (stiffness * (1 + 1 / F) + load + data.E * (1 + 1 / F));
        defect.add(nominal_stress(data, F) - column.stress(X), rounding, load);
        double error = 0;
        const double integral = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
            [&](double s) { return column.strain(s); }, 0, X, 6, 1e-13, &error);
        defect.add(column.displacement(X) - integral, error + 1e-14 * most * data.H, most * data.H);
    }
    return defect;
}

}  // namespace ordo::oracles::gate::loaded

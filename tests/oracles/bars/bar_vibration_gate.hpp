#pragma once
// What is true of a vibrating bar, said without the oracle's formulas: functions over callables, so that faulty motions
// can be passed too.
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "oracles/bars/bar_vibration.hpp"
#include "tests/oracles/differences.hpp"

namespace ordo::oracles::gate::vibration {

inline constexpr double pi = 3.141592653589793;
inline constexpr double eps = std::numeric_limits<double>::epsilon();

using OfXt = std::function<double(double X, double t)>;

/// A bar's claimed motion, with the data that it was claimed for.
struct Motion {
    BarVibration bar;
    OfXt displacement, velocity, strain, stress;

    bool free_end() const { return bar.ends == BarVibration::Ends::fixed_free; }
    double transit() const { return bar.L / std::sqrt(bar.E / bar.rho); }  ///< a wave's travel time over the bar [s]
    int lobes() const { return bar.ends == BarVibration::Ends::periodic ? 2 * bar.mode : bar.mode; }
    /// That lie on the bar.
    double half_waves() const { return free_end() ? bar.mode - 0.5 : lobes(); }
    double half_wave() const { return bar.L / half_waves(); }  ///< [m]

    /// The stated accuracy, relative to the amplitude: 2 ulp times (1 + kX + omega t), phases counted in half waves.
    double accuracy(double X, double t) const {
        return 2 * eps * (1 + pi * half_waves() * (X / bar.L + t / transit()));
    }
};

inline Motion motion_of(const BarVibration& bar) {
    return {bar, [bar](double X, double t) { return bar.displacement(X, t); },
            [bar](double X, double t) { return bar.velocity(X, t); },
            [bar](double X, double t) { return bar.strain(X, t); },
            [bar](double X, double t) { return bar.stress(X, t); }};
}

// No simple fractions, which are nodes of some mode.
inline constexpr std::array places{0.0, 0.08317, 0.21429, 0.38541, 0.50213, 0.66759, 0.81337, 0.97051, 1.0};  ///< X / L
inline constexpr std::array times{0.0, 0.13147, 0.70923, 1.90671, 5.31083};  ///< t / transit

template <class Visit>
void at_samples(const Motion& motion, Visit&& visit) {
    for (const double X : places) {
        for (const double t : times) visit(X * motion.bar.L, t * motion.transit());
    }
}

inline double largest(const Motion& motion, const OfXt& f) {
    double most = 0;
    at_samples(motion, [&](double X, double t) { most = std::max(most, std::abs(f(X, t))); });
    return most;
}

/// Steps of 0.05 half waves: truncation and round-off are both near 1e-11 of the derivative.
inline constexpr double step_share = 0.05;

/// rho u_tt = E u_XX.
inline Defect equation_of_motion(const Motion& motion) {
    const auto& [L, E, rho, v0, mode, ends] = motion.bar;
    const double in_X = step_share * motion.half_wave();
    const double in_t = in_X * motion.transit() / L;
    const double amplitude = largest(motion, motion.displacement);
    double scale = 0;
    std::vector<std::pair<double, double>> residuals;
    at_samples(motion, [&](double X, double t) {
        const double noise = amplitude * motion.accuracy(X + 4 * in_X, t + 4 * in_t);
        const auto u_tt = second_derivative([&](double s) { return motion.displacement(X, s); }, t, in_t, noise);
        const auto u_XX = second_derivative([&](double s) { return motion.displacement(s, t); }, X, in_X, noise);
        scale = std::max(scale, std::abs(E * u_XX.value));
        residuals.emplace_back(rho * u_tt.value - E * u_XX.value, rho * u_tt.error + E * u_XX.error);
    });
    Defect defect;
    for (const auto& [difference, error] : residuals) defect.add(difference, error, scale);
    return defect;
}

/// velocity = u_t, strain = u_X, stress = E u_X.
inline Defect derivatives(const Motion& motion) {
    const double in_X = step_share * motion.half_wave();
    const double in_t = in_X * motion.transit() / motion.bar.L;
    const double amplitude = largest(motion, motion.displacement);
    const double v_scale = std::abs(motion.bar.v0);
    const double strain_scale = largest(motion, motion.strain);
    Defect defect;
    at_samples(motion, [&](double X, double t) {
        const double accuracy = motion.accuracy(X + 4 * in_X, t + 4 * in_t);
        const auto u_t =
            first_derivative([&](double s) { return motion.displacement(X, s); }, t, in_t, amplitude * accuracy);
        const auto u_X =
            first_derivative([&](double s) { return motion.displacement(s, t); }, X, in_X, amplitude * accuracy);
        defect.add(motion.velocity(X, t) - u_t.value, u_t.error + accuracy * v_scale, v_scale);
        defect.add(motion.strain(X, t) - u_X.value, u_X.error + accuracy * strain_scale, strain_scale);
        defect.add(motion.stress(X, t) / motion.bar.E - u_X.value, u_X.error + accuracy * strain_scale, strain_scale);
    });
    return defect;
}

/// u = 0 at a fixed end, no traction at a free one.
inline Defect boundary_data(const Motion& motion) {
    const double L = motion.bar.L;
    const double u_scale = largest(motion, motion.displacement);
    const double stress_scale = largest(motion, motion.stress);
    Defect defect;
    for (const double share : times) {
        const double t = share * motion.transit();
        defect.add(motion.displacement(0, t), motion.accuracy(0, t) * u_scale, u_scale);
        if (motion.free_end()) defect.add(motion.stress(L, t), motion.accuracy(L, t) * stress_scale, stress_scale);
        else defect.add(motion.displacement(L, t), motion.accuracy(L, t) * u_scale, u_scale);
    }
    return defect;
}

/// At t = 0: u = 0; the velocity has lobes of height v0 and alternating sign, half a wave apart, the first one
/// v0 itself; it is nowhere larger, and between them it passes zero.
inline Defect initial_data(const Motion& motion) {
    const double v0 = motion.bar.v0;
    const double u_scale = largest(motion, motion.displacement);
    Defect defect;
    for (int lobe = 0; lobe < motion.lobes(); ++lobe) {
        const double X = (lobe + 0.5) * motion.half_wave();
        defect.add(motion.velocity(X, 0) - (lobe % 2 == 0 ? v0 : -v0), motion.accuracy(X, 0) * std::abs(v0),
                   std::abs(v0));
        defect.add(motion.displacement(X, 0), motion.accuracy(X, 0) * u_scale, u_scale);
    }
    int zeros = 0;
    const int parts = 64 * motion.lobes() + 1;  // prime to the half waves: no sample sits on a zero
    for (int k = 1; k < parts; ++k) {
        const double here = motion.velocity(motion.bar.L * k / parts, 0);
        if (k > 1) zeros += here * motion.velocity(motion.bar.L * (k - 1) / parts, 0) < 0;
        defect.add(std::max(0.0, std::abs(here / v0) - 1), motion.accuracy(motion.bar.L, 0), 1);
    }
    defect.add(zeros - (motion.lobes() - 1), 0, 1);
    return defect;
}

/// The smallest T with u(t + T) = u(t), by counting transits: between two fixed ends a wave is itself again after one
/// way up and one back, and `mode` equal lobes repeat `mode` times as often. A free end gives it back with its sign, so
/// that it takes two round trips, and the 2 mode - 1 quarter waves on the bar repeat as many times as often.
/// If a smaller T were a period, T would be a whole multiple of it.
inline Defect period(const Motion& motion) {
    const double T = motion.free_end() ? 4 * motion.transit() / (2 * motion.bar.mode - 1)
                                       : 2 * motion.transit() / motion.half_waves();
    const double scale = largest(motion, motion.displacement);
    Defect defect;
    std::array<double, 8> change{};
    at_samples(motion, [&](double X, double t) {
        const double u = motion.displacement(X, t);
        defect.add(motion.displacement(X, t + T) - u, 2 * motion.accuracy(X, t + T) * scale, scale);
        for (int m = 2; m < 8; ++m)
            change[m] = std::max(change[m], std::abs(motion.displacement(X, t + T / m) - u) / scale);
    });
    for (int m = 2; m < 8; ++m) defect.add(change[m] > 0.1 ? 0 : 1, 0, 1);
    return defect;
}

/// Kinetic and elastic energy of the whole bar together stay what they were at t = 0.
inline Defect energy(const Motion& motion) {
    const auto total = [&](double t, double* error) {
        const auto density = [&](double X) {
            const double v = motion.velocity(X, t);
            return 0.5 * motion.bar.rho * v * v + 0.5 * motion.stress(X, t) * motion.strain(X, t);
        };
        return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(density, 0, motion.bar.L, 8, 1e-13, error);
    };
    double start_error = 0;
    const double start = total(0, &start_error);
    Defect defect;
    for (const double share : times) {
        const double t = share * motion.transit();
        double error = 0;
        const double now = total(t, &error);
        // A square doubles the fields' relative error, the two parts double it again, and the mean of sin^2 is 1/2.
        defect.add(now - start, error + start_error + 8 * motion.accuracy(motion.bar.L, t) * start, start);
    }
    return defect;
}

/// Means of displacement, velocity, stress and strain over [a, b] at time t.
using Means = std::function<std::array<double, 4>(double a, double b, double t)>;

/// They are integrals of the fields by quadrature, over cells from the whole bar down to a few ulp. Gauss-Kronrod with
/// 31 points is exact to round-off on a piece of one half wave: its error is of order (pi / 2)^48 / 48!.
inline Defect cell_averages(const Motion& motion, const Means& means) {
    const std::array fields{motion.displacement, motion.velocity, motion.stress, motion.strain};
    const double L = motion.bar.L;
    Defect defect;
    for (std::size_t i = 0; i < 4; ++i) {
        const double scale = largest(motion, fields[i]);
        for (const double low : {0.0, 0.21429, 0.66759}) {
            for (const double width : {1.0, 0.31347, 0.01, 1e-6, 1e-13}) {
                const double a = low * L, b = std::min(low + width, 1.0) * L;
                for (const double share : {0.13147, 5.31083}) {
                    const double t = share * motion.transit();
                    const double pieces = std::ceil((b - a) / motion.half_wave());
                    const double piece = (b - a) / pieces;
                    double sum = 0;
                    for (double k = 0; k < pieces; ++k) {
                        sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                            [&](double X) { return fields[i](X, t); }, a + k * piece, a + (k + 1) * piece, 0);
                    }
                    const double mean = means(a, b, t)[i];
                    defect.add(mean - sum / (b - a), 4 * motion.accuracy(b, t) * scale, scale);
                }
            }
        }
    }
    return defect;
}

struct Gate {
    std::string name;
    Defect (*defect)(const Motion&);
};
inline const std::vector<Gate> gates{{"equation of motion", equation_of_motion},
                                     {"derivatives", derivatives},
                                     {"boundary data", boundary_data},
                                     {"initial data", initial_data},
                                     {"period", period},
                                     {"energy", energy}};

}  // namespace ordo::oracles::gate::vibration

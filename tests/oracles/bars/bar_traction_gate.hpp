#pragma once
// What is true of a bar at rest that loads set in motion, fixed at X = 0: said without any formula of its motion, over
// callables, so that faulty motions can be passed too. Fronts run along lines X +- c (t - start) = a multiple of L; off
// them the fields are smooth.
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "oracles/bars/bar_traction.hpp"
#include "tests/oracles/differences.hpp"

namespace ordo::oracles::gate::loaded {

/// A claimed motion with the data that it was claimed for: rho u_tt = E u_XX + rho pull(t), E u_X(L, t) = load(t).
struct BarMotion {
    using OfT = std::function<double(double t)>;
    using OfXt = std::function<double(double X, double t)>;

    double L, E, rho;
    OfT load, pull;
    std::vector<double> starts;  ///< times at which load or pull are not smooth, 0 included
    double radians;              ///< largest phase speed of loads and bar, for the stated accuracy [1/s]
    OfXt displacement, velocity, strain, stress;
    std::function<std::vector<double>(double t)> jumps;

    double speed() const { return std::sqrt(E / rho); }
    double transit() const { return L / speed(); }
    double accuracy(double t) const { return 1e-14 * (1 + radians * t); }  ///< as stated, relative
};

/// The struct's members, and an oracle's jumps.
template <class Bar>
BarMotion with_members(BarMotion motion, const Bar& bar) {
    motion.displacement = [bar](double X, double t) { return bar.displacement(X, t); };
    motion.velocity = [bar](double X, double t) { return bar.velocity(X, t); };
    motion.strain = [bar](double X, double t) { return bar.strain(X, t); };
    motion.stress = [bar](double X, double t) { return bar.stress(X, t); };
    return motion;
}

inline BarMotion motion_of(const BarTraction& bar) {
    const bool sine = bar.profile == BarTraction::Profile::sine;
    const double c_by_L = std::sqrt(bar.E / bar.rho) / bar.L;
    BarMotion motion{.L = bar.L,
                     .E = bar.E,
                     .rho = bar.rho,
                     .load = [=](double t) { return sine ? bar.tau * std::sin(bar.omega * t) : bar.tau; },
                     .pull = [](double) { return 0.0; },
                     .starts = {0.0},
                     .radians = sine ? bar.omega : c_by_L,
                     .displacement = {},
                     .velocity = {},
                     .strain = {},
                     .stress = {},
                     .jumps = [=](double t) { return sine ? std::vector<double>{} : std::vector{bar.front(t)}; }};
    return with_members(std::move(motion), bar);
}

// No simple fractions: a stencil of 4 steps about (X, t) is then clear of the fronts, or it is left out.
inline constexpr std::array bar_places{0.17043, 0.25419, 0.38541, 0.50213, 0.63759, 0.71337, 0.83051};  ///< X / L
inline constexpr std::array bar_times{0.21147, 0.37019, 0.70923, 1.30671, 1.87083, 2.43317, 3.31907, 5.29137, 12.83011};
inline constexpr double bar_step = 0.02;  ///< of L and of a transit

/// Distance from the nearest front, in lengths L.
inline double clearance(const BarMotion& motion, double X, double t) {
    double nearest = t / motion.transit();
    for (const double start : motion.starts) {
        for (const double side : {1.0, -1.0}) {
            const double path = (t - start) / motion.transit() + side * X / motion.L;
            nearest = std::min(nearest, std::abs(path - std::round(path)));
        }
        nearest = std::min(nearest, std::abs(t - start) / motion.transit());
    }
    return nearest;
}

template <class Visit>
int at_bar_samples(const BarMotion& motion, Visit&& visit) {
    int count = 0;
    for (const double X : bar_places) {
        for (const double t : bar_times) {
            if (clearance(motion, X * motion.L, t * motion.transit()) < 4.1 * bar_step) continue;
            visit(X * motion.L, t * motion.transit());
            ++count;
        }
    }
    return count;
}

/// Largest value at times up to `end`, and at the very least of the first transits.
inline double largest_until(const BarMotion& motion, const BarMotion::OfXt& f, double end) {
    double most = 0;
    const double step = std::max(0.173, end / motion.transit() / 400);
    for (double t = 0.05; t < std::max(0.2, end / motion.transit()); t += step) {
        for (double X = 0; X <= 1; X += 0.125) most = std::max(most, std::abs(f(X * motion.L, t * motion.transit())));
    }
    return most;
}

/// Largest value up to a little after the last sample.
inline double largest(const BarMotion& motion, const BarMotion::OfXt& f) {
    return largest_until(motion, f, 13 * motion.transit());
}

/// rho u_tt = E u_XX + rho pull, and velocity = u_t, strain = u_X, stress = E u_X.
inline Defect bar_equation(const BarMotion& motion) {
    const double in_X = bar_step * motion.L;
    const double in_t = bar_step * motion.transit();
    const double amplitude = largest(motion, motion.displacement);
    const double v_scale = largest(motion, motion.velocity);
    const double strain_scale = largest(motion, motion.strain);
    const double force = motion.E * strain_scale / motion.L;
    Defect defect;
    const int count = at_bar_samples(motion, [&](double X, double t) {
        const double accuracy = motion.accuracy(t + 4 * in_t);
        const double noise = amplitude * accuracy;
        const auto in_time = [&](double s) { return motion.displacement(X, s); };
        const auto in_space = [&](double s) { return motion.displacement(s, t); };
        const auto u_tt = second_derivative(in_time, t, in_t, noise);
        const auto u_XX = second_derivative(in_space, X, in_X, noise);
        const auto u_t = first_derivative(in_time, t, in_t, noise);
        const auto u_X = first_derivative(in_space, X, in_X, noise);
        defect.add(motion.rho * u_tt.value - motion.E * u_XX.value - motion.rho * motion.pull(t),
                   motion.rho * u_tt.error + motion.E * u_XX.error, force);
        defect.add(motion.velocity(X, t) - u_t.value, u_t.error + accuracy * v_scale, v_scale);
        defect.add(motion.strain(X, t) - u_X.value, u_X.error + accuracy * strain_scale, strain_scale);
        defect.add(motion.stress(X, t) / motion.E - u_X.value, u_X.error + accuracy * strain_scale, strain_scale);
    });
    defect.add(count > 10 ? 0 : 1, 0, 1);
    return defect;
}

/// u = 0 at the fixed end, the load at the other one; at rest and unstressed at t = 0.
inline Defect bar_data(const BarMotion& motion) {
    const double u_scale = largest(motion, motion.displacement);
    const double v_scale = largest(motion, motion.velocity);
    const double stress_scale = largest(motion, motion.stress);
    Defect defect;
    for (const double share : bar_times) {
        const double t = share * motion.transit();
        defect.add(motion.displacement(0, t), motion.accuracy(t) * u_scale, u_scale);
        defect.add(motion.velocity(0, t), motion.accuracy(t) * v_scale, v_scale);
        defect.add(motion.stress(motion.L, t) - motion.load(t), motion.accuracy(t) * stress_scale, stress_scale);
    }
    for (const double X : bar_places) {
        defect.add(motion.displacement(X * motion.L, 0), 1e-16 * u_scale, u_scale);
        defect.add(motion.velocity(X * motion.L, 0), 1e-16 * v_scale, v_scale);
        defect.add(motion.stress(X * motion.L, 0), 1e-16 * stress_scale, stress_scale);
    }
    return defect;
}

/// Where the integrand over [low, high] may not be smooth, both ends included.
inline std::vector<double> parts(double low, double high, std::vector<double> inner) {
    std::erase_if(inner, [&](double cut) { return cut <= low || cut >= high; });
    inner.insert(inner.end(), {low, high});
    std::sort(inner.begin(), inner.end());
    return inner;
}

template <class F>
double integral(const std::vector<double>& cuts, F f) {
    double sum = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i)
        sum += boost::math::quadrature::gauss<double, 15>::integrate(f, cuts[i - 1], cuts[i]);
    return sum;
}

/// Places of fronts at time t, of every start and of both ends.
inline std::vector<double> front_places(const BarMotion& motion, double t) {
    std::vector<double> places;
    for (const double start : motion.starts) {
        const double path = (t - start) / motion.transit();
        const double share = path - std::floor(path);
        places.insert(places.end(), {share * motion.L, (1 - share) * motion.L});
    }
    return places;
}

/// Kinetic and elastic energy are the work of the load and of the pull.
inline Defect bar_energy(const BarMotion& motion) {
    const double scale = motion.E * std::pow(largest(motion, motion.strain), 2) * motion.L;
    const auto over_bar = [&](double t, auto f) { return integral(parts(0, motion.L, front_places(motion, t)), f); };
    const auto power = [&](double t) {
        const double pull = motion.pull(t);
        const double load = motion.load(t) * motion.velocity(motion.L, t);
        if (pull == 0) return load;
        return load + motion.rho * pull * over_bar(t, [&](double X) { return motion.velocity(X, t); });
    };
    std::vector<double> visits;
    for (const double start : motion.starts) {
        for (int n = 0; n < 14; ++n) visits.push_back(start + n * motion.transit());
    }
    Defect defect;
    double work = 0;
    double from = 0;
    for (const double share : bar_times) {
        const double t = share * motion.transit();
        work += integral(parts(from, t, visits), power);
        from = t;
        const double energy = over_bar(t, [&](double X) {
            const double v = motion.velocity(X, t);
            return 0.5 * motion.rho * v * v + 0.5 * motion.stress(X, t) * motion.strain(X, t);
        });
        // Energy and work are squares of fields that are true to `accuracy`; a front misplaced by it adds as much.
        defect.add(energy - work, 8 * motion.accuracy(t) * scale, scale);
    }
    return defect;
}

/// At a jump u is continuous, [v] = -s [u_X] and [stress] = -rho s [v] with the front's velocity s, and the value there
/// is the one to the right; elsewhere on the lines of fronts nothing jumps.
inline Defect bar_fronts(const BarMotion& motion) {
    const double u_scale = largest(motion, motion.displacement);
    const double v_scale = largest(motion, motion.velocity);
    const double strain_scale = largest(motion, motion.strain);
    const double gap = 1e-9 * motion.L;  // fields change by less than 1e-8 of their scale (theta < 10) over it
    Defect defect;
    for (const double share : bar_times) {
        const double t = share * motion.transit();
        const auto jumps = motion.jumps(t);
        for (const double X : jumps) {
            const double s = (motion.jumps(t + 1e-3 * motion.transit()).front() - X) / (1e-3 * motion.transit());
            const double left = X - gap, right = X + gap;
            const double v_jump = motion.velocity(right, t) - motion.velocity(left, t);
            const double stress_jump = motion.stress(right, t) - motion.stress(left, t);
            const double strain_jump = motion.strain(right, t) - motion.strain(left, t);
            defect.add(motion.displacement(right, t) - motion.displacement(left, t), 1e-8 * u_scale, u_scale);
            defect.add(v_jump + s * strain_jump, 4e-8 * v_scale, v_scale);
            defect.add(stress_jump + motion.rho * s * v_jump, 4e-8 * motion.E * strain_scale, motion.E * strain_scale);
            defect.add(std::abs(stress_jump) > 1e-3 * motion.E * strain_scale ? 0 : 1, 0, 1);
            defect.add(motion.velocity(X, t) - motion.velocity(right, t), 2e-8 * v_scale, v_scale);
            defect.add(motion.stress(X, t) - motion.stress(right, t), 2e-8 * motion.E * strain_scale,
                       motion.E * strain_scale);
        }
        for (const double X : front_places(motion, t)) {
            if (X < 2 * gap || X > motion.L - 2 * gap) continue;
            if (!jumps.empty() && std::abs(X - jumps.front()) < 2 * gap) continue;
            defect.add(motion.velocity(X + gap, t) - motion.velocity(X - gap, t), 4e-8 * v_scale, v_scale);
            defect.add(motion.strain(X + gap, t) - motion.strain(X - gap, t), 4e-8 * strain_scale, strain_scale);
        }
    }
    return defect;
}

struct BarGate {
    std::string name;
    Defect (*defect)(const BarMotion&);
};
inline const std::vector<BarGate> bar_gates{
    {"equation", bar_equation}, {"data", bar_data}, {"energy", bar_energy}, {"fronts", bar_fronts}};

/// Names of the gates that the motion does not pass, joined.
inline std::string ringing(const BarMotion& motion) {
    std::string names;
    for (const auto& [name, defect] : bar_gates) {
        if (!defect(motion).holds()) names += name + "; ";
    }
    return names;
}

/// The four fields of one point or cell, as a catalogue row.
using Row = std::array<double, 4>;

/// Means over cells are the integral of the point values, by quadrature between the fronts; tiny cells included.
inline Defect bar_averages(double L, const std::vector<double>& fronts, const Row& scale, double accuracy,
                           const std::function<Row(double X)>& at, const std::function<Row(double, double)>& mean) {
    Defect defect;
    const std::vector<std::pair<double, double>> cells{{0, 1},         {0, 0.3},           {0.2137, 0.8319},
                                                       {0.61, 0.6101}, {0.4, 0.4 + 1e-12}, {0.99, 1}};
    for (const auto& [low, high] : cells) {
        const double a = low * L, b = high * L;
        const Row found = mean(a, b);
        for (std::size_t i = 0; i < 4; ++i) {
            const double expected = integral(parts(a, b, fronts), [&](double X) { return at(X)[i]; }) / (b - a);
            const bool split = std::any_of(fronts.begin(), fronts.end(), [&](double X) { return X > a && X < b; });
            const double rounded = split ? 4e-16 * L / (b - a) : 0;  // the front's share of the cell
            defect.add(found[i] - expected, 4 * (accuracy + rounded) * scale[i], scale[i]);
        }
    }
    return defect;
}

}  // namespace ordo::oracles::gate::loaded

#pragma once
// What is true of a von Mises solid on a strain path to and fro, said without the oracles' formulas and for both of
// them, as tensors: faulty answers can be passed too.
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "oracles/plasticity/j2_simple_shear.hpp"
#include "oracles/plasticity/j2_uniaxial_strain.hpp"
#include "tests/oracles/differences.hpp"
#include "tests/oracles/plasticity/j2_integrator.hpp"

namespace ordo::oracles::gate::plasticity {

inline constexpr double eps = std::numeric_limits<double>::epsilon();

/// One claimed state, whole.
struct Claimed {
    double driven;  ///< the strain that the path speaks of
    Tensor strain, stress;
    double p, Y, q, plastic_work, elastic_energy;
};

/// A claimed history with the data that it was claimed for.
struct History {
    Metal metal;
    StrainPath path;
    std::function<Claimed(double t)> at;

    double M() const { return metal.K + 4 * metal.G / 3; }
    double travelled(double t) const { return std::abs(path.rate) * t; }
    double accuracy(double t) const { return 8 * eps * (metal.Y0 + M() * travelled(t)); }  ///< of a stress
    double time_of(double reversal) const {
        return (2 * reversal - 1) * path.peak / std::abs(path.rate);  // reversal = 1, 2, ...
    }
};

inline History history_of(const J2UniaxialStrain& solid) {
    return {{solid.K, solid.G, solid.Y0, solid.H}, solid.path, [solid](double t) {
                const auto s = solid.at(t);
                return Claimed{s.strain,
                               {s.strain, 0, 0, 0, 0, 0, 0, 0, 0},
                               {s.stress, 0, 0, 0, s.lateral_stress, 0, 0, 0, s.lateral_stress},
                               s.plastic_strain,
                               s.yield_stress,
                               s.equivalent_stress,
                               s.plastic_work,
                               s.elastic_energy};
            }};
}

/// K does not enter simple shear; any will do.
inline History history_of(const J2SimpleShear& solid) {
    return {{solid.G, solid.G, solid.Y0, solid.H}, solid.path, [solid](double t) {
                const auto s = solid.at(t);
                return Claimed{s.strain,
                               {0, s.strain / 2, 0, s.strain / 2, 0, 0, 0, 0, 0},
                               {0, s.stress, 0, s.stress, 0, 0, 0, 0, 0},
                               s.plastic_strain,
                               s.yield_stress,
                               s.equivalent_stress,
                               s.plastic_work,
                               s.elastic_energy};
            }};
}

/// Steps that end at the reversals, with unequal ones between; visit(from, to).
template <class Visit>
void at_steps(const History& history, Visit&& visit) {
    constexpr int legs = 9;
    double start = 0;
    for (int leg = 0; leg < legs; ++leg) {
        const double end = history.time_of(leg + 1);
        double from = start;
        for (const double share : {0.13, 0.371, 0.52, 0.793, 1.0}) {
            const double to = share == 1 ? end : start + share * (end - start);
            visit(from, to);
            from = to;
        }
        start = end;
    }
}

/// The strain is a triangle wave: arcsine of a sine. Off its corners, where the arcsine forgets digits.
inline Defect strain_path(const History& history) {
    const auto& [kind, rate, peak] = history.path;
    Defect defect;
    at_steps(history, [&](double from, double to) {
        const double t = 0.5 * (from + to);
        constexpr double pi = boost::math::constants::pi<double>();
        const double phase = 0.5 * pi * rate * t / peak;
        const double wave = kind == StrainPath::Kind::cycle ? 2 / pi * peak * std::asin(std::sin(phase)) : rate * t;
        defect.add(history.at(t).driven - wave, 64 * eps * history.travelled(t), peak);
    });
    defect.add(history.at(0).driven, 0, peak);
    return defect;
}

/// Backward Euler over large steps: exact here, since the deviator keeps its direction.
inline Defect integration(const History& history) {
    const double Y0 = history.metal.Y0;
    Point point;
    Claimed before = history.at(0);
    Defect defect;
    at_steps(history, [&](double, double to) {
        const Claimed now = history.at(to);
        point = backward_euler(history.metal, point, combined(1, now.strain, -1, before.strain));
        before = now;
        const Tensor off = combined(1, now.stress, -1, point.stress);
        defect.add(3 * history.metal.G * (now.p - point.p), 4 * history.accuracy(to), Y0);
        defect.add(std::sqrt(inner(off, off)), 4 * history.accuracy(to), Y0);
    });
    return defect;
}

/// q = von Mises of the stress, Y = Y0 + H p, q <= Y; p never falls, and grows only where the step ends at q = Y.
inline Defect consistency(const History& history) {
    const auto& [K, G, Y0, H] = history.metal;
    Defect defect;
    at_steps(history, [&](double from, double to) {
        const Claimed before = history.at(from);
        const Claimed now = history.at(to);
        const double slack = history.accuracy(to);
        defect.add(now.Y - Y0 - H * now.p, 2 * slack, Y0);
        defect.add(std::max(0.0, now.q - now.Y), 2 * slack, Y0);
        const double grown = 3 * G * (now.p - before.p);
        defect.add(std::min(0.0, grown), 2 * slack, Y0);
        if (grown > 2 * slack) defect.add(now.q - now.Y, 2 * slack, Y0);
        defect.add(now.q - von_mises(now.stress), 2 * slack, Y0);
    });
    return defect;
}

/// What the stress does on the strain is stored or dissipated, and what is dissipated never falls. The stress is linear
/// between reversals and the onsets of flow, which bisection finds; the trapezoid is exact between them.
inline Defect energy_balance(const History& history) {
    const double scale = history.metal.Y0 * history.metal.Y0 / history.metal.G;
    const auto work = [&](double from, double to) {
        const auto [a, b] = std::pair{history.at(from), history.at(to)};
        return 0.5 * inner(combined(1, a.stress, 1, b.stress), combined(1, b.strain, -1, a.strain));
    };
    double total = 0, slack = 0;
    Defect defect;
    at_steps(history, [&](double from, double to) {
        const Claimed before = history.at(from);
        const double onset = before.p + 2 * history.accuracy(to) / (3 * history.metal.G);  // more than round-off
        double low = from, high = to;
        while (high - low > 4 * eps * to) {
            const double middle = 0.5 * (low + high);
            (history.at(middle).p > onset ? high : low) = middle;
        }
        total += work(from, low) + work(low, to);
        const Claimed now = history.at(to);
        const double strain = std::max(std::abs(history.path.peak), std::abs(now.driven));
        slack += history.accuracy(to) * strain + 8 * eps * (history.metal.Y0 + history.M() * strain) * strain;
        defect.add(now.elastic_energy - history.metal.energy(now.stress), slack, scale);
        defect.add(total - now.elastic_energy - now.plastic_work, slack, scale);
        defect.add(std::min(0.0, now.plastic_work - before.plastic_work), slack, scale);
    });
    return defect;
}

struct Gate {
    std::string name;
    Defect (*defect)(const History& history);
};
inline const std::vector<Gate> gates{{"strain path", strain_path},
                                     {"integration", integration},
                                     {"consistency", consistency},
                                     {"energy balance", energy_balance}};

inline std::string ringing(const History& history) {
    std::string names;
    for (const auto& [name, defect] : gates) {
        if (!defect(history).holds()) names += name + "; ";
    }
    return names;
}

}  // namespace ordo::oracles::gate::plasticity

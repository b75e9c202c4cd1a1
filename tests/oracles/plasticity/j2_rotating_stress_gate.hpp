#pragma once
// What is true of a von Mises solid whose principal stresses rest while their axes spin: Hooke's law, the flow rule and
// the turning itself, over callables, so that faulty histories can be passed too.
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "oracles/plasticity/j2_rotating_stress.hpp"
#include "tests/oracles/differences.hpp"
#include "tests/oracles/plasticity/j2_integrator.hpp"

namespace ordo::oracles::gate::spinning_axes {

using namespace plasticity;

inline constexpr double eps = std::numeric_limits<double>::epsilon();

/// A claimed history with the data that it was claimed for.
struct Spinning {
    J2RotatingStress solid;
    std::function<Tensor(double t)> strain, stress;

    Metal metal() const { return {solid.K, solid.G, solid.Y0, 0}; }
    double scale() const { return solid.Y0 + std::abs(solid.pressure); }
    double largest_strain(double t) const {
        return solid.Y0 / solid.G + std::abs(solid.pressure) / (3 * solid.K) + 1.5 * solid.plastic_rate * t;
    }
};

inline Spinning spinning(const J2RotatingStress& solid) {
    return {solid, [solid](double t) { return solid.strain(t); }, [solid](double t) { return solid.stress(t); }};
}

inline constexpr std::array times{0.05, 0.31, 0.77, 1.9, 4.1};

inline Tensor rate_of(const std::function<Tensor(double)>& f, double t, double step, double noise, double& error) {
    Tensor rate{};
    for (std::size_t k = 0; k < 9; ++k) {
        const auto derivative = first_derivative([&](double s) { return f(s)[k]; }, t, step, noise);
        rate[k] = derivative.value;
        error = std::max(error, derivative.error);
    }
    return rate;
}

/// strain rate = C^-1 stress rate + plastic_rate 3 s / (2 Y0), by differences: Hooke's law and the flow rule at once.
inline Defect flow_rule(const Spinning& claimed) {
    const auto& solid = claimed.solid;
    const Metal metal = claimed.metal();
    Defect defect;
    for (const double t : times) {
        const double step = 0.06 / (1 + std::abs(solid.spin));
        double strain_error = 0, stress_error = 0;
        const Tensor strain_rate =
            rate_of(claimed.strain, t, step, 8 * eps * claimed.largest_strain(t) * (1 + std::abs(solid.spin) * t),
                    strain_error);
        const Tensor stress_rate =
            rate_of(claimed.stress, t, step, 4 * eps * claimed.scale() * (1 + std::abs(solid.spin) * t), stress_error);
        const Tensor elastic = metal.elastic(strain_rate);
        const Tensor plastic =
            combined(3 * metal.G * solid.plastic_rate / solid.Y0, deviator(claimed.stress(t)), 0, {});
        const Tensor off = combined(1, combined(1, elastic, -1, plastic), -1, stress_rate);
        const double M = metal.K + 4 * metal.G / 3;
        defect.add(std::sqrt(inner(off, off)), 5 * (3 * M * strain_error + stress_error), solid.Y0);
    }
    return defect;
}

/// At t = 0 the elastic strain alone; then q = Y0, the mean stress and the third invariant stay, and the stress is the
/// first one turned.
inline Defect turning(const Spinning& claimed) {
    const auto& solid = claimed.solid;
    const Tensor first = claimed.stress(0);
    const Tensor off = combined(1, claimed.metal().elastic(claimed.strain(0)), -1, first);
    Defect defect;
    defect.add(std::sqrt(inner(off, off)), 16 * eps * claimed.scale(), claimed.scale());
    defect.add(first[8] + solid.pressure - 2.0 / 3 * solid.share * solid.Y0, 8 * eps * claimed.scale(),
               claimed.scale());
    for (const double t : times) {
        const Tensor now = claimed.stress(t);
        const double slack = 16 * eps * claimed.scale() * (1 + std::abs(solid.spin) * t);
        defect.add(trace(now) / 3 + solid.pressure, slack, claimed.scale());
        const double c = std::cos(solid.spin * t), s = std::sin(solid.spin * t);
        const Tensor turned{c * c * first[0] + s * s * first[4],
                            c * s * (first[0] - first[4]),
                            0,
                            c * s * (first[0] - first[4]),
                            s * s * first[0] + c * c * first[4],
                            0,
                            0,
                            0,
                            first[8]};
        const Tensor difference = combined(1, now, -1, turned);
        defect.add(std::sqrt(inner(difference, difference)), slack, claimed.scale());
        defect.add(von_mises(now) - solid.Y0, slack, claimed.scale());
    }
    return defect;
}

inline std::string ringing(const Spinning& claimed) {
    return std::string(flow_rule(claimed).holds() ? "" : "flow rule; ") + (turning(claimed).holds() ? "" : "turning; ");
}

}  // namespace ordo::oracles::gate::spinning_axes

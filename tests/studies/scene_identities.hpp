#pragma once
// What a one-dimensional solid and its truth must agree on: start, ends and balance of momentum.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "studies/engine/scene_entry.hpp"
#include "tests/oracles/fuzz.hpp"

namespace ordo::studies::tests {

using Bar = solvers::SolidScene<1>;

/// A benchmark with its numbers filled in.
struct Bound {
    Bar bar;
    oracles::Exact truth;
};

inline Bound bound(const std::string& name, const Given& given) {
    const auto& entry = scene_named(name, "test");
    const Values values = resolve(entry.parameters, given, "test", name);
    return {std::get<Bar>(entry.problem(values)), entry.truth(values)};
}

inline double at(const solvers::VectorField<1>& field, double X, double t) {
    const solvers::Vec<1> place(X);
    solvers::Vec<1> value(std::numeric_limits<double>::quiet_NaN());
    field({&place, 1}, t, {&value, 1});
    return value[0];
}

/// The same of a load that may be absent, which is none.
inline double at(const std::optional<solvers::VectorField<1>>& field, double X, double t) {
    return field ? at(*field, X, t) : 0;
}

/// One field of the truth at one point; 0 where it has no such field.
inline double exact(const Bound& scene, const std::string& field, double X, double t) {
    std::vector<double> row(scene.truth.width());
    scene.truth.sample({&X, 1}, t, row);
    const auto offset = scene.truth.offset(field);
    return offset ? row[*offset] : 0;
}

/// The nominal stress of a stretch, which is the Cauchy stress where the cross-section keeps its area.
inline double nominal(const solvers::Law& law, double F) {
    const auto stress = [F]<class L>(const L& kind) {
        if constexpr (solvers::ClosedLaw<L, 1>) return kind.template cauchy<1>(solvers::Tensor<1>(F))(0, 0);
        else return std::numeric_limits<double>::quiet_NaN();
    };
    return std::visit(stress, law);
}

/// Largest difference over largest value; 0 where all is zero.
class Relative {
public:
    void add(double found, double expected) {
        const double difference = std::abs(found - expected);
        if (!(difference <= difference_) && !std::isnan(difference_)) difference_ = difference;  // NaN stays
        size_ = std::max({size_, std::abs(found), std::abs(expected)});
    }
    void add_size(double value) { size_ = std::max(size_, std::abs(value)); }
    double value() const { return difference_ == 0 ? 0 : difference_ / size_; }

private:
    double difference_ = 0;
    double size_ = 0;
};

/// Displacement, velocity and F at t = 0 against the truth: the largest of the three relative differences.
inline double start_fault(const Bound& scene) {
    Relative u, v, F;
    for (int i = 0; i <= 32; ++i) {
        const double X = scene.bar.upper[0] * i / 32;
        const auto& deformed = scene.bar.deformed;
        u.add(deformed ? at(deformed->displacement, X, 0) : 0, exact(scene, "displacement", X, 0));
        F.add(deformed ? at(deformed->F, X, 0) : 1, 1 + exact(scene, "strain", X, 0));
        v.add(at(scene.bar.velocity, X, 0), exact(scene, "velocity", X, 0));
    }
    return std::max({u.value(), v.value(), F.value()});
}

/// Velocity of held ends and traction on free ones at the time t against the truth.
inline double end_fault(const Bound& scene, double t) {
    Relative v, P;
    const double L = scene.bar.upper[0];
    for (int i = 0; i <= 32; ++i) {
        v.add_size(exact(scene, "velocity", L * i / 32, t));
        P.add_size(exact(scene, "stress", L * i / 32, t));
    }
    for (const std::size_t side : {0U, 1U}) {
        const double X = side == 0 ? 0 : L;
        const double outward = side == 0 ? -1 : 1;
        const bool held = scene.bar.faces[0][side] != solvers::Face::free;
        if (held) v.add(at(scene.bar.face_velocity, X, t), exact(scene, "velocity", X, t));
        else P.add(at(scene.bar.traction, X, t), outward * exact(scene, "stress", X, t));
        // A held end takes no load.
        if (held) P.add(at(scene.bar.traction, X, t), 0);
    }
    return std::max(v.value(), P.value());
}

/// rho u_tt = dP/dX + rho b at random points and times up to `transits` L / c, with u of the truth by central
/// differences over 3e-4 L and as long as a wave takes for it: what is left over, over the largest term. Their error is
/// that width squared times u'''' / 12 u'', about 1e-7 for waves of length L, and round-off of 1e-8; fronts, where u''
/// jumps, are left out.
inline double balance_fault(const Bound& scene, double transits, unsigned seed) {
    const Bar& bar = scene.bar;
    const double L = bar.upper[0];
    const double c = std::sqrt(solvers::stiffness(bar.law) / bar.rho);
    const double dX = 3e-4 * L;
    const double dt = dX / c;
    const auto u = [&](double X, double t) { return exact(scene, "displacement", X, t); };
    const auto P = [&](double a, double b, double t) { return nominal(bar.law, 1 + (u(b, t) - u(a, t)) / (b - a)); };
    oracles::gate::Random random(seed);
    Relative balance;
    for (int i = 0; i < 300; ++i) {
        const double X = random.uniform(0.01 * L, 0.99 * L);
        const double t = random.uniform(0.01, transits) * L / c;
        const double path = std::fmod(c * t / L, 2.0);
        const double from_base = path < 1 ? path : 2 - path;
        const double nearest = std::min(std::abs(X / L - from_base), std::abs(X / L - (1 - from_base)));
        if (nearest < 2e-3) continue;
        const double inertia = bar.rho * (u(X, t + dt) - 2 * u(X, t) + u(X, t - dt)) / (dt * dt);
        const double force = (P(X, X + dX, t) - P(X - dX, X, t)) / dX;
        const double load = bar.rho * at(bar.body_force, X, t);
        balance.add(inertia, force + load);
        balance.add_size(load);
    }
    return balance.value();
}

}  // namespace ordo::studies::tests

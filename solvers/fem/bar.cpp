// The passes of a step.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "core/text.hpp"
#include "solvers/fem/fem.hpp"

namespace ordo::solvers::fem {
namespace {

/// Local coordinates of the two-point Gauss rule on (0, 1).
constexpr std::array<double, 2> gauss{0.21132486540518712, 0.78867513459481288};  // 1/2 -+ 1/sqrt 12

std::array<bool, 2> held_faces(const SolidScene<1>& scene) {
    return {scene.faces[0][0] != Face::free, scene.faces[0][1] != Face::free};
}

}  // namespace

Bar::Bar(const SolidScene<1>& scene, const Options& options, const Resolution& resolution)
    : h_(resolution.h),
      rho_(scene.rho),
      body_force_lumped_(options.body_force_lumped),
      held_(held_faces(scene)),
      M_(resolution.cells, scene.rho * resolution.h, options.lumped, held_),
      material_(material_of(scene.law, resolution.cells)),
      alpha_(scene.damping.value_or(0)),
      body_force_(scene.body_force),
      traction_(scene.traction),
      face_velocity_(scene.face_velocity),
      ends_{scene.lower, scene.upper},
      u_(resolution.cells + 1),
      v_(u_.size()),
      a_(u_.size()),
      f_(u_.size()),
      F_(resolution.cells),
      P_(F_.size()) {
    for (int i = 0; i <= resolution.cells; ++i) X_.push_back(scene.lower + Vec<1>(i * h_));
    X_.back() = scene.upper;
    if (body_force_ && body_force_lumped_) body_X_ = X_;
    if (body_force_ && !body_force_lumped_) {
        for (int e = 0; e < resolution.cells; ++e) {
            for (const double xi : gauss) body_X_.push_back(scene.lower + Vec<1>((e + xi) * h_));
        }
    }
    body_.resize(body_X_.size());
    start(scene);
}

void Bar::start(const SolidScene<1>& scene) {
    std::vector<Vec<1>> at_nodes(X_.size(), Vec<1>::Zero());
    if (scene.velocity) scene.velocity(X_, 0, at_nodes);
    for (std::size_t i = 0; i < v_.size(); ++i) v_[i] = at_nodes[i][0];
    face_velocities(0);
    if (held_[0]) v_.front() = at_ends_[0][0];
    if (held_[1]) v_.back() = at_ends_[1][0];
    if (scene.deformed) {
        scene.deformed->displacement(X_, 0, at_nodes);
        for (std::size_t i = 0; i < u_.size(); ++i) u_[i] = at_nodes[i][0];
    }
    deform(0);
}

void Bar::gather_forces(double t) {
    std::fill(f_.begin(), f_.end(), 0.0);
    if (body_force_) add_body_force(t);
    if (traction_) add_traction(t);
    external_ = std::accumulate(f_.begin(), f_.end(), 0.0);
    for (std::size_t e = 0; e < P_.size(); ++e) {
        f_[e] += P_[e];
        f_[e + 1] -= P_[e];
    }
}

void Bar::add_body_force(double t) {
    (*body_force_)(body_X_, t, body_);
    if (body_force_lumped_) {
        for (std::size_t i = 0; i < f_.size(); ++i) f_[i] += m()[i] * body_[i][0];
        return;
    }
    const double share = 0.5 * rho_ * h_;
    for (std::size_t e = 0; e < P_.size(); ++e) {
        for (std::size_t k = 0; k < gauss.size(); ++k) {
            const double force = share * body_[2 * e + k][0];
            f_[e] += (1 - gauss[k]) * force;
            f_[e + 1] += gauss[k] * force;
        }
    }
}

void Bar::add_traction(double t) {
    (*traction_)(ends_, t, at_ends_);
    if (!held_[0]) f_.front() += at_ends_[0][0];
    if (!held_[1]) f_.back() += at_ends_[1][0];
}

void Bar::face_velocities(double t) {
    at_ends_ = {Vec<1>::Zero(), Vec<1>::Zero()};
    if (face_velocity_) (*face_velocity_)(ends_, t, at_ends_);
}

void Bar::accelerate(const Step& step) {
    face_velocities(step.velocity_time);
    const auto reach = [&](double v, double target) { return (target - v) / step.kick + 0.5 * alpha_ * (v + target); };
    if (held_[0]) a_.front() = reach(v_.front(), at_ends_[0][0]);
    if (held_[1]) a_.back() = reach(v_.back(), at_ends_[1][0]);
    reactions_ = M_.accelerate(f_, a_);
}

void Bar::kick(double kick) {
    impulse_ += kick * (external_ + reactions_);
    const double half = 0.5 * alpha_ * kick;
    if (half > 0) impulse_ -= half * momentum();
    for (std::size_t i = 0; i < v_.size(); ++i) v_[i] = ((1 - half) * v_[i] + kick * a_[i]) / (1 + half);
    if (half > 0) impulse_ -= half * momentum();
}

void Bar::move(const Step& step) {
    for (std::size_t i = 0; i < u_.size(); ++i) u_[i] += step.dt * v_[i];
    deform(step.t + step.dt);
}

void Bar::deform(double t) {
    for (std::size_t e = 0; e < F_.size(); ++e) {
        F_[e] = 1 + (u_[e + 1] - u_[e]) / h_;
        if (!(F_[e] > 0 && F_[e] <= std::numeric_limits<double>::max())) {
            throw Diverged("element " + std::to_string(e) + " has the stretch F = " + shortest(F_[e]) +
                           " at t = " + shortest(t));
        }
    }
    std::visit([&](auto& kind) { kind.stress(F_, P_); }, material_);
}

double Bar::momentum() const { return std::inner_product(v_.begin(), v_.end(), m().begin(), 0.0); }

}  // namespace ordo::solvers::fem

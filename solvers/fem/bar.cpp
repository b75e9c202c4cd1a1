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

/// A stretch that is positive and finite; false for NaN.
bool is_sound(double F) { return (F > 0) & (F <= std::numeric_limits<double>::max()); }

std::array<bool, 2> held_faces(const SolidScene<1>& scene) {
    return {scene.faces[0][0] != Face::free, scene.faces[0][1] != Face::free};
}

}  // namespace

Bar::Bar(const SolidScene<1>& scene, const Options& options, const Resolution& resolution)
    : h_(resolution.h),
      rho_(scene.rho),
      body_force_lumped_(options.body_force_lumped),
      skip_quiet_(options.skip_quiet && options.lumped && !scene.body_force),
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
    deform(0, {0, F_.size()});
    find_active();
}

void Bar::find_active() {
    const std::size_t last = v_.size() - 1;
    if (!skip_quiet_) {
        active_ = {{0, last + 1}};
        return;
    }
    append(active_, {0, 1});
    for (std::size_t i = 1; i < last; ++i) {
        if (v_[i] != 0 || P_[i] != P_[i - 1]) append(active_, {i, i + 1});
    }
    append(active_, {last, last + 1});
}

void Bar::spread() {
    for (Stretch& s : active_) {
        if (s.from > 0 && P_[s.from - 1] != P_[s.from - 2]) --s.from;
        if (s.to < u_.size() && P_[s.to - 1] != P_[s.to]) ++s.to;
    }
    unite_near(active_);
}

void Bar::gather_forces(double t) {
    const std::array<double, 2> pull = tractions(t);
    external_ = pull[0] + pull[1];
    if (body_force_) return gather_forces_and_body(t, pull);
    for (const Stretch& s : active_) {
        const std::size_t to = std::min(s.to, P_.size());
        for (std::size_t i = std::max(s.from, std::size_t{1}); i < to; ++i) f_[i] = P_[i] - P_[i - 1];
    }
    f_.front() = pull[0] + P_.front();
    f_.back() = pull[1] - P_.back();
}

/// The same with a body force, which acts on all nodes.
void Bar::gather_forces_and_body(double t, const std::array<double, 2>& pull) {
    std::fill(f_.begin(), f_.end(), 0.0);
    add_body_force(t);
    f_.front() += pull[0];
    f_.back() += pull[1];
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

/// On the two ends [N], where they are free.
std::array<double, 2> Bar::tractions(double t) {
    if (!traction_) return {};
    (*traction_)(ends_, t, at_ends_);
    return {held_[0] ? 0 : at_ends_[0][0], held_[1] ? 0 : at_ends_[1][0]};
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
    reactions_ = M_.accelerate(f_, a_, active_);
}

void Bar::kick(double kick) {
    impulse_ += kick * (external_ + reactions_);
    if (alpha_ > 0) return kick_damped(kick);
    for (const Stretch& s : active_) {
        for (std::size_t i = s.from; i < s.to; ++i) v_[i] += kick * a_[i];
    }
}

void Bar::kick_damped(double kick) {
    const double half = 0.5 * alpha_ * kick;
    impulse_ -= half * momentum();
    for (const Stretch& s : active_) {
        for (std::size_t i = s.from; i < s.to; ++i) v_[i] = ((1 - half) * v_[i] + kick * a_[i]) / (1 + half);
    }
    impulse_ -= half * momentum();
}

void Bar::move(const Step& step) {
    for (const Stretch& s : active_) {
        for (std::size_t i = s.from; i < s.to; ++i) u_[i] += step.dt * v_[i];
        deform(step.t + step.dt, {std::max(s.from, std::size_t{1}) - 1, std::min(s.to, F_.size())});
    }
    spread();
}

void Bar::deform(double t, Stretch elements) {
    bool sound = true;
    for (std::size_t e = elements.from; e < elements.to; ++e) {
        F_[e] = 1 + (u_[e + 1] - u_[e]) / h_;
        sound &= is_sound(F_[e]);
    }
    if (!sound) refuse(t, elements);
    std::visit([&](auto& kind) { kind.stress(F_, P_, elements); }, material_);
}

/// Throws Diverged with the first element that is turned inside out.
void Bar::refuse(double t, Stretch elements) const {
    std::size_t e = elements.from;
    while (is_sound(F_[e])) ++e;
    throw Diverged("element " + std::to_string(e) + " has the stretch F = " + shortest(F_[e]) +
                   " at t = " + shortest(t));
}

double Bar::momentum() const {
    double sum = 0;
    for (const Stretch& s : active_) {
        for (std::size_t i = s.from; i < s.to; ++i) sum += v_[i] * m()[i];
    }
    return sum;
}

}  // namespace ordo::solvers::fem

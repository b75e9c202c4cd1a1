// A step and its passes up to the kick. What a run has chosen is asked between passes, or is one branch of a loop that
// never turns; there is no call through a pointer, no allocation and no string in a loop. Read mpm.hpp first.
#include <algorithm>
#include <string>

#include "core/text.hpp"
#include "solvers/mpm/basis/basis.hpp"
#include "solvers/mpm/mpm.hpp"
#include "solvers/mpm/particle_update.hpp"
#include "solvers/mpm/transfer.hpp"

namespace ordo::solvers::mpm {

template <int dim>
Mpm<dim>::Mpm(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution, bool with_F)
    : options_(options),
      law_(scene.law),
      body_force_(options.body_force == BodyForce::left_out ? std::nullopt : scene.body_force),
      face_velocity_(scene.face_velocity),
      damping_(scene.damping),
      grid_(scene, options, resolution),
      p_(seeded<dim>(scene, options, resolution, with_F)),
      boundary_(scene, options, resolution, p_),
      mass_(options),
      corner_cell_(p_.corners.size(), Cell<dim>::Constant(nowhere)) {
    if (options.composed()) composition_ = options.time == Time::yoshida6 ? yoshida6() : yoshida4();
    if (options.reconstruction != Reconstruction::none) rebuilt_.emplace(options);
    for (const Held& held : grid_.held) held_X_.push_back(grid_.position(held.node));
    held_v_.resize(held_X_.size());
}

template <int dim>
void Mpm<dim>::step(double t, double velocity_dt, double dt) {
    const StressUpdate order = options_.stress_update;
    const double velocity_time = t + (options_.leaps() ? dt / 2 : dt);  // of the kicked velocity
    meet_grid(t);
    if (maps_before_kick()) map_velocity(velocity_time - velocity_dt);
    if (order == StressUpdate::usf) update_stress(dt);
    if (order == StressUpdate::usavg) update_stress(dt / 2);
    kick(t, velocity_dt, velocity_time);
    if (!options_.separable()) move(dt);
    if (order == StressUpdate::musl) map_velocity(velocity_time);
    if (options_.separable()) move(dt);
    if (order == StressUpdate::usl || order == StressUpdate::musl) update_stress(dt);
    if (order == StressUpdate::usavg) update_stress(dt / 2);
}

template <int dim>
void Mpm<dim>::composed_step(double t, double dt) {
    const auto& [drifts, kicks] = composition_;
    double velocity_time = t;
    for (std::size_t stage = 0;; ++stage) {
        meet_grid(t);
        map_velocity(t + drifts[stage] * dt / 2);  // faces move by their velocity amid the drift
        if (stage == 0 && options_.transfer == Transfer::blend)
            keep_momentum([&] { mix_in_grid_velocity(1 - options_.flip_share); });
        move(drifts[stage] * dt);
        update_stress(drifts[stage] * dt);
        if (stage == kicks.size()) return;
        t += drifts[stage] * dt;
        meet_grid(t);
        if (face_velocity_) map_velocity(velocity_time);
        velocity_time += kicks[stage] * dt;
        kick(t, kicks[stage] * dt, velocity_time);
    }
}

template <int dim>
void Mpm<dim>::synchronise(double t, double dt) {
    meet_grid(t);
    if (maps_before_kick()) map_velocity(t - dt);
    kick(t, dt, t);
}

template <int dim>
bool Mpm<dim>::maps_before_kick() const {
    return !options_.separable() || takes_mapped_velocity() || face_velocity_;
}

template <int dim>
const Points<dim>& Mpm<dim>::points() const {
    if constexpr (dim == 1) {
        if (rebuilt_) return rebuilt_->points;
    }
    return p_;
}

template <int dim>
const Stencils<dim>& Mpm<dim>::point_stencils() const {
    if constexpr (dim == 1) {
        if (rebuilt_) return rebuilt_->stencils;
    }
    return stencils_;
}

template <int dim>
void Mpm<dim>::meet_grid(double t) {
    if (!stale_) return;
    stale_ = false;
    if constexpr (dim == 1) {
        if (options_.beyond_grid == BeyondGrid::follow) grid_.fit(boundary_.x[0][0], boundary_.x[1][0]);
    }
    const auto [found, crossed, on_face] = fill<dim>(grid_, options_, p_, stencils_);
    if (found < p_.size()) throw Diverged("particle " + std::to_string(found) + " left the grid at t = " + shortest(t));
    crossings_ += crossed;
    on_face_ = on_face;
    if (options_.transfer == Transfer::mls) replace_gradients();
    boundary_.meet_grid(grid_, options_.frame == Frame::total, stencils_);
    if constexpr (dim == 1) {
        if (rebuilt_) rebuilt_->place(grid_, p_);
    }
    scatter_mass<dim>(point_stencils(), points().m, grid_.m);
    if (std::ranges::any_of(grid_.m, [](double m) { return m < 0; }))
        throw Diverged("a node has negative mass: too much of the body lies where functions are extrapolated");
    mass_.assemble(grid_, point_stencils(), points().m);
}

template <int dim>
void Mpm<dim>::map_velocity(double velocity_time) {
    const auto held = held_velocity(velocity_time);
    if constexpr (dim == 1) {
        if (rebuilt_) rebuilt_->sample_velocity(p_);
        if (rebuilt_ && rebuilt_->knows_node_velocities()) {
            grid_.v = rebuilt_->node_v;
            for (const auto& [node, axis] : grid_.held) grid_.v[static_cast<std::size_t>(node)][axis] = 0;
            return;
        }
    }
    std::fill(grid_.v.begin(), grid_.v.end(), Vec<dim>::Zero());
    scatter<dim>(point_stencils(), points().m, points().v, grid_.v);
    if (options_.affine()) scatter_affine<dim>(grid_, stencils_, places(), p_.m, p_.L, grid_.v);
    if (!takes_mapped_velocity()) return mass_.solve(grid_, grid_.v, held);
    f_ = grid_.v;
    mass_.solve(grid_, grid_.v, held);
    const auto* mapped = &grid_.v;
    if (options_.transfer == Transfer::xpic) {
        series_v_ = f_;
        mass_.solve_by_series(grid_, series_v_, held);
        mapped = &series_v_;
    }
    wall_.setZero();
    for (const auto& [node, axis] : grid_.held) wall_[axis] += mass_.reaction(grid_, node, axis, *mapped, f_);
}

template <int dim>
void Mpm<dim>::kick(double t, double dt, double velocity_time) {
    keep_momentum([&] {
        gather_forces(t);
        hold_and_solve(dt, velocity_time);
        if (maps_before_kick()) {
            for (std::size_t i = 0; i < grid_.v.size(); ++i) grid_.v[i] += dt * grid_.a[i];
        }
        update_velocity(dt);
    });
}

template <int dim>
void Mpm<dim>::gather_forces(double t) {
    std::fill(grid_.a.begin(), grid_.a.end(), Vec<dim>::Zero());
    load_.setZero();
    gather_body_force(t);
    const auto& from = points();
    if (options_.frame == Frame::total) {
        const auto nominal = [&](std::size_t p) -> Tensor<dim> {
            return p_.F[p].determinant() * p_.sigma[p] * p_.F[p].inverse().transpose();
        };
        scatter_stress<dim>(point_stencils(), from.volume, nominal, grid_.a);
    } else {
        const auto cauchy = [&](std::size_t p) -> const Tensor<dim>& { return from.sigma[p]; };
        scatter_stress<dim>(point_stencils(), from.volume, cauchy, grid_.a);
    }
    load_ += boundary_.pull(t, grid_, grid_.a);
}

/// Body force and damping, at the particles, at the points that stand for them or at the nodes.
template <int dim>
void Mpm<dim>::gather_body_force(double t) {
    const auto add = [&](const Stencils<dim>& stencils, std::span<const double> m, std::span<const Vec<dim>> b) {
        for (std::size_t p = 0; p < b.size(); ++p) load_ += m[p] * b[p];
        scatter<dim>(stencils, m, b, grid_.a);
    };
    const bool at_nodes = body_force_ && options_.body_force == BodyForce::nodes;
    if (at_nodes) {
        node_x_.clear();
        for (int i = 0; i < grid_.nodes(); ++i) node_x_.push_back(grid_.position(i));
        b_.assign(node_x_.size(), Vec<dim>::Zero());
        (*body_force_)(node_x_, t, b_);
        for (std::size_t i = 0; i < b_.size(); ++i) {
            grid_.a[i] += grid_.m[i] * b_[i];
            load_ += grid_.m[i] * b_[i];
        }
    }
    const bool any = (body_force_ && !at_nodes) || damping_;
    b_.assign(any ? p_.size() : 0, Vec<dim>::Zero());
    if (body_force_ && !at_nodes) (*body_force_)(p_.X, t, b_);
    if (damping_) {
        for (std::size_t p = 0; p < p_.size(); ++p) b_[p] -= *damping_ * p_.v[p];
    }
    if constexpr (dim == 1) {
        if (rebuilt_) rebuilt_->sample_forces(p_, b_);
        if (rebuilt_ && !rebuilt_->b.empty()) return add(rebuilt_->stencils, rebuilt_->points.m, rebuilt_->b);
    }
    if (any) add(stencils_, p_.m, b_);
}

/// Forces become accelerations; what held faces and loads give in the kick is added to the impulse.
template <int dim>
void Mpm<dim>::hold_and_solve(double dt, double velocity_time) {
    f_ = grid_.a;
    std::span<const double> held;
    if (face_velocity_) {
        held_velocity(velocity_time);
        for (std::size_t k = 0; k < grid_.held.size(); ++k) {
            const auto& [node, axis] = grid_.held[k];
            held_values_[k] = (held_values_[k] - grid_.v[static_cast<std::size_t>(node)][axis]) / dt;
        }
        held = held_values_;
    }
    mass_.solve(grid_, grid_.a, held);
    for (const auto& [node, axis] : grid_.held) impulse_[axis] += dt * mass_.reaction(grid_, node, axis, grid_.a, f_);
    impulse_ += dt * load_;
}

/// What the held nodes must move at; empty where all are at rest.
template <int dim>
std::span<const double> Mpm<dim>::held_velocity(double t) {
    if (!face_velocity_) return {};
    (*face_velocity_)(held_X_, t, held_v_);
    held_values_.clear();
    for (std::size_t k = 0; k < held_v_.size(); ++k) held_values_.push_back(held_v_[k][grid_.held[k].axis]);
    return held_values_;
}

template class Mpm<1>;
template class Mpm<2>;
template class Mpm<3>;

}  // namespace ordo::solvers::mpm

#pragma once
// The passes of a step. A switch stands between passes, never inside a loop. Read mpm.hpp first.
#include <Eigen/LU>
#include <algorithm>
#include <string>

#include "core/text.hpp"
#include "solvers/mpm/mpm.hpp"

namespace ordo::solvers::mpm {

template <int dim, class Basis>
void Mpm<dim, Basis>::particles_to_grid(double t) {
    locate(t);
    std::fill(grid_.m.begin(), grid_.m.end(), 0.0);
    std::fill(grid_.v.begin(), grid_.v.end(), Vec<dim>::Zero());
    std::fill(grid_.a.begin(), grid_.a.end(), Vec<dim>::Zero());
    const bool mapped_velocity = !moved_by_remapped();
    with_constant(mapped_velocity, [&](auto momentum) {
        with_constant(!stress_first(), [&](auto force) { scatter<true, momentum, force>(); });
    });
    if (body_force_) scatter_body_force(t);
    if (mapped_velocity) divide_by_mass();
}

template <int dim, class Basis>
void Mpm<dim, Basis>::move_grid(double kick) {
    if (stress_first()) scatter<false, false, true>();
    for (const Held& held : grid_.held) {
        double& force = grid_.a[held.node][held.axis];
        impulse_[held.axis] -= kick * force;
        force = 0;
    }
    impulse_ += kick * load_;
    for (std::size_t i = 0; i < grid_.m.size(); ++i) {
        if (grid_.m[i] > 0) grid_.a[i] /= grid_.m[i];
        else grid_.a[i].setZero();
        grid_.v[i] += kick * grid_.a[i];
    }
}

template <int dim, class Basis>
void Mpm<dim, Basis>::grid_to_particles(double kick, double dt) {
    kick_particles(kick);
    const bool remap = options_.stress_update == StressUpdate::musl;
    if (!moved_by_remapped()) move_particles(dt);
    if (remap) {
        std::fill(grid_.v.begin(), grid_.v.end(), Vec<dim>::Zero());
        scatter<false, true, false>();
        divide_by_mass();
    }
    if (moved_by_remapped()) move_particles(dt);
}

template <int dim, class Basis>
void Mpm<dim, Basis>::update_stress(double dt) {
    const auto pass = [&](const auto& law, auto moved_mesh, auto volume_updated) {
        for (std::size_t p = 0; p < p_.size(); ++p) {
            Tensor<dim> dL = Tensor<dim>::Zero();
            nodes_of(p, [&](int i, double, const Vec<dim>& grad_w) { dL += dt * grid_.v[i] * grad_w.transpose(); });
            if (!p_.F.empty()) p_.F[p] += dL * p_.F[p];
            if constexpr (moved_mesh) dL = Tensor<dim>(dL * (Tensor<dim>::Identity() + dL).inverse());
            p_.sigma[p] = law.template updated<dim>(p_.sigma[p], dL);
            if constexpr (volume_updated) p_.volume[p] *= 1 + dL.trace();
        }
    };
    std::visit(
        [&](const auto& law) {
            with_constant(options_.strain_from_moved_mesh, [&](auto moved_mesh) {
                with_constant(options_.volume_updated, [&](auto updated) { pass(law, moved_mesh, updated); });
            });
        },
        law_);
}

template <int dim, class Basis>
void Mpm<dim, Basis>::locate(double t) {
    for (std::size_t p = 0; p < p_.size(); ++p) {
        int base = 0;
        if (!grid_.locate(p_.x[p], base, p_.xi[p])) {
            throw Diverged("particle " + std::to_string(p) + " left the grid at t = " + shortest(t));
        }
        crossings_ += base != p_.base[p] && p_.base[p] >= 0;
        p_.base[p] = base;
    }
}

template <int dim, class Basis>
template <bool mass, bool momentum, bool force>
void Mpm<dim, Basis>::scatter() {
    for (std::size_t p = 0; p < p_.size(); ++p) {
        const Vec<dim> momentum_p = p_.m[p] * p_.v[p];
        const Tensor<dim> pull = p_.volume[p] * p_.sigma[p];
        nodes_of(p, [&](int i, double w, const Vec<dim>& grad_w) {
            if constexpr (mass) grid_.m[i] += w * p_.m[p];
            if constexpr (momentum) grid_.v[i] += w * momentum_p;
            if constexpr (force) grid_.a[i] -= pull * grad_w;
        });
    }
}

template <int dim, class Basis>
void Mpm<dim, Basis>::scatter_body_force(double t) {
    (*body_force_)(p_.X, t, b_);
    load_.setZero();
    for (std::size_t p = 0; p < p_.size(); ++p) {
        const Vec<dim> force = p_.m[p] * b_[p];
        load_ += force;
        nodes_of(p, [&](int i, double w, const Vec<dim>&) { grid_.a[i] += w * force; });
    }
}

/// Gathered momentum becomes velocity; zero where there is no mass or where a face holds the node.
template <int dim, class Basis>
void Mpm<dim, Basis>::divide_by_mass() {
    for (std::size_t i = 0; i < grid_.m.size(); ++i) {
        if (grid_.m[i] > 0) grid_.v[i] /= grid_.m[i];
        else grid_.v[i].setZero();
    }
    for (const Held& held : grid_.held) grid_.v[held.node][held.axis] = 0;
}

template <int dim, class Basis>
void Mpm<dim, Basis>::kick_particles(double kick) {
    for (std::size_t p = 0; p < p_.size(); ++p) {
        Vec<dim> a = Vec<dim>::Zero();
        nodes_of(p, [&](int i, double w, const Vec<dim>&) { a += w * grid_.a[i]; });
        p_.v[p] += kick * a;
    }
}

template <int dim, class Basis>
void Mpm<dim, Basis>::move_particles(double dt) {
    for (std::size_t p = 0; p < p_.size(); ++p) {
        Vec<dim> v = Vec<dim>::Zero();
        nodes_of(p, [&](int i, double w, const Vec<dim>&) { v += w * grid_.v[i]; });
        p_.x[p] += dt * v;
    }
}

}  // namespace ordo::solvers::mpm

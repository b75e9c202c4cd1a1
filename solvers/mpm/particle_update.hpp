#pragma once
// The passes of a step from the grid back to the particles. Included by step.cpp alone.
#include <Eigen/LU>

#include "core/text.hpp"
#include "solvers/mpm/basis/basis.hpp"
#include "solvers/mpm/mpm.hpp"
#include "solvers/mpm/transfer.hpp"

namespace ordo::solvers::mpm {

template <int dim>
void Mpm<dim>::update_velocity(double dt) {
    const Transfer transfer = options_.transfer;
    const auto accelerated = [&] {
        for (std::size_t p = 0; p < p_.size(); ++p) p_.v[p] += dt * value_at<dim>(stencils_, p, grid_.a);
    };
    switch (transfer) {
        case Transfer::flip: return accelerated();
        case Transfer::blend:
            accelerated();
            // In a composition the share is one of the whole step.
            if (!options_.composed()) mix_in_grid_velocity(1 - options_.flip_share);
            return;
        case Transfer::xpic:
            mover_.resize(p_.size());
            for (std::size_t p = 0; p < p_.size(); ++p) {
                const Vec<dim> gain = dt * value_at<dim>(stencils_, p, grid_.a);
                const Vec<dim> v = value_at<dim>(stencils_, p, series_v_) + gain;
                mover_[p] = value_at<dim>(stencils_, p, grid_.v) - gain + 0.5 * (v - p_.v[p]);
                p_.v[p] = v;
            }
            impulse_ += wall_;
            return;
        case Transfer::fmpm:
            mover_ = p_.v;
            mix_in_grid_velocity(1);
            for (std::size_t p = 0; p < p_.size(); ++p) mover_[p] = 0.5 * (mover_[p] + p_.v[p]);
            return;
        default: mix_in_grid_velocity(1);
    }
    if (options_.affine()) update_affine();
}

/// Velocities of the grid take the place of a share of the particles' own.
template <int dim>
void Mpm<dim>::mix_in_grid_velocity(double share) {
    for (std::size_t p = 0; p < p_.size(); ++p)
        p_.v[p] = (1 - share) * p_.v[p] + share * value_at<dim>(stencils_, p, grid_.v);
    impulse_ += share * wall_;
}

/// The affine velocity field of each particle: from the functions (APIC, MLS-MPM) or from their gradients (TPIC).
template <int dim>
void Mpm<dim>::update_affine() {
    if (options_.transfer == Transfer::tpic) {
        for (std::size_t p = 0; p < p_.size(); ++p) p_.L[p] = gradient_at<dim>(stencils_, p, grid_.v);
        return;
    }
    const auto x = places();
    for (std::size_t p = 0; p < p_.size(); ++p) {
        Tensor<dim> B = Tensor<dim>::Zero();
        stencils_.row(p, [&](int i, double w, const Vec<dim>&) {
            B += w * grid_.v[static_cast<std::size_t>(i)] * (grid_.position(i) - x[p]).transpose();
        });
        p_.L[p] = B * spread_at<dim>(grid_, stencils_, p, x[p]).inverse();
    }
}

/// MLS-MPM: grad S_ip becomes S_ip D_p^-1 (x_i - x_p).
template <int dim>
void Mpm<dim>::replace_gradients() {
    const auto x = places();
    for (std::size_t p = 0; p < p_.size(); ++p) {
        const Tensor<dim> inverse = spread_at<dim>(grid_, stencils_, p, x[p]).inverse();
        stencils_.row(p,
                      [&](int i, double w, Vec<dim>& grad_w) { grad_w = w * (inverse * (grid_.position(i) - x[p])); });
    }
}

/// What `change` has added to the momentum beyond the impulse is taken from all particles alike, where that is wanted.
template <int dim>
template <class Change>
void Mpm<dim>::keep_momentum(Change&& change) {
    if (!options_.conservative) return change();
    const Vec<dim> before = momentum() - impulse_;
    change();
    double mass = 0;
    for (const double m : p_.m) mass += m;
    const Vec<dim> excess = (momentum() - impulse_ - before) / mass;
    for (auto& v : p_.v) v -= excess;
}

template <int dim>
Vec<dim> Mpm<dim>::momentum() const {
    Vec<dim> sum = Vec<dim>::Zero();
    for (std::size_t p = 0; p < p_.size(); ++p) sum += p_.m[p] * p_.v[p];
    return sum;
}

template <int dim>
double Mpm<dim>::mass_on_grid() const {
    double sum = 0;
    for (const double m : grid_.m) sum += m;
    return sum;
}

template <int dim>
void Mpm<dim>::move(double dt) {
    const bool by_grid = options_.transfer != Transfer::fmpm && options_.transfer != Transfer::xpic;
    Vec<dim> sum = Vec<dim>::Zero();
    for (std::size_t p = 0; p < p_.size(); ++p) {
        p_.x[p] += dt * (by_grid ? value_at<dim>(stencils_, p, grid_.v) : mover_[p]);
        sum += p_.x[p];
    }
    if (!p_.corners.empty() && options_.frame == Frame::updated) {
        const std::span<const Vec<dim>> at = p_.corners;
        if (fill_at_points<dim>(grid_, at, corner_cell_, corner_stencils_).rows != at.size())
            throw Diverged("a corner of a particle left the grid");
        for (std::size_t c = 0; c < at.size(); ++c) {
            p_.corners[c] += dt * value_at<dim>(corner_stencils_, c, grid_.v);
            sum += p_.corners[c];
        }
    }
    if (!sum.allFinite()) throw Diverged("the positions of the particles are not finite");
    boundary_.move(dt, grid_);
    stale_ = options_.frame == Frame::updated;
}

/// F_p and V_p by the grid's velocity, then stress(p, dL) with dL the gradient of the displacement increment.
template <int dim>
template <class Stress>
void Mpm<dim>::strain_particles(double dt, Stress&& stress) {
    const bool total = options_.frame == Frame::total;
    const Tensor<dim> I = Tensor<dim>::Identity();
    for (std::size_t p = 0; p < p_.size(); ++p) {
        Tensor<dim> dL = dt * gradient_at<dim>(stencils_, p, grid_.v);
        if (total) {
            const Tensor<dim> before = p_.F[p];
            p_.F[p] += dL;
            dL = Tensor<dim>(dL * before.inverse());
        } else if (!p_.F.empty()) {
            p_.F[p] += dL * p_.F[p];
        }
        const double growth = (I + dL).determinant();
        if (!(growth > 0)) throw Diverged("particle " + std::to_string(p) + " is turned inside out");
        const bool moved = options_.strain_mesh == StrainMesh::moved;
        if (moved) dL = Tensor<dim>(dL * (I + dL).inverse());
        if (options_.strain_mesh == StrainMesh::midpoint) dL = Tensor<dim>(dL * (I + 0.5 * dL).inverse());
        stress(p, dL);
        if (options_.volume_updated && !total) p_.volume[p] *= moved ? 1 + dL.trace() : growth;
    }
}

/// A particle on a face touches nodes with no weight but a gradient. Where such a node has no mass, its velocity is
/// that of the particles that touch it, so that none of them sees a jump.
template <int dim>
void Mpm<dim>::lend_velocity() {
    const auto massless = [&](int i) { return !(grid_.m[static_cast<std::size_t>(i)] > 0); };
    touched_.assign(grid_.m.size(), 0);
    for (std::size_t p = 0; p < p_.size(); ++p) {
        stencils_.row(p, [&](int i, double, const Vec<dim>&) {
            if (!massless(i)) return;
            const auto node = static_cast<std::size_t>(i);
            if (touched_[node] == 0) grid_.v[node].setZero();
            grid_.v[node] += p_.v[p];
            ++touched_[node];
        });
    }
    for (std::size_t i = 0; i < touched_.size(); ++i) {
        if (touched_[i] > 0) grid_.v[i] /= touched_[i];
    }
    for (std::size_t k = 0; k < grid_.held.size(); ++k) {
        const auto& [node, axis] = grid_.held[k];
        if (massless(node)) grid_.v[static_cast<std::size_t>(node)][axis] = 0;
    }
}

template <int dim>
void Mpm<dim>::update_stress(double dt) {
    if (on_face_) lend_velocity();
    const auto by_F = [&](const auto& law) {
        strain_particles(dt,
                         [&](std::size_t p, const Tensor<dim>&) { p_.sigma[p] = law.template cauchy<dim>(p_.F[p]); });
    };
    const auto by_increments = [&](const auto& law) {
        strain_particles(dt, [&](std::size_t p, const Tensor<dim>& dL) {
            p_.sigma[p] = law.template updated<dim>(p_.sigma[p], dL);
        });
    };
    std::visit(
        [&]<class L>(const L& law) {
            if constexpr (HistoryLaw<L, dim>) {
                strain_particles(dt, [&](std::size_t p, const Tensor<dim>& dL) {
                    p_.sigma[p] = law.template updated<dim>(p_.history[p], dL);
                });
            } else if constexpr (!IncrementLaw<L, dim>) {
                by_F(law);
            } else if constexpr (!ClosedLaw<L, dim>) {
                by_increments(law);
            } else if (options_.stress_from_F) {
                by_F(law);
            } else {
                by_increments(law);
            }
        },
        law_);
}

}  // namespace ordo::solvers::mpm

#pragma once
// Finite elements for a bar: read `step` first. The peer that particle methods are measured against.
#include <optional>
#include <vector>

#include "solvers/fem/mass.hpp"
#include "solvers/fem/material.hpp"
#include "solvers/fem/options.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::fem {

/// The solver "fem" of the registry.
Solver solver();

/// Times of a step [s]. It leads the positions from t to t + dt, and the velocity, over `kick`, to `velocity_time`.
struct Step {
    double t;
    double dt;
    double kick;
    double velocity_time;
};

/// Linear elements, total Lagrangian: all integrals are over the undeformed bar, and F is constant in an element.
///
///   F_e = 1 + (u_(e+1) - u_e)/h      f_i = P_(i-1) - P_i + int N_i rho b dX + traction at free ends
///   M a = f + reactions              v += kick (a - alpha (v_old + v_new)/2)      u += dt v
///
/// Held ends follow face_velocity at the velocity's time, from t = 0 on, whatever the scene's initial velocity there.
/// Loads are taken at the start of a step. A deformed start is interpolated from its displacement at the nodes.
/// Nodes at rest between two equal stresses stay there and are not touched, with lumped mass and without body force.
/// They join where the stress beside them changes: a node a step at most, and only where F differs from 1 by more than
/// round-off, so that no wave runs ahead in numbers too small to matter.
/// source   [Hughes2000]
class Bar {
public:
    /// Throws Diverged where a deformed start turns an element inside out.
    Bar(const SolidScene<1>& scene, const Options& options, const Resolution& resolution);

    void step(const Step& step) {
        synchronise(step);
        move(step);
    }

    /// The velocity's part of a step only: brings a leapfrog's velocity to the time of the positions.
    void synchronise(const Step& step) {
        gather_forces(step.t);
        accelerate(step);
        kick(step.kick);
    }

    std::span<const Vec<1>> X() const { return X_; }             ///< of the nodes [m]
    std::span<const double> u() const { return u_; }             ///< nodes [m]
    std::span<const double> v() const { return v_; }             ///< nodes [m/s]
    std::span<const double> F() const { return F_; }             ///< elements [-]
    std::span<const double> P() const { return P_; }             ///< elements [Pa]
    std::span<const double> m() const { return M_.row_sums(); }  ///< nodes [kg]
    double mass() const { return M_.total(); }                   ///< [kg]
    double h() const { return h_; }                              ///< undeformed width of an element [m]
    double momentum() const;                                     ///< sum of M v [kg m/s]
    std::size_t active() const { return total(active_); }        ///< nodes that the next step will touch
    double impulse() const { return impulse_; }  ///< of reactions, tractions, body force and damping so far [kg m/s]

private:
    void start(const SolidScene<1>& scene);
    void gather_forces(double t);       // f_, and external_ their sum: P has none
    void accelerate(const Step& step);  // a_ = dv/kick + alpha (v_old + v_new)/2, also at held ends
    void kick(double kick);             // v_
    void kick_damped(double kick);
    void move(const Step& step);              // u_, F_, P_
    void deform(double t, Stretch elements);  // F_, P_
    [[noreturn]] void refuse(double t, Stretch elements) const;
    void find_active();
    void spread();  // active_ after P_ has changed
    void gather_forces_and_body(double t, const std::array<double, 2>& pull);
    void add_body_force(double t);
    std::array<double, 2> tractions(double t);
    void face_velocities(double t);

    double h_;
    double rho_;
    bool body_force_lumped_;
    bool skip_quiet_;
    std::array<bool, 2> held_;
    Mass M_;
    Material material_;
    double alpha_;
    std::optional<VectorField<1>> body_force_, traction_, face_velocity_;
    std::array<Vec<1>, 2> ends_;     ///< [m]
    std::array<Vec<1>, 2> at_ends_;  ///< a field at both
    std::vector<Vec<1>> X_;
    std::vector<Vec<1>> body_X_, body_;  ///< where the body force is taken, and it; empty where the scene has none
    std::vector<double> u_, v_, a_, f_, F_, P_;
    std::vector<Stretch> active_;  ///< nodes that a step may change, both ends always among them
    double external_ = 0;          ///< sum of body force and tractions now [N]
    double reactions_ = 0;         ///< their sum now [N]
    double impulse_ = 0;
};

}  // namespace ordo::solvers::fem

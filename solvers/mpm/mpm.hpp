#pragma once
// The Material Point Method: read `step` first. One source for 1, 2 and 3 dimensions.
#include <optional>
#include <vector>

#include "solvers/mpm/basis/stencil.hpp"
#include "solvers/mpm/boundary.hpp"
#include "solvers/mpm/composition.hpp"
#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/mass_matrix.hpp"
#include "solvers/mpm/particles.hpp"
#include "solvers/mpm/reconstruction/reconstruction.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::mpm {

/// The solver "mpm" of the registry.
Solver solver();

/// Particles carry mass, velocity and stress through a grid that is reset in every step.
///
///   m_i = sum S_ip m_p          f_i = - sum V_p sigma_p grad S_ip + sum S_ip m_p b_p + traction      M a = f
///   v_p += kick sum S_ip a_i    x_p += dt sum S_ip v_i     d eps = dt sym sum v_i (x) grad S_ip
///
/// S_ip and its gradient are those of the positions at the start of the step (updated frame), or of the undeformed
/// positions once for all, with nominal stress and undeformed volume (total frame).
/// source   [Sulsky1994], [Sulsky1995]; order of the passes [Bardenhagen2002]; letters as there
template <int dim>
class Mpm {
public:
    Mpm(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution, bool with_F);

    /// From t to t + dt. `kick` is the velocity's share of it: dt, or less in the first step of a leapfrog.
    void step(double t, double kick, double dt);

    /// The same by a composition of drifts and kicks, of order 4 or 6.
    void composed_step(double t, double dt);

    /// Velocities of a leapfrog live at half steps: brings them on by `kick` to the time of the positions.
    void synchronise(double t, double kick);

    /// S_ip, m_i and M of the positions now. Throws Diverged where a particle or a face has left the grid.
    void meet_grid(double t);

    const Particles<dim>& particles() const { return p_; }
    Particles<dim>& particles() { return p_; }
    const Grid<dim>& grid() const { return grid_; }
    long crossings() const { return crossings_; }         ///< times a particle was found in a new cell
    Vec<dim> momentum() const;                            ///< of the particles [kg m/s]
    double mass_on_grid() const;                          ///< gathered by the nodes [kg]
    const Vec<dim>& impulse() const { return impulse_; }  ///< of held faces and loads so far [kg m/s]

private:
    // the passes, in step.cpp
    void map_velocity(double velocity_time);  // v_i = M^-1 sum S m v
    /// f_i and a_i at time t; v_i += dt a_i; v_p, by the transfer chosen. The velocity is then that of velocity_time.
    void kick(double t, double dt, double velocity_time);
    void gather_forces(double t);
    void gather_body_force(double t);
    void hold_and_solve(double dt, double velocity_time);
    std::span<const double> held_velocity(double t);
    bool maps_before_kick() const;
    bool takes_mapped_velocity() const { return options_.transfer != Transfer::flip; }
    const Points<dim>& points() const;
    const Stencils<dim>& point_stencils() const;

    // back to the particles, in particle_update.hpp
    void update_velocity(double kick);
    void mix_in_grid_velocity(double share);
    void update_affine();
    void replace_gradients();
    void move(double dt);           // x_p
    void lend_velocity();           // to nodes without mass
    void update_stress(double dt);  // d eps, F_p, sigma_p, V_p
    template <class Stress>
    void strain_particles(double dt, Stress&& stress);
    template <class Change>
    void keep_momentum(Change&& change);
    /// Where stencils are taken.
    std::span<const Vec<dim>> places() const { return options_.frame == Frame::total ? p_.X : p_.x; }

    Options options_;
    Law law_;
    std::optional<VectorField<dim>> body_force_;
    std::optional<VectorField<dim>> face_velocity_;
    std::optional<double> damping_;
    Composition composition_;  ///< of drifts and kicks; empty where a step is none
    Grid<dim> grid_;
    Particles<dim> p_;
    Boundary<dim> boundary_;
    MassMatrix<dim> mass_;
    std::optional<Reconstruction1D> rebuilt_;  ///< what stands for the particles on their way to the grid
    Stencils<dim> stencils_;                   ///< of the particles
    Stencils<dim> corner_stencils_;            ///< of the corners that the grid moves one by one
    std::vector<Cell<dim>> corner_cell_;
    bool on_face_ = false;            ///< a particle stands on a face, where a node may be touched without weight
    bool stale_ = true;               ///< particles have moved since the stencils were filled
    std::vector<Vec<dim>> b_;         ///< force per unit mass, at the particles or the nodes
    std::vector<Vec<dim>> mover_;     ///< velocities that move the particles where the nodes' do not
    std::vector<Vec<dim>> series_v_;  ///< of the nodes, by the series of XPIC, before the kick
    std::vector<Vec<dim>> f_;         ///< right-hand side of the last solve
    std::vector<Vec<dim>> node_x_, held_X_;  ///< [m]
    std::vector<Vec<dim>> held_v_;           ///< [m/s]
    std::vector<double> held_values_;
    std::vector<double> touched_;       ///< how often a node without mass stands in a row
    Vec<dim> wall_ = Vec<dim>::Zero();  ///< momentum that holding gives to the mapped velocity [kg m/s]
    Vec<dim> impulse_ = Vec<dim>::Zero();
    Vec<dim> load_ = Vec<dim>::Zero();  ///< total of body force and traction in this step [N]
    long crossings_ = 0;
};

}  // namespace ordo::solvers::mpm

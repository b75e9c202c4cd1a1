#pragma once
// The Material Point Method: read `step` first. One source for 1, 2 and 3 dimensions.
#include <optional>
#include <vector>

#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/linear.hpp"
#include "solvers/mpm/particles.hpp"
#include "solvers/mpm/transfer.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::mpm {

/// The solver "mpm" of the registry.
Solver solver();

/// Original MPM: particles carry mass, velocity and stress through a grid that is reset in every step.
///
///   m_i = sum S_ip m_p          f_i = - sum V_p sigma_p grad S_ip + sum S_ip m_p b_p          a_i = f_i / m_i
///   v_p += kick sum S_ip a_i    x_p += dt sum S_ip v_i     d eps = dt sym sum v_i (x) grad S_ip
///
/// S_ip and its gradient are those of the positions at the start of the step.
/// source   [Sulsky1994], [Sulsky1995]; order of the passes [Bardenhagen2002]; letters as there
template <int dim, class Basis = Linear>
class Mpm {
public:
    Mpm(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution, bool with_F)
        : options_(options),
          law_(scene.law),
          body_force_(scene.body_force),
          grid_(scene, resolution, options),
          p_(seeded<dim>(scene, resolution, options.placement, with_F)),
          b_(body_force_ ? p_.size() : 0) {}

    /// From t to t + dt. `kick` is the velocity's share of it: dt, or dt/2 in the first step of a leapfrog.
    void step(double t, double kick, double dt) {
        particles_to_grid(t);
        if (stress_first()) update_stress(dt);
        move_grid(kick);
        grid_to_particles(kick, dt);
        if (!stress_first()) update_stress(dt);
    }

    /// Velocities of a leapfrog live at half steps: brings them on by `kick` to the time of the positions.
    void synchronise(double t, double kick) {
        particles_to_grid(t);
        move_grid(kick);
        kick_particles(kick);
    }

    const Particles<dim>& particles() const { return p_; }
    Particles<dim>& particles() { return p_; }
    const Grid<dim>& grid() const { return grid_; }
    long crossings() const { return crossings_; }         ///< times a particle was found in a new cell
    const Vec<dim>& impulse() const { return impulse_; }  ///< of held faces and body force so far [kg m/s]

private:
    void particles_to_grid(double t);                // m_i, v_i, and f_i unless the stress is still to change
    void move_grid(double kick);                     // a_i = f_i / m_i, v_i += kick a_i, held nodes
    void grid_to_particles(double kick, double dt);  // v_p, then (re-mapped or not) x_p
    void update_stress(double dt);                   // d eps, F_p, sigma_p, V_p

    bool stress_first() const { return options_.stress_update == StressUpdate::usf; }
    bool moved_by_remapped() const { return options_.stress_update == StressUpdate::musl && options_.moved_by_remapped; }
    void locate(double t);
    template <bool mass, bool momentum, bool force>
    void scatter();
    void scatter_body_force(double t);
    void divide_by_mass();
    void kick_particles(double kick);
    void move_particles(double dt);

    template <class Visit>
    void nodes_of(std::size_t p, Visit&& visit) const {
        for_each_node<Basis, dim>(grid_, p_.base[p], p_.xi[p], visit);
    }

    Options options_;
    Law law_;
    std::optional<VectorField<dim>> body_force_;
    Grid<dim> grid_;
    Particles<dim> p_;
    std::vector<Vec<dim>> b_;  ///< body force at the particles; empty where the scene has none
    Vec<dim> impulse_ = Vec<dim>::Zero();
    Vec<dim> load_ = Vec<dim>::Zero();  ///< total body force of this step [N]
    long crossings_ = 0;
};

}  // namespace ordo::solvers::mpm

#include "solvers/mpm/passes.hpp"

#pragma once
// The fast kernel of MPM: the same steps as mpm.hpp, which stays the truth, for the choices that most runs make.
#include <memory>
#include <optional>
#include <vector>

#include "solvers/mpm/boundary.hpp"
#include "solvers/mpm/fast/instruction_sets.hpp"
#include "solvers/mpm/fast/section.hpp"
#include "solvers/mpm/fast/team.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::mpm::fast {

/// Whether the fast kernel serves these choices for this scene.
template <int dim>
bool serves(const SolidScene<dim>& scene, const Options& options);

/// Particles in slots by cells, swept by kernels that gather from the nodes, update and scatter in one go: grid to
/// particle of one step and particle to grid of the next. Between steps, the nodes hold the sums of the particles'
/// places. accuracy  as Mpm<dim>, but for the order of sums; the same bits whatever the instruction set and the threads
template <int dim>
class FastMpm {
public:
    /// A sweep is cut into sections of about `section` blocks, if that makes `fewest` of them: a body for threads.
    FastMpm(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution, bool with_F,
            long section = 256);
    static constexpr long fewest = 16;

    // as of Mpm<dim>
    void step(double t, double kick, double dt);
    void synchronise(double t, double kick);
    void meet_grid(double t);
    Particles<dim> particles() const;  ///< in their original order: X, x, v, m, volume, sigma and, where kept, F
    long crossings() const { return crossings_; }
    Vec<dim> momentum() const;
    double mass_on_grid() const;
    const Vec<dim>& impulse() const { return impulse_; }
    std::vector<Skipped> skipped() const;
    double helper_seconds() const { return team_ ? team_->helper_seconds() : 0; }
    std::size_t sections() const { return sections_.size(); }

    /// Called by kernels, see sweep.hpp.
    void settle(Hand<dim>& hand, Block& block, int slot, int lane, unsigned out, unsigned inverted, double* xi,
                double* keep);

private:
    FastMpm(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution, long section,
            Particles<dim>&& particles);

    using Nodes = std::vector<Eight>;
    using Field = std::array<Nodes, static_cast<std::size_t>(dim)>;
    /// A particle on a face, and a node that it touches with no weight but a gradient, and that has no mass.
    struct Touch {
        long node;
        Seat by;
    };

    // the passes
    void begin();
    void sweep(Pass pass, double kick, double dt);
    Sweep<dim> sweep_of(Pass pass, double kick, double dt);
    void sweep_section(Sweep<dim> s, Pass pass, Section<dim>& section, Hand<dim>& hand);
    void hear(Section<dim>& section, Pass pass, Told<dim>& all);
    void gather_loads(double t);
    void gather_body_force(double t);
    enum class Makes { v, a, both, a_added };  ///< added: v += kick a
    void solve(Makes what, double kick, bool ends_m);
    void kick_apart(double kick);
    void move_boundary(double dt, const Field& v);
    void clear(Field& field);

    // how work is shared out, in sections.cpp
    void cut();
    Pool& pool_of(Section<dim>& section) { return sections_.size() == 1 ? slots_.pool() : section.pool; }
    template <class Job>
    void over(long count, const Job& job);

    // who is where, in places.cpp and quiet.cpp
    double place(double x, int cell, int axis) const;  ///< xi as kernels find it [-]
    double place(Seat seat, int axis) const;
    Vec<dim> where(Seat seat) const;  ///< x [m]
    bool stands_within(const Vec<dim>& x, Cell<dim>& cell, Vec<dim>& xi) const;
    void send(Hand<dim>& hand, Seat from, const Cell<dim>& to, const Vec<dim>& xi, bool near);
    void seat_travellers(Hand<dim>& hand, Pass pass, int ahead);
    bool seat(const Traveller<dim>& who, Pass pass, Told<dim>& told, Pool& pool);
    template <int degree>
    void share_out(const Traveller<dim>& who, Pass pass);
    void arrange();
    void mark_swept();
    void list_runs();
    void wake();
    void wake_loaded();
    template <class Visit>
    void each_touched(Seat seat, Visit&& visit) const;
    bool on_face(Seat seat) const;
    bool find_touches();
    void lend_velocity();
    long padded(int node) const;  ///< where the grid's node stands in the fields
    static double& at(Nodes& nodes, long i) { return nodes[static_cast<std::size_t>(i / lanes)].at[i % lanes]; }
    static double at(const Nodes& nodes, long i) { return nodes[static_cast<std::size_t>(i / lanes)].at[i % lanes]; }

    Options options_;
    std::optional<VectorField<dim>> body_force_;
    double damping_;
    bool total_, everywhere_;
    Grid<dim> grid_;
    double per_h_;             ///< [1/m]
    std::vector<Vec<dim>> X_;  ///< of the particles in their original order [m]
    Slots<dim> slots_;
    Boundary<dim> boundary_;
    Kernels<dim> kernels_;
    Rate rate_;
    Moduli C_;
    double rest_v_, rest_sigma_;  ///< what is less counts as rest in a quiet region
    std::array<std::vector<double>, static_cast<std::size_t>(dim)> ends_;
    Nodes m_;
    Field p_, f_, v_, a_, u_;
    std::vector<Held> held_;                             ///< nodes by their place in the fields
    std::vector<int> order_;                             ///< of the blocks that are swept
    std::vector<int> watched_;                           ///< those of them that sleep
    std::vector<long> runs_;                             ///< of the nodes that they touch
    std::vector<unsigned char> near_, seen_, seen_row_;  ///< marks of blocks, of runs of nodes, along a line
    long section_;                                       ///< blocks
    std::vector<Section<dim>> sections_;                 ///< of the order
    std::vector<Hand<dim>> hands_;                       ///< by members of the team
    std::shared_ptr<Team> team_;  ///< started when a sweep has several sections; a copy works with the same
    std::vector<Touch> touches_;
    std::vector<Vec<dim>> b_;  ///< [m/s^2]; entry 0 for lanes without particle
    Vec<dim> load_ = Vec<dim>::Zero();
    Vec<dim> impulse_ = Vec<dim>::Zero();
    bool on_face_ = false;
    bool dirty_ = true;    ///< another set of blocks has particles or is awake
    bool missed_ = false;  ///< a particle came where no sweep was
    long lost_;            ///< first particle that has left the grid
    long crossings_ = 0;
    double swept_ = 0, due_ = 0;  ///< particle-steps done, and of the whole body
    double in_sweep_ = 0;         ///< particles in the blocks that are swept
    double joined_ = 0;           ///< mass of blocks that are swept from the next sweep on [kg]
};

}  // namespace ordo::solvers::mpm::fast

#pragma once
// The choices of the MPM family, each named as in the literature; declared once, in choices.cpp.
#include <vector>

#include "core/parameter.hpp"
#include "solvers/scene.hpp"

namespace ordo::solvers::mpm {

enum class Frame { updated, total };
enum class Basis { linear, quadratic, cubic, quartic, ugimp, cpgimp, cpdi, cpdi2, ddmp };
enum class Mass { lumped, consistent, fmpm };
enum class StressUpdate { usf, usl, musl, usavg };
enum class Time { symplectic_euler, leapfrog, yoshida4, yoshida6 };
enum class StrainMesh { undeformed, midpoint, moved };
enum class Transfer { flip, pic, blend, xpic, fmpm, apic, tpic, mls };
enum class Placement { cell_centred, even_interior, gauss, body_centred };
enum class BeyondGrid { extend, extrapolate, follow };
enum class Reconstruction { none, cubic_spline, tls, mls, impm };
enum class BodyForce { particles, nodes, left_out };
enum class Kernel { fast, fast_everywhere, readable };

/// How the method discretises; plain values, chosen between the passes of a step.
struct Options {
    Frame frame = Frame::updated;
    Basis basis = Basis::linear;
    Mass mass = Mass::lumped;
    StressUpdate stress_update = StressUpdate::musl;
    Time time = Time::symplectic_euler;
    Transfer transfer = Transfer::flip;
    Placement placement = Placement::cell_centred;
    BeyondGrid beyond_grid = BeyondGrid::extend;
    Reconstruction reconstruction = Reconstruction::none;
    BodyForce body_force = BodyForce::particles;
    int terms = 4;             ///< k of FMPM(k) and XPIC(k)
    int degree = 3;            ///< of a reconstruction by moving least squares
    double flip_share = 0.99;  ///< of a blend of FLIP and PIC
    double margin = 0.1;       ///< grid beyond each free face, in units of the body's length
    StrainMesh strain_mesh = StrainMesh::undeformed;
    bool volume_updated = true;         ///< V_p follows the strain increments
    bool stress_from_F = false;         ///< a law that has both forms is taken in closed form
    bool moved_by_remapped = true;      ///< MUSL: x_p follows the re-mapped nodal velocity
    bool last_particle_loaded = false;  ///< traction acts on the outermost particle, not at the face
    bool cells_span_grid = false;       ///< `cells` divides body and margin together
    bool conservative = false;          ///< a reconstruction's error of momentum is put right after every kick
    bool volume_of_cell = false;        ///< V_p is the cell's share even where particles stand denser or wider
    Kernel kernel = Kernel::fast;       ///< how the steps are computed
    int threads = 1;                    ///< of the fast kernel

    int spline_degree() const;  ///< of the grid's functions: 1 for all that are made of tents
    /// A drift by velocities that are mapped off the particles follows the kick: the parts of a composed time step.
    bool separable() const { return stress_update == StressUpdate::musl && moved_by_remapped; }
    bool boxes() const { return basis >= Basis::ugimp && basis <= Basis::cpdi2; }  ///< particles are boxes, not points
    bool leaps() const { return time == Time::leapfrog; }
    bool composed() const { return time == Time::yoshida4 || time == Time::yoshida6; }
    bool affine() const {
        return transfer == Transfer::apic || transfer == Transfer::tpic || transfer == Transfer::mls;
    }
};

/// How finely: cells along the first axis, particles a cell and direction, and the step [s]; and how the particles
/// stand.
struct Resolution {
    int cells = 1;
    double ppc = 1;
    double spread = 1;   ///< distances from the middle of the cell, in those of the placement
    double shift = 0;    ///< of all particles along each axis, in the lengths that they stand for
    double scatter = 0;  ///< the same of each by itself, up to half of this to either side
    double h = 1;
    double dt = 0;
};

std::vector<Parameter> option_parameters();
std::vector<Parameter> resolution_parameters();

/// Throws InputError on choices that make no sense together.
Options options_from(const Values& values);

/// Throws InputError on choices that make no sense for this scene.
template <int dim>
void check_fits(const SolidScene<dim>& scene, const Options& options);

/// Throws InputError unless exactly one of dt and courant is given and h divides every edge of the body.
template <int dim>
Resolution resolution_from(const SolidScene<dim>& scene, const Options& options, const Values& values);

}  // namespace ordo::solvers::mpm

#pragma once
// The choices of the MPM family, each named as in the literature; declared once, in options.cpp.
#include <vector>

#include "core/parameter.hpp"
#include "solvers/scene.hpp"

namespace ordo::solvers::mpm {

enum class StressUpdate { usf, usl, musl };
enum class Placement { cell_centred, even_interior, gauss };

/// How the method discretises; plain values, chosen between the passes of a step.
struct Options {
    StressUpdate stress_update = StressUpdate::musl;
    Placement placement = Placement::cell_centred;
    bool strain_from_moved_mesh = false;  ///< d eps by the mesh after its move instead of before
    bool volume_updated = true;           ///< V_p *= 1 + tr d eps
    bool moved_by_remapped = true;        ///< MUSL: x_p follows the re-mapped nodal velocity
    bool half_kick = false;               ///< start by half a velocity step: leapfrog
    bool extrapolate = false;             ///< past the last node, keep using the last cell's functions
    double margin = 0.1;                  ///< grid beyond each free face, in units of the body's length
};

/// How finely: cells along the first axis, particles a cell and direction, and the step [s].
struct Resolution {
    int cells = 1;
    int ppc = 1;
    double h = 1;
    double dt = 0;
};

std::vector<Parameter> option_parameters();
std::vector<Parameter> resolution_parameters();

/// Throws InputError on choices that make no sense together.
Options options_from(const Values& values);

/// Throws InputError unless exactly one of dt and courant is given and h divides every edge of the body.
template <int dim>
Resolution resolution_from(const SolidScene<dim>& scene, const Values& values);

}  // namespace ordo::solvers::mpm

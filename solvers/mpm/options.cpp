#include "solvers/mpm/options.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::solvers::mpm {

std::vector<Parameter> option_parameters() {
    return {
        word("basis", "linear", {{"linear", "tent functions [Sulsky1994]"}}, "grid shape functions"),
        word("mass", "lumped", {{"lumped", "diagonal mass m_i = sum S_ip m_p [Sulsky1994]"}}, "grid mass matrix"),
        word("stress_update", "musl",
             {{"usf", "update stress first, from the mapped velocity [Bardenhagen2002]"},
              {"usl", "update stress last, from the accelerated velocity [Sulsky1994]"},
              {"musl", "modified USL: last, from velocities mapped again off the particles [Sulsky1995]"}},
             "when the stress follows the velocity"),
        word("strain_increment", "undeformed_mesh",
             {{"undeformed_mesh", "gradient of the displacement increment on the mesh before it moves"},
              {"moved_mesh", "the same on the moved mesh [WobbesTielen2015]"}},
             "which mesh the strain increment is taken from"),
        word("volume", "updated",
             {{"updated", "V_p *= 1 + tr d eps in every step"}, {"fixed", "V_p stays as at the start"}},
             "particle volume in the internal force"),
        word("placement", "cell_centred",
             {{"cell_centred", "local (2k-1)/(2 ppc): centres of equal sub-cells"},
              {"even_interior", "local k/(ppc+1) [WobbesTielen2015]"},
              {"gauss", "Gauss points with Gauss weights"}},
             "where the particles of a cell start"),
        word("position_update", "remapped",
             {{"remapped", "x_p follows the re-mapped velocity [WobbesTielen2015]"},
              {"accelerated", "x_p follows the accelerated velocity [Nguyen2023]"}},
             "which nodal velocity moves MUSL particles; USF and USL know the accelerated one only"),
        toggle("half_kick", false,
               "begin with half a velocity step: leapfrog, second order in time for any a(0) with musl and remapped; "
               "not with usf"),
        word("beyond_grid", "extend",
             {{"extend", "the grid goes on beyond free faces by `margin`"},
              {"extrapolate", "no further node: the last cell's functions go on outside it [WobbesTielen2015]"}},
             "what a particle meets outside the body's first box"),
        number("margin", "-", 0.1, between(0, 10),
               "grid beyond each free face, in units of the body's edge; at least one cell"),
    };
}

std::vector<Parameter> resolution_parameters() {
    return {
        required(whole("cells", 1, between(1, 1e7), "cells along the first axis of the body")),
        whole("ppc", 1, between(1, 64), "particles a cell and direction"),
        without_default(number("dt", "s", 0, positive, "time step; give dt or courant")),
        without_default(number("courant", "-", 0, positive, "dt sqrt(stiffness/rho)/h; give dt or courant")),
    };
}

Options options_from(const Values& values) {
    Options options;
    const auto& order = values.word("stress_update");
    options.stress_update = order == "usf"   ? StressUpdate::usf
                            : order == "usl" ? StressUpdate::usl
                                             : StressUpdate::musl;
    const auto& placement = values.word("placement");
    options.placement = placement == "gauss"           ? Placement::gauss
                        : placement == "even_interior" ? Placement::even_interior
                                                       : Placement::cell_centred;
    options.strain_from_moved_mesh = values.word("strain_increment") == "moved_mesh";
    options.volume_updated = values.word("volume") == "updated";
    options.moved_by_remapped =
        options.stress_update == StressUpdate::musl && values.word("position_update") == "remapped";
    options.half_kick = values.toggle("half_kick");
    if (options.half_kick && options.stress_update == StressUpdate::usf) {
        throw InputError(
            "", "'half_kick' is true, but with stress_update 'usf' it makes no leapfrog (nearest: 'usl' or 'musl')");
    }
    options.extrapolate = values.word("beyond_grid") == "extrapolate";
    options.margin = values.number("margin");
    return options;
}

template <int dim>
Resolution resolution_from(const SolidScene<dim>& scene, const Values& values) {
    Resolution resolution;
    resolution.cells = values.whole("cells");
    resolution.ppc = values.whole("ppc");
    const Vec<dim> edges = scene.upper - scene.lower;
    resolution.h = edges[0] / resolution.cells;
    for (int axis = 1; axis < dim; ++axis) {
        const double count = edges[axis] / resolution.h;
        if (std::abs(count - std::round(count)) > 1e-9 * count || count < 0.5) {
            throw InputError("", "'cells' is " + std::to_string(resolution.cells) + ", which gives " + shortest(count) +
                                     " cells along axis " + std::to_string(axis) + ", but must give a whole number");
        }
    }
    if (values.has("dt") == values.has("courant")) {
        throw InputError("", "solver mpm takes exactly one of 'dt' and 'courant'");
    }
    const double stiffness = std::visit([](const auto& law) { return law.stiffness(); }, scene.law);
    resolution.dt = values.has("dt") ? values.number("dt")
                                     : values.number("courant") * resolution.h / std::sqrt(stiffness / scene.rho);
    return resolution;
}

template Resolution resolution_from<1>(const SolidScene<1>&, const Values&);
template Resolution resolution_from<2>(const SolidScene<2>&, const Values&);
template Resolution resolution_from<3>(const SolidScene<3>&, const Values&);

}  // namespace ordo::solvers::mpm

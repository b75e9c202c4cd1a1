// From declared values to options, and what does not go together.
#include "solvers/mpm/options.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"
#include "solvers/mpm/particles.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::mpm {
namespace {

/// The enumerator at the place that the word has in its declaration.
template <class Enum>
Enum choice(const Values& values, const std::string& name) {
    static const auto declared = option_parameters();
    for (const auto& parameter : declared) {
        if (parameter.name != name) continue;
        for (std::size_t k = 0; k < parameter.words.size(); ++k) {
            if (parameter.words[k].name == values.word(name)) return static_cast<Enum>(k);
        }
    }
    throw std::logic_error("no option named '" + name + "' has such a word");
}

void refuse_if(bool wrong, const std::string& why) {
    if (wrong) throw InputError("", why);
}

bool made_of_tents_at_points(Basis basis) { return basis == Basis::linear || basis == Basis::ddmp; }

void check_time(const Options& o) {
    const bool early = o.stress_update == StressUpdate::usf || o.stress_update == StressUpdate::usavg;
    refuse_if(o.leaps() && early,
              "'time' is \"leapfrog\", but with stress_update 'usf' or 'usavg' the half kick makes no "
              "leapfrog (nearest: 'usl' or 'musl')");
    refuse_if(o.composed() && !o.separable(),
              "'time' is a composition, which needs stress_update 'musl' with position_update 'remapped'");
    refuse_if(o.composed() && o.transfer != Transfer::flip && o.transfer != Transfer::blend,
              "'time' is a composition, which needs transfer 'flip' or 'blend'");
}

void check_transfer(const Options& o) {
    const bool musl = o.stress_update == StressUpdate::musl;
    const bool by_functions = o.transfer == Transfer::apic || o.transfer == Transfer::mls;
    refuse_if(
        by_functions && made_of_tents_at_points(o.basis),
        "'transfer' divides by the spread of the functions, which tents lose on a node (nearest: 'tpic', the same "
        "elsewhere)");
    refuse_if(
        o.affine() && musl && !o.moved_by_remapped,
        "'transfer' is affine about the particles' places, which position_update 'accelerated' leaves before they "
        "are mapped again (nearest: 'remapped')");
    refuse_if(
        o.basis == Basis::cpdi2 && (o.transfer == Transfer::xpic || o.transfer == Transfer::fmpm),
        "'basis' is \"cpdi2\", whose corners follow the grid and not these transfers' particles (nearest: 'cpdi')");
    refuse_if(o.affine() && o.mass != Mass::lumped,
              "'transfer' is affine, which needs mass 'lumped': a consistent mass counts the affine part twice");
    refuse_if(
        o.transfer == Transfer::xpic && (o.mass != Mass::lumped || musl),
        "'transfer' is \"xpic\", which needs mass 'lumped' and a stress_update other than 'musl' (nearest: 'usl')");
    refuse_if(o.transfer == Transfer::fmpm && (o.mass == Mass::lumped || musl),
              "'transfer' is \"fmpm\", which needs mass 'fmpm' or 'consistent' and a stress_update other than 'musl' "
              "(nearest: 'usl')");
}

void check_frame(const Options& o) {
    const bool total = o.frame == Frame::total;
    refuse_if(
        total && o.strain_mesh == StrainMesh::moved,
        "'strain_increment' is \"moved_mesh\", but in the total frame no mesh moves (nearest: 'undeformed_mesh')");
    refuse_if(total && o.beyond_grid != BeyondGrid::extend,
              "'beyond_grid' is for the updated frame: in the total frame nothing leaves the grid");
    refuse_if(o.beyond_grid == BeyondGrid::extrapolate && (o.boxes() || o.basis == Basis::ddmp),
              "'beyond_grid' is \"extrapolate\", which needs a basis 'linear' or of splines");
    refuse_if(o.last_particle_loaded && o.beyond_grid == BeyondGrid::follow,
              "'traction' is \"last_particle\", but a grid that follows the body needs its faces (nearest: 'face')");
    refuse_if(
        o.cells_span_grid && (o.placement != Placement::body_centred || o.beyond_grid != BeyondGrid::extend || total),
        "'cells_span' is \"grid\", which needs placement 'body_centred', beyond_grid 'extend' and frame 'updated'");
    refuse_if(o.volume_of_cell && o.placement != Placement::body_centred,
              "'particle_volume' is \"share_of_cell\", which differs with placement 'body_centred' only");
}

void check_reconstruction(const Options& o) {
    if (o.reconstruction == Reconstruction::none)
        return refuse_if(o.conservative, "'conservative' puts a reconstruction right, and there is none");
    refuse_if(o.frame == Frame::total,
              "'reconstruction' is for the updated frame: in the total frame the particles never "
              "leave their quadrature points (nearest: 'none')");
    const bool plain = o.transfer == Transfer::flip || o.transfer == Transfer::blend || o.transfer == Transfer::pic;
    refuse_if(!plain || o.mass == Mass::fmpm,
              "'reconstruction' needs transfer 'flip', 'pic' or 'blend' and mass 'lumped' or 'consistent'");
    refuse_if(o.beyond_grid == BeyondGrid::extrapolate || o.last_particle_loaded,
              "'reconstruction' needs the body's faces: beyond_grid 'extend' or 'follow', and traction 'face'");
    const bool fits_impm = o.basis == Basis::linear && o.mass == Mass::lumped && o.stress_update == StressUpdate::usl;
    refuse_if(o.reconstruction == Reconstruction::impm && !fits_impm,
              "'reconstruction' is \"impm\", which needs basis 'linear', mass 'lumped' and stress_update 'usl'");
    refuse_if(o.boxes() || o.basis == Basis::ddmp, "'reconstruction' needs a basis 'linear' or of splines");
}

bool knows_rates(const Law& law) {
    return std::holds_alternative<LogarithmicLaw>(law) || std::holds_alternative<ReciprocalLaw>(law) ||
           std::holds_alternative<NominalLaw>(law);
}

/// What looks at distances to nodes, or at the body's ends, does not know that the body goes on across a face.
template <int dim>
void check_periodic(const SolidScene<dim>& scene, const Options& o) {
    if (!any_face(scene, Face::periodic)) return;
    for (const auto& pair : scene.faces)
        refuse_if(pair[0] != pair[1] && (pair[0] == Face::periodic || pair[1] == Face::periodic),
                  "the scene has a periodic face, so that the one across must be periodic too");
    refuse_if(o.affine(), "'transfer' is affine, which the scene's periodic faces do not go with (nearest: 'flip')");
    refuse_if(o.basis == Basis::cpdi2 || o.basis == Basis::ddmp,
              "'basis' is one that the scene's periodic faces do not go with (nearest: 'cpdi')");
    refuse_if(o.reconstruction != Reconstruction::none || o.beyond_grid != BeyondGrid::extend || o.cells_span_grid ||
                  o.body_force == BodyForce::nodes,
              "the scene has periodic faces, which need reconstruction 'none', beyond_grid 'extend', cells_span 'body' "
              "and body_force 'particles' or 'left_out'");
}

}  // namespace

int Options::spline_degree() const {
    return basis == Basis::quadratic ? 2 : basis == Basis::cubic ? 3 : basis == Basis::quartic ? 4 : 1;
}

Options options_from(const Values& values) {
    Options o;
    o.frame = choice<Frame>(values, "frame");
    o.basis = choice<Basis>(values, "basis");
    o.mass = choice<Mass>(values, "mass");
    o.stress_update = choice<StressUpdate>(values, "stress_update");
    o.time = choice<Time>(values, "time");
    o.transfer = choice<Transfer>(values, "transfer");
    o.placement = choice<Placement>(values, "placement");
    o.beyond_grid = choice<BeyondGrid>(values, "beyond_grid");
    o.reconstruction = choice<Reconstruction>(values, "reconstruction");
    o.body_force = choice<BodyForce>(values, "body_force");
    o.kernel = choice<Kernel>(values, "kernel");
    o.threads = values.whole("threads");
    o.terms = values.whole("k");
    o.degree = values.whole("degree");
    o.flip_share = values.number("flip_share");
    o.margin = values.number("margin");
    o.conservative = values.toggle("conservative");
    o.strain_mesh = choice<StrainMesh>(values, "strain_increment");
    o.volume_updated = values.word("volume") == "updated";
    o.stress_from_F = values.word("stress_from") == "F";
    o.moved_by_remapped = o.stress_update == StressUpdate::musl && values.word("position_update") == "remapped";
    o.last_particle_loaded = values.word("traction") == "last_particle";
    o.cells_span_grid = values.word("cells_span") == "grid";
    o.volume_of_cell = values.word("particle_volume") == "share_of_cell";
    check_time(o);
    check_transfer(o);
    check_frame(o);
    check_reconstruction(o);
    return o;
}

template <int dim>
void check_fits(const SolidScene<dim>& scene, const Options& o) {
    const bool history = std::holds_alternative<J2Law>(scene.law);
    const bool rates = knows_rates(scene.law);
    refuse_if(dim > 1 && o.reconstruction != Reconstruction::none, "'reconstruction' is for one dimension");
    check_periodic(scene, o);
    refuse_if(
        o.reconstruction != Reconstruction::none && any_face(scene, Face::free) && o.beyond_grid != BeyondGrid::follow,
        "'reconstruction' would cut cells at the scene's free face, whose load no particle then feels: choose "
        "beyond_grid 'follow'");
    refuse_if(dim > 1 && o.beyond_grid == BeyondGrid::follow,
              "'beyond_grid' is \"follow\", which is for one dimension");
    refuse_if(dim > 1 && o.stress_from_F && rates,
              "'stress_from' is \"F\", but the scene's law has an integral in one dimension only");
    refuse_if(o.stress_from_F && history, "'stress_from' is \"F\", but the scene's law has a history");
    refuse_if(o.strain_mesh != StrainMesh::undeformed && !history && (!rates || o.stress_from_F),
              "'strain_increment' chooses a mesh, but the stress is taken from F, not from increments");
    refuse_if(scene.deformed && (history || (dim > 1 && rates)),
              "the scene starts deformed, which needs a law in closed form");
    refuse_if(scene.face_velocity && o.frame == Frame::updated,
              "the scene moves a held face, which leaves its nodes behind in the updated frame: choose frame 'total'");
}

namespace {

/// Where in their cells particles are put, away from the placement.
void read_places(const Options& options, const Values& values, Resolution& resolution) {
    resolution.spread = values.number("spread");
    resolution.shift = values.number("shift");
    resolution.scatter = values.number("scatter");
    if (options.placement == Placement::body_centred)
        return refuse_if(resolution.spread != 1 || resolution.shift != 0,
                         "'spread' and 'shift' are for placements by cells, and 'placement' is \"body_centred\"");
    for (const auto& [xi, share] : seeds_in_cell(options, resolution))
        refuse_if(xi < 0 || xi > 1, "'shift' and 'spread' together put a particle at " + shortest(xi) +
                                        " of its cell, which must lie in [0, 1]");
}

}  // namespace

template <int dim>
Resolution resolution_from(const SolidScene<dim>& scene, const Options& options, const Values& values) {
    Resolution resolution;
    resolution.cells = values.whole("cells");
    resolution.ppc = values.number("ppc");
    refuse_if(options.placement != Placement::body_centred && resolution.ppc != std::floor(resolution.ppc),
              "'ppc' is " + shortest(resolution.ppc) + ", but must be whole unless placement is 'body_centred'");
    refuse_if(options.placement == Placement::body_centred && std::round(resolution.ppc * resolution.cells) < 1,
              "'ppc' is " + shortest(resolution.ppc) + ", which leaves no particle");
    read_places(options, values, resolution);
    const Vec<dim> edges = scene.upper - scene.lower;
    if (options.cells_span_grid) {
        const double free_ends = (scene.faces[0][0] == Face::free ? 1 : 0) + (scene.faces[0][1] == Face::free ? 1 : 0);
        refuse_if(dim > 1 || scene.faces[0][0] == Face::free,
                  "'cells_span' is \"grid\", which is for one dimension with a held lower face");
        resolution.h = edges[0] * (1 + free_ends * options.margin) / resolution.cells;
    } else {
        resolution.h = edges[0] / resolution.cells;
    }
    for (int axis = 1; axis < dim; ++axis) {
        const double count = edges[axis] / resolution.h;
        if (std::abs(count - std::round(count)) > 1e-9 * count || count < 0.5) {
            throw InputError("", "'cells' is " + std::to_string(resolution.cells) + ", which gives " + shortest(count) +
                                     " cells along axis " + std::to_string(axis) + ", but must give a whole number");
        }
    }
    // Nodes and particles are numbered by int; margins count on both sides.
    double nodes = 1;
    for (int axis = 0; axis < dim; ++axis)
        nodes *= edges[axis] / resolution.h * std::max(1 + 2 * options.margin, resolution.ppc) + 8;
    refuse_if(nodes > std::numeric_limits<int>::max(), "'cells' is " + std::to_string(resolution.cells) +
                                                           ", which makes more nodes or particles than can be counted");
    resolution.dt = step_from(values, resolution.h, std::sqrt(stiffness(scene.law) / scene.rho), "mpm");
    return resolution;
}

template void check_fits<1>(const SolidScene<1>&, const Options&);
template void check_fits<2>(const SolidScene<2>&, const Options&);
template void check_fits<3>(const SolidScene<3>&, const Options&);
template Resolution resolution_from<1>(const SolidScene<1>&, const Options&, const Values&);
template Resolution resolution_from<2>(const SolidScene<2>&, const Options&, const Values&);
template Resolution resolution_from<3>(const SolidScene<3>&, const Options&, const Values&);

}  // namespace ordo::solvers::mpm

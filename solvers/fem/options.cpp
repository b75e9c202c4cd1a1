#include "solvers/fem/options.hpp"

#include <cmath>

#include "core/error.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::fem {

std::vector<Parameter> option_parameters() {
    return {
        word("mass", "lumped",
             {{"lumped", "diagonal, by row sums; stable for courant <= 1 [Hughes2000]"},
              {"consistent", "tridiagonal, from the shape functions; stable for courant <= 1/sqrt 3 [Hughes2000]"}},
             "mass matrix"),
        word("time", "leapfrog",
             {{"symplectic_euler", "whole kicks dt from the start; first order [WobbesTielen2015]"},
              {"leapfrog", "central difference, the first kick dt/2; second order [Hughes2000]"}},
             "explicit time scheme"),
        word("body_force", "consistent",
             {{"consistent", "two Gauss points an element [Hughes2000]"},
              {"lumped", "at the nodes, times the lumped mass"}},
             "quadrature of the body force"),
        word("sampled_at", "nodes",
             {{"nodes", "stress and strain there are means of the adjoining elements"},
              {"centres", "of the elements; displacement and velocity there are means of two nodes"}},
             "where the points of a snapshot are"),
    };
}

std::vector<Parameter> resolution_parameters() {
    return appended({required(whole("cells", 1, between(1, 1e7), "elements along the body"))}, step_parameters());
}

Options options_from(const Values& values) {
    return {.lumped = values.word("mass") == "lumped",
            .leapfrog = values.word("time") == "leapfrog",
            .body_force_lumped = values.word("body_force") == "lumped",
            .at_centres = values.word("sampled_at") == "centres"};
}

Resolution resolution_from(const SolidScene<1>& scene, const Values& values) {
    if (any_face(scene, Face::periodic))
        throw InputError("", "the scene has periodic faces, which solver fem does not know (nearest: fixed)");
    Resolution resolution;
    resolution.cells = values.whole("cells");
    resolution.h = (scene.upper[0] - scene.lower[0]) / resolution.cells;
    resolution.dt = step_from(values, resolution.h, std::sqrt(stiffness(scene.law) / scene.rho), "fem");
    return resolution;
}

}  // namespace ordo::solvers::fem

#pragma once
// A solver at any Courant number on a body at rest: what stability is asked of.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solvers/solver.hpp"

namespace ordo::studies {

struct Scheme {
    solvers::Scene scene;
    const solvers::Solver* solver = nullptr;
    Values options;
    Values resolution;  ///< its courant is replaced

    solvers::Plan plan(double courant) const;
    std::unique_ptr<solvers::Simulation> start(const solvers::Scene& scene, double courant,
                                               const std::vector<std::string>& fields) const;

private:
    Values at(double courant) const;
};

/// The body without loads, with its faces, and with this velocity and deformation at the start. Throws InputError for a
/// scene that is no body in one dimension.
solvers::SolidScene<1> at_rest(const solvers::Scene& scene);

/// sqrt(stiffness / rho) [m/s].
double wave_speed(const solvers::SolidScene<1>& scene);

}  // namespace ordo::studies

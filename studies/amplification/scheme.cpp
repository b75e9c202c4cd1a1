#include "studies/amplification/scheme.hpp"

#include <cmath>

#include "core/error.hpp"

namespace ordo::studies {

Values Scheme::at(double courant) const {
    Given given = resolution.all();
    given.erase("dt");
    given.insert_or_assign("courant", courant);
    return resolve(solver->resolution, given, "", "solver " + solver->name);
}

solvers::Plan Scheme::plan(double courant) const { return solver->plan(scene, options, at(courant)); }

std::unique_ptr<solvers::Simulation> Scheme::start(const solvers::Scene& changed, double courant,
                                                   const std::vector<std::string>& fields) const {
    return solver->start(changed, options, at(courant), fields);
}

solvers::SolidScene<1> at_rest(const solvers::Scene& scene) {
    const auto* body = std::get_if<solvers::SolidScene<1>>(&scene);
    if (body == nullptr) throw InputError("", "the scene is no body in one dimension");
    solvers::SolidScene<1> still = *body;
    still.velocity = {};
    still.deformed.reset();
    still.body_force.reset();
    still.traction.reset();
    still.face_velocity.reset();
    return still;
}

double wave_speed(const solvers::SolidScene<1>& scene) { return std::sqrt(solvers::stiffness(scene.law) / scene.rho); }

}  // namespace ordo::studies

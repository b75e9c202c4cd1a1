#include "solvers/solver.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/named.hpp"

namespace ordo::solvers {

const Field& Snapshot::field(const std::string& name) const {
    for (const auto& field : fields) {
        if (field.name == name) return field;
    }
    throw std::logic_error("the snapshot holds no field '" + name + "'");
}

long steps_to(double duration, double dt) { return std::max(0L, static_cast<long>(std::ceil(duration / dt - 1e-9))); }

std::vector<Parameter> step_parameters() {
    return {without_default(number("dt", "s", 0, positive, "time step; give dt or courant")),
            without_default(number("courant", "-", 0, positive, "dt sqrt(stiffness/rho)/h; give dt or courant"))};
}

double step_from(const Values& values, double h, double wave_speed, const std::string& solver) {
    if (values.has("dt") == values.has("courant"))
        throw InputError("", "solver " + solver + " takes exactly one of 'dt' and 'courant'");
    return values.has("dt") ? values.number("dt") : values.number("courant") * h / wave_speed;
}

const Solver& solver_named(const std::string& name, const std::string& where) {
    return named(all_solvers(), name, where, "there is no solver");
}

}  // namespace ordo::solvers

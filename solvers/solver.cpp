#include "solvers/solver.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::solvers {

const Field& Snapshot::field(const std::string& name) const {
    for (const auto& field : fields) {
        if (field.name == name) return field;
    }
    throw std::logic_error("the snapshot holds no field '" + name + "'");
}

long steps_to(double duration, double dt) { return std::max(0L, static_cast<long>(std::ceil(duration / dt - 1e-9))); }

const Solver& solver_named(const std::string& name, const std::string& where) {
    std::vector<std::string> names;
    for (const auto& solver : all_solvers()) {
        if (solver.name == name) return solver;
        names.push_back(solver.name);
    }
    throw InputError(where, "there is no solver '" + name + "'" + did_you_mean(name, names));
}

}  // namespace ordo::solvers

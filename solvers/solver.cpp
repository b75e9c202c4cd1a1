#include "solvers/solver.hpp"

#include <algorithm>
#include <cmath>

#include "core/named.hpp"

namespace ordo::solvers {

const Field& Snapshot::field(const std::string& name) const {
    for (const auto& field : fields) {
        if (field.name == name) return field;
    }
    throw std::logic_error("the snapshot holds no field '" + name + "'");
}

long steps_to(double duration, double dt) { return std::max(0L, static_cast<long>(std::ceil(duration / dt - 1e-9))); }

const Solver& solver_named(const std::string& name, const std::string& where) {
    return named(all_solvers(), name, where, "there is no solver");
}

}  // namespace ordo::solvers

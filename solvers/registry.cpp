// THE list of solvers: one include and one line each.
#include "solvers/fem/fem.hpp"
#include "solvers/godunov/godunov.hpp"
#include "solvers/mpm/mpm.hpp"
#include "solvers/root_finding/root_finding.hpp"
#include "solvers/rrm/rrm.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers {

const std::vector<Solver>& all_solvers() {
    static const std::vector<Solver> list{
        mpm::solver(),
        fem::solver(),
        rrm::solver(),
        godunov::solver(),
        root_finding::solver(),
    };
    return list;
}

}  // namespace ordo::solvers

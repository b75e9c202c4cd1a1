// THE list of solvers: one include and one line each.
#include "solvers/mpm/mpm.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers {

const std::vector<Solver>& all_solvers() {
    static const std::vector<Solver> list{
        mpm::solver(),
    };
    return list;
}

}  // namespace ordo::solvers

// THE list of exact solutions: one include and one line each.
#include "core/named.hpp"
#include "oracles/bar_vibration.hpp"
#include "oracles/free_flight.hpp"
#include "oracles/scalar_root_convergence.hpp"

namespace ordo::oracles {

const std::vector<Oracle>& all_oracles() {
    static const std::vector<Oracle> list{
        bar_vibration(),
        free_flight(),
        scalar_root_convergence(),
    };
    return list;
}

const Oracle& oracle_named(const std::string& name, const std::string& where) {
    return named(all_oracles(), name, where, "there is no exact solution");
}

}  // namespace ordo::oracles

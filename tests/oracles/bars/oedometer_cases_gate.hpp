#pragma once
// The columns that the tests of the oedometer ask, and their catalogue entry.
#include <string>
#include <vector>

#include "tests/oracles/bars/bar_traction_cases_gate.hpp"
#include "tests/oracles/bars/oedometer_gate.hpp"

namespace ordo::oracles::gate::loaded {

/// Published sets and others: gravity, load, both with either sign, ramps shorter and longer than a transit (0.65 s).
inline std::vector<Oedometer> columns() {
    const Oedometer soft{.H = 1.3, .E = 8, .rho = 2, .g = 2.1, .p0 = 0.3};
    std::vector<Oedometer> list{{},
                                {.H = 1, .E = 1e5, .rho = 50, .g = 9.81, .p0 = -10},
                                {.H = 0.3, .E = 2.1e11, .rho = 7850, .g = 0, .p0 = -3e6},
                                soft};
    for (const double ramp : {0.0731, 1.0917, 3.2171}) {
        list.push_back(soft);
        list.back().ramp = ramp;
        list.back().p0 = ramp > 2 ? -1.1 : 0;
    }
    return list;
}

inline std::string name_of(const Oedometer& column) {
    return "H = " + std::to_string(column.H) + ", g = " + std::to_string(column.g) +
           ", p0 = " + std::to_string(column.p0) + ", ramp = " + std::to_string(column.ramp);
}

inline Exact bound_column(const Given& given) {
    const Oracle oracle = oedometer();
    return oracle.bind(resolve(oracle.parameters, given, "", "oedometer"));
}

inline Given given_by(const Oedometer& c) {
    return {{"H", c.H},      {"E", c.E}, {"rho", c.rho}, {"g", c.g}, {"p0", c.p0}, {"terms", double(c.terms)},
            {"ramp", c.ramp}};
}

}  // namespace ordo::oracles::gate::loaded

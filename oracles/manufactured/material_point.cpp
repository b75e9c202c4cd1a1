#include "oracles/manufactured/material_point.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::oracles {

std::vector<FieldInfo> manufactured_fields() {
    auto fields = standard_fields();
    fields.push_back({"body_force", "m/s^2", 1});
    fields.push_back({"deformation_gradient", "-", 2});
    fields.push_back({"nominal_stress", "Pa", 2});
    return fields;
}

std::string manufactured_law() {
    return "x is the position X in the undeformed body. Law: neo-Hookean, mu = G,\n"
           "W = mu/2 (tr F F^T - dim) - mu ln J + lambda/2 (ln J)^2,  J = det F > 0\n"
           "P = dW/dF = mu (F - F^-T) + lambda ln J F^-T,  stress = P F^T / J (Cauchy),  tension positive\n"
           "body_force is per mass: rho u_tt = Div P + rho body_force. strain = du/dX. Tensors row by row";
}

Range times_up_to(double omega) { return between(0, 1e12 / omega); }

Constants motion_constants(const ElasticConstants& elastic, double c, double omega) {
    return {{"E", elastic.E},           {"nu", elastic.nu}, {"K", elastic.K}, {"G", elastic.G},
            {"lambda", elastic.lambda}, {"M", elastic.M},   {"c", c},         {"omega", omega}};
}

void require_representable(const ElasticConstants& elastic, double rho, double rate, const std::string& where) {
    // Cubes of 1 / det F, at most 1e48, and squares of the rate multiply these.
    const double fastest = std::max(rate, std::sqrt(elastic.M / rho));
    if (elastic.M <= 1e120 && fastest <= 1e75) return;
    throw InputError(where, "M = " + shortest(elastic.M) + " Pa with rho = " + shortest(rho) + " gives rates up to " +
                                shortest(fastest) + "; must be M <= 1e120 and rates <= 1e75");
}

}  // namespace ordo::oracles

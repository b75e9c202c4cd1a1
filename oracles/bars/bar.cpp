#include "oracles/bars/bar.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::oracles::bars {

void require_waves(double L, double E, double rho, const std::string& where) {
    const double c = std::sqrt(E / rho);
    if (std::isnormal(c) && std::isnormal(L / c) && std::isnormal(c / L)) return;
    throw InputError(where, "E = " + shortest(E) + ", rho = " + shortest(rho) + ", L = " + shortest(L) +
                                ": the wave speed sqrt(E / rho) or the transit time is out of the range of numbers");
}

void require_finite(double value, const std::string& what, const std::string& where) {
    if (std::isfinite(value)) return;
    throw InputError(where, what + " is out of the range of numbers; choose smaller data");
}

Feature front_feature(const std::string& field, double x, int derivative) {
    return {Feature::Kind::linear, x, field == "displacement" ? derivative : derivative - 1};
}

}  // namespace ordo::oracles::bars

#include "solvers/materials/law.hpp"

#include <stdexcept>

namespace ordo::solvers {

static_assert(IncrementLaw<LogarithmicLaw, 1> && IncrementLaw<ReciprocalLaw, 2> && IncrementLaw<NominalLaw, 3>);

Parameter law_parameter(const std::string& fallback) {
    return word("law", fallback,
                {{"E ln F", "increment E d eps; logarithmic; linear waves only up to O(strain^2)"},
                 {"E(1-1/F)", "increment (E - sigma) d eps; linear waves only up to O(strain^2)"},
                 {"E(F-1)", "increment (E + sigma) d eps; nominal stress linear in F: linear waves at any strain"}},
                "constitutive law, named by what its increments integrate to in 1D");
}

Law make_law(const std::string& name, Moduli moduli) {
    if (name == "E ln F") return LogarithmicLaw{moduli};
    if (name == "E(1-1/F)") return ReciprocalLaw{moduli};
    if (name == "E(F-1)") return NominalLaw{moduli};
    throw std::logic_error("no law named '" + name + "'");
}

}  // namespace ordo::solvers

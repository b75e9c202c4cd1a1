#include "solvers/materials/law.hpp"

#include <stdexcept>

namespace ordo::solvers {

static_assert(IncrementLaw<LogarithmicLaw, 1> && IncrementLaw<ReciprocalLaw, 2> && IncrementLaw<NominalLaw, 3>);
static_assert(ClosedLaw<NominalLaw, 1> && !ClosedLaw<NominalLaw, 2> && ClosedLaw<NeoHookeanLaw, 2>);
static_assert(ClosedLaw<HenckyLaw, 3> && HistoryLaw<J2Law, 1> && HistoryLaw<J2Law, 3>);

Parameter law_parameter(const std::string& fallback) {
    return word("law", fallback,
                {{"E ln F", "increment E d eps; logarithmic; linear waves only up to O(strain^2)"},
                 {"E(1-1/F)", "increment (E - sigma) d eps; linear waves only up to O(strain^2)"},
                 {"E(F-1)", "increment (E + sigma) d eps; nominal stress linear in F: linear waves at any strain"},
                 {"E ln F / F", "Hencky: Kirchhoff stress E ln F; from F"},
                 {"E(F-1/F)/2", "neo-Hookean; from F"}},
                "constitutive law, named by its nominal stress in 1D");
}

Law make_law(const std::string& name, Moduli moduli) {
    if (name == "E ln F") return LogarithmicLaw{moduli};
    if (name == "E(1-1/F)") return ReciprocalLaw{moduli};
    if (name == "E(F-1)") return NominalLaw{moduli};
    if (name == "E ln F / F") return HenckyLaw{moduli};
    if (name == "E(F-1/F)/2") return NeoHookeanLaw{moduli};
    throw std::logic_error("no law named '" + name + "'");
}

}  // namespace ordo::solvers

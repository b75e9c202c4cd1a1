#pragma once
// States of a body at which basis functions are tried: shifted by 0 to 1 cell, stretched to half and to twice its
// length.
#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "core/text.hpp"
#include "solvers/mpm/basis/particle_basis.hpp"

namespace ordo::lineups {

using solvers::mpm::Basis;
using solvers::mpm::Lineup;

inline constexpr std::array every_basis{Basis::linear, Basis::quadratic, Basis::cubic, Basis::quartic, Basis::ugimp,
                                        Basis::cpgimp, Basis::cpdi,      Basis::cpdi2, Basis::ddmp};

inline Lineup with(Basis basis, Lineup lineup) {
    lineup.basis = basis;
    return lineup;
}

/// visit(lineup) for each density, shifts on and off the nodes, and stretches. The body has 8 cells, 4 when halved.
template <class Visit>
void for_every_state(const std::vector<double>& densities, Visit&& visit) {
    for (const double ppc : densities) {
        for (const double translate : {0.0, 0.1, 0.25, 0.37, 0.5, 0.75, 0.99, 1.0}) {
            for (const double stretch : {0.5, 0.75, 1.0, 1.25, 1.5, 2.0})
                visit(Lineup{.cells = 20, .margin = 6, .ppc = ppc, .translate = translate, .stretch = stretch});
        }
    }
}

inline std::string text_of(const Lineup& l) {
    return "basis " + std::to_string(static_cast<int>(l.basis)) + ", ppc " + shortest(l.ppc) + ", translate " +
           shortest(l.translate) + ", stretch " + shortest(l.stretch);
}

}  // namespace ordo::lineups

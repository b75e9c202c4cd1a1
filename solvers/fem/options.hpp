#pragma once
// The choices of the finite-element bar, each named as in the literature; declared once, in options.cpp.
#include <vector>

#include "core/parameter.hpp"
#include "solvers/scene.hpp"

namespace ordo::solvers::fem {

/// How the method discretises; plain values, chosen between the passes of a step.
struct Options {
    bool lumped = true;              ///< mass on the diagonal; otherwise consistent
    bool leapfrog = true;            ///< the first kick is dt/2; otherwise symplectic Euler
    bool body_force_lumped = false;  ///< taken at the nodes; otherwise by two Gauss points an element
    bool at_centres = false;         ///< where a snapshot's points are; otherwise at the nodes
    bool skip_quiet = true;          ///< nodes at rest without force; not declared: the bits are the same
};

/// How finely: equal elements, their undeformed width h [m], and the step [s].
struct Resolution {
    int cells = 1;
    double h = 1;
    double dt = 0;
};

std::vector<Parameter> option_parameters();
std::vector<Parameter> resolution_parameters();

Options options_from(const Values& values);

/// Throws InputError unless exactly one of dt and courant is given.
Resolution resolution_from(const SolidScene<1>& scene, const Values& values);

}  // namespace ordo::solvers::fem

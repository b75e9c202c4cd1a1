#pragma once
// A free body under a constant force per mass: what any solver must do exactly.
#include "oracles/oracle.hpp"

namespace ordo::oracles {

/// Rigid translation of an unstressed body in 1, 2 or 3 dimensions.
///
///   u(X, t) = v0 t e_x + g t^2 / 2 e_last,   v = v0 e_x + g t e_last,   stress = strain = 0
///
/// X        position in the body at t = 0 [m]; nothing depends on it      t   time [s]
/// accurate 1 ulp (gate: tests/oracles/free_flight_test.cpp)      source   [Newton1687]
struct FreeFlight {
    int dim = 1;
    double v0 = 1;  ///< velocity along the first axis at t = 0 [m/s]
    double g = -1;  ///< force per mass along the last axis [m/s^2]

    double displacement(int axis, double t) const;  ///< [m]
    double velocity(int axis, double t) const;      ///< [m/s]
};

Oracle free_flight();

}  // namespace ordo::oracles

#pragma once
// The blast of linear elasticity: a crushed slug is let go.
#include "oracles/oracle.hpp"
#include "oracles/riemann/elastic_line.hpp"

namespace ordo::oracles {

/// Heat exerts no stress in the linear law, so a point release of heat moves nothing. What blasts is strain: a slug of
/// reference length L0, held at the stretch lambda_c < 1 around x = 0 in a relaxed line, is released at t = 0. By
/// d'Alembert, with c0 = sqrt(E / rho0), t0 = L0 / (2 c0), E0 = E (1 - lambda_c)^2 L0 / 2:
///
///   released band:  lambda = (1 + lambda_c) / 2,  |v| = c0 (1 - lambda_c) / 2, outwards; its front at
///                   |x| = lambda_c L0 / 2 + c0 t
///   t < t0:         its rear at |x| = lambda_c (L0 / 2 - c0 t); the core within still has lambda_c, v = 0
///   t > t0:         two pulses with their rears at |x| = c0 t - L0 / 2, each with E0 / 2, half of it kinetic; between
///                   them the line is relaxed and at rest
///
/// x        position in space [m];   t >= 0   time [s];   any 0 < lambda_c <= 1, any t
/// accurate 4 ulp of c0 and Z c0; places 4 ulp of L0 + c0 t  (gate: tests/oracles/blasts/sedov_linear_elastic_test.cpp)
/// source   the linear law and the finite work of crushing it [Walker2017]
struct SedovLinearElastic {
    double L0 = 1;          ///< reference length of the slug [m]
    double lambda_c = 0.1;  ///< its stretch before t = 0
    double E = 1;           ///< Young's modulus [Pa]
    double rho0 = 1;        ///< density where lambda = 1 [kg/m^3]
    double c_v = 1;         ///< heat capacity per reference volume [J/(m^3 K)]
    double T = 0;           ///< temperature, of everything and for ever [K]

    double wave_speed() const;      ///< c0 [m/s]
    double energy() const;          ///< E0, per cross-section [J/m^2]
    double splitting_time() const;  ///< t0 [s]
    double front(double t) const;   ///< of the released band on the right [m]
    double rear(double t) const;    ///< of the released band on the right [m]
    ElasticLine line() const;       ///< which gives all fields
};

Oracle sedov_linear_elastic();

}  // namespace ordo::oracles

#pragma once
// Plastic flow while the principal stresses rest and their axes spin: no radial return is exact here.
#include <array>

#include "oracles/oracle.hpp"

namespace ordo::oracles {

/// Perfect von Mises plasticity, small strain: the strain that makes the principal axes of the stress turn about e3.
///
///   stress  = R(theta) (diag(s1, s2, s3) - pressure I) R(theta)^T,   theta = spin t
///   s1 + s2 + s3 = 0 on the yield surface: s3 = 2 Y0 share / 3,  s1, s2 = -s3 / 2 +- Y0 sqrt((1 - share^2) / 3)
///   strain  = elastic + plastic,  elastic = dev(stress) / (2 G) - pressure / (3 K) I
///   plastic = 3 plastic_rate / (2 Y0) (integral of dev(stress) dt from 0)
///
/// The deviator turns, so that its rate is orthogonal to it and the yield function stays zero for any plastic rate >=
/// 0: given this strain, the stress is the one solution of the flow rule from the state at t = 0, which is at yield.
///
/// accurate stress 4 ulp of Y0 + |pressure|, strain 4 ulp of Y0 / G + |pressure| / K + plastic_rate t, both times
///          1 + |spin| t  (gate: tests/oracles/plasticity/j2_rotating_stress_test.cpp)
/// source   after example 1 of [BrannonLeelavanichkul2010]; formula our own
struct J2RotatingStress {
    double K = 5e11 / 3;         ///< bulk modulus [Pa]
    double G = 1e12 / 13;        ///< shear modulus [Pa]
    double Y0 = 4e8;             ///< yield stress in tension [Pa]
    double spin = 1;             ///< angular velocity of the principal axes [rad/s]
    double plastic_rate = 0.01;  ///< d (equivalent plastic strain) / dt, >= 0 [1/s]
    double share = 0;            ///< of s3 in the deviator, in [-1, 1]: 0 is pure shear in the plane [-]
    double pressure = 0;         ///< [Pa], compression positive

    using Tensor = std::array<double, 9>;  ///< row by row
    Tensor stress(double t) const;         ///< [Pa]
    Tensor strain(double t) const;         ///< [-]
};

Oracle j2_rotating_stress();

}  // namespace ordo::oracles

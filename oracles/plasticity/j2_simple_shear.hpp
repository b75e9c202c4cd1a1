#pragma once
// A von Mises solid in simple shear: a thin-walled tube in torsion.
#include "oracles/oracle.hpp"
#include "oracles/plasticity/scalar_j2.hpp"

namespace ordo::oracles {

/// Small shear strain gamma = du_x/dy; von Mises yield, linear isotropic hardening, unloading and reverse loading.
///
///   q = sqrt(3) |tau| <= Y = Y0 + H p
///   first loading: elastic, tau = G gamma, to gamma_y = Y0 / (sqrt(3) G), then p = (sqrt(3) G gamma - Y0) / (3 G + H)
///   after a reversal: elastic over 2 |tau| / G; then plastic, slope G H / (3 G + H)
///
/// accurate 8 ulp of (Y0 + G s) in stress and of s in strain, s = |rate| t the strain travelled
///          (gate: tests/oracles/plasticity/j2_test.cpp)      source   [SimoHughes1998]
struct J2SimpleShear {
    double G = 1e12 / 13;  ///< shear modulus [Pa]
    double Y0 = 4e8;       ///< initial yield stress in tension, sqrt(3) times that in shear [Pa]
    double H = 0;          ///< hardening modulus [Pa]
    StrainPath path{};

    struct State {
        double strain;             ///< gamma, twice the tensor component [-]
        double stress;             ///< tau [Pa]
        double plastic_strain;     ///< p, equivalent, accumulated [-]
        double yield_stress;       ///< Y0 + H p [Pa]
        double equivalent_stress;  ///< von Mises, sqrt(3) |tau| [Pa]
        double plastic_work;       ///< [J/m^3]
        double elastic_energy;     ///< [J/m^3]
    };
    State at(double t) const;

    double yield_strain() const;   ///< Y0 / (sqrt(3) G) [-]
    double plastic_slope() const;  ///< d stress / d strain; it is G while elastic [Pa]
};

Oracle j2_simple_shear();

}  // namespace ordo::oracles

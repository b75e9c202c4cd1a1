#pragma once
// A von Mises solid that is strained along one axis and held at its sides: the state of a planar shock.
#include "oracles/oracle.hpp"
#include "oracles/plasticity/scalar_j2.hpp"

namespace ordo::oracles {

/// Small axial strain eps, none sideways; von Mises yield, linear isotropic hardening, unloading and reverse loading.
///
///   axial = K eps + 2 q / 3,   lateral = K eps - q / 3,   q = axial - lateral of either sign, |q| <= Y = Y0 + H p
///   first loading: elastic to eps_y = Y0 / (2 G), then p = (2 G eps - Y0) / (3 G + H), q = Y
///   after a reversal: elastic, slope K + 4 G / 3, over |q| / G; then plastic, slope K + 4 G H / (9 G + 3 H)
///
/// accurate 8 ulp of (Y0 + M s) in stress and of s in strain, s = |rate| t the strain travelled, M = K + 4 G / 3
///          (gate: tests/oracles/plasticity/j2_test.cpp)      source   [SimoHughes1998]
struct J2UniaxialStrain {
    double K = 5e11 / 3;   ///< bulk modulus [Pa]
    double G = 1e12 / 13;  ///< shear modulus [Pa]
    double Y0 = 4e8;       ///< initial yield stress in tension [Pa]
    double H = 0;          ///< hardening modulus [Pa]
    StrainPath path{};

    struct State {
        double strain;             ///< axial [-]
        double stress;             ///< axial [Pa]
        double lateral_stress;     ///< [Pa]
        double plastic_strain;     ///< p, equivalent, accumulated [-]
        double yield_stress;       ///< Y0 + H p [Pa]
        double equivalent_stress;  ///< von Mises, >= 0 [Pa]
        double plastic_work;       ///< [J/m^3]
        double elastic_energy;     ///< [J/m^3]
    };
    State at(double t) const;

    double yield_strain() const;   ///< Y0 / (2 G) [-]
    double elastic_slope() const;  ///< d stress / d strain [Pa]
    double plastic_slope() const;
};

Oracle j2_uniaxial_strain();

}  // namespace ordo::oracles

#pragma once
// The state between the two outer waves of a Riemann problem of gases.
#include "oracles/riemann/gas_side.hpp"

namespace ordo::oracles {

/// Pressure and velocity that both gases share at their contact: the root p* of
///
///   F(p*) = f_L(p*) + f_R(p*) + v_R - v_L = 0,        v* = v_L - f_L = v_R + f_R
///
/// F rises; it is concave in p and convex in ln(p + p_inf), so Newton's steps come from one side. Two fans in one kind
/// of gas have a closed form, and so has its use as a start elsewhere; the unknown is the distance from the nearest
/// pressure given, or the logarithm, so that neither a weak wave nor a strong fan loses digits.
/// A vacuum opens where F > 0 at the lowest pressure p_void = max(-p_inf_L, -p_inf_R) that both gases can bear; an
/// empty side is one from the start, with p_void its pressure.
/// Accurate to 1e-13 of p* and of |v_L| + |v_R| + a_L + a_R. Near a vacuum p* is the answer to data that differ from
/// those given by less than 1e-14.
struct GasStar {
    bool vacuum = false;              ///< nothing between the gases, at pressure p; v is then not used
    double p = 0;                     ///< p* [Pa]
    double v = 0;                     ///< v* [m/s]
    GasSide::Behind left{}, right{};  ///< each gas at its inner edge
};

GasStar star_between(const GasSide& left, const GasSide& right);

}  // namespace ordo::oracles

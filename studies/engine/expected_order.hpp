#pragma once
// The order of accuracy that theory expects of an error: from the method's own order and what is not smooth.
#include <string>
#include <vector>

#include "oracles/oracle.hpp"
#include "studies/engine/study.hpp"

namespace ordo::studies {

/// What a method claims, as far as the rule asks for it; features by their words, "shock" or "contact".
struct Method {
    double order = 0;                     ///< formal order p, of smooth solutions
    double waves = 0;                     ///< order q of the speed of waves; 0: p
    bool rings = false;                   ///< its errors run out as oscillations
    std::vector<std::string> sharp = {};  ///< features that it does not smear at all
    std::vector<std::string> steep = {};  ///< features that it keeps a few cells wide; shocks always
};

/// An order and what it follows from, "contact, l1, formal order 2"; or why theory has none.
struct ExpectedOrder {
    double order = 0;
    std::string theory = {};
    std::string refused = {};
};

/// The order of an error in one field. Where derivative k of the field jumps, a method smears it over a width
/// w ~ h^s and is off by w^k there, so that the error in L_q goes as w^(k + 1/q):
///
///   order = min(p, s (k + 1/q)),   1/q = 1 in l1, 1/2 in l2 and rms, 0 in linf
///   s = 1 for shocks, which their own characteristics keep a few cells wide, and for what is `steep`
///   s = q/(q+1) for all else, from u_t + a u_x = C h^q d^(q+1)u/dx^(q+1), which the method solves better
///
/// A contact with q = p: p/(p+1) in l1; a kink or a fan's corner: 2p/(p+1) in l1, at most p. Without a feature, or
/// where all are kept sharp: p. The worst one decides. Of places only that of a shock has an order, 1: it stays within
/// a few cells. Theory has none in linf at a jump, at singular places, for the places of contacts and fans, and for
/// parts of l1 away from waves (behind a shock errors may be of first order or of p, inside a fan what its start left).
///
/// Oscillations reach far beyond the width, which l2 hardly feels but l1 and linf do: there theory has none for a
/// method that rings.
///
/// features   of the field at the time of measuring, inside of what is measured
/// source     [Brenner1975] for jumps of derivative k in linear problems, [BanksAslamRider2008] for contacts and shocks
ExpectedOrder expected_order(Norm norm, const Method& method, const std::vector<oracles::Feature>& features);

/// "shock", "contact", "jump of a linear wave", "kink", "jump in derivative 2", "corner of a fan".
std::string words_of(const oracles::Feature& feature);

}  // namespace ordo::studies

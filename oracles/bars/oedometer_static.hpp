#pragma once
// A column at rest under gravity and a load on its top, at any strain and for five laws.
#include "oracles/oracle.hpp"

namespace ordo::oracles {

/// dP/dX = rho g, P(H) = p0, u(0) = 0: the nominal stress P = p0 - rho g (H - X) is the Cauchy stress too, because the
/// cross-section keeps its area. The law gives the stretch F = exp(theta), and u(X) = int_0^X (F - 1).
///
///   law          theta(p), p = P/E        F                       exists for
///   E(F-1)       log(1 + p)               1 + p                   P > -E
///   E(1-1/F)     -log(1 - p)              1 / (1 - p)             P < E
///   E ln F       p                        exp(p)                  any P
///   E ln F / F   -W0(-p)                  exp(-W0(-p))            P <= E / e   (Kirchhoff stress E ln F; Lambert's W)
///   E(F-1/F)/2   asinh(p)                 p + sqrt(p^2 + 1)       any P        (neo-Hookean)
///
/// The integral is a mean over theta with weight dp/dtheta, which is entire for every law: Gauss-Legendre is exact to
/// round-off, and nothing cancels at small strain.
///
/// X        position in the undeformed column, 0 <= X <= H [m]
/// accurate as if the loads had been changed by 1e-15 (|p0| + rho g H); displacement and strain are so to 1e-14 of
///          their largest value where the law is well-conditioned   (gate:
///          tests/oracles/bars/oedometer_static_test.cpp)
/// source   [MPMtry] (E(1-1/F)), [CoombsAugarde2020] (E ln F / F), [Corless1996] (Lambert's W)
struct OedometerStatic {
    enum class Law { nominal, reciprocal, logarithmic, kirchhoff, neo_hookean };  ///< in the order of the table

    double H = 50;    ///< height before the load [m]
    double E = 1e6;   ///< modulus [Pa]
    double rho = 80;  ///< density before the load [kg/m]
    double g = 10;    ///< gravity, towards -X [m/s^2]
    double p0 = 0;    ///< nominal traction on the top, tension positive [Pa]
    Law law = Law::kirchhoff;

    double stress(double X) const;        ///< P [Pa], tension positive
    double log_stretch(double X) const;   ///< theta = ln F [-]; NaN where the law has no F
    double strain(double X) const;        ///< du/dX = F - 1 [-]
    double displacement(double X) const;  ///< [m]
};

Oracle oedometer_static();

}  // namespace ordo::oracles

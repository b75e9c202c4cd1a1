#pragma once
// A column at rest, fixed at y = 0 and free at y = H, that gravity begins to pull down.
#include "oracles/bars/bar.hpp"

namespace ordo::oracles::bars {

/// The ramp of gravity, r = s^3 (10 - 15 s + 6 s^2) of s = t / T: 0 before, 1 after, twice differentiable at its ends.
/// T = 0 is a sudden step.
struct Ramp {
    double T;  ///< [s]

    double value(double t) const;  ///< r
    double rate(double t) const;   ///< dr/dt [1/s], 0 for T = 0
};

/// The full g from t = 0 on: free fall, which waves from the fixed end take back. With G(s) = g s^2 / 2, 0 for s < 0,
///
///   u = -G(t) + sum_{m >= 0} (-1)^m [ G(t - (2mH + y)/c) + G(t - ((2m+2)H - y)/c) ]
///
/// which has the period 4H/c, is even about 2H/c and a quadratic polynomial on either side of its one front.
struct Fall {
    double H, c, g;

    double front(double t) const;  ///< where u_yy and u_tt jump [m]
    Fields at(double y, double t) const;
};

/// The column under g r(t), by Duhamel's integral of the fall: u = int_0^t r'(s) fall(y, t - s) ds. It is taken piece
/// by piece between the fronts' visits to y, where the integrand is a polynomial, and without differences. A point
/// costs as many pieces as the ramp is long in transits H / c.
class Gravity {
public:
    Gravity(Fall fall, Ramp ramp, double t) : fall_(fall), ramp_(ramp), t_(t) {}

    Fields at(double y) const { return ramp_.T > 0 ? ramped(y) : fall_.at(y, t_); }
    Fields mean(double a, double b) const;  ///< a polynomial between the fronts of the ramp's two ends

private:
    Fields ramped(double y) const;

    Fall fall_;
    Ramp ramp_;
    double t_;
};

}  // namespace ordo::oracles::bars

#pragma once
// A bar at rest, fixed at X = 0, under a nominal traction at X = L: the sums over images, closed in t.
#include "oracles/bars/bar.hpp"

namespace ordo::oracles::bars {

/// With I(s) = (c/E) int_0^s load, 0 for s < 0,
///
///   u(X, t) = sum_{m >= 0} (-1)^m [ I(t - ((2m+1) L - X)/c) - I(t - ((2m+1) L + X)/c) ].
///
/// One front runs to and fro; at it and to its right holds the right state.

/// The load is constant, e E for t > 0. The sum has the period 4 L / c; left of the front the bar is unstressed or at
/// 2 e and at rest, right of it the strain is e and the speed c e. u is continuous.
class StepLoad {
public:
    StepLoad(double L, double c, double e, double t);

    double front() const { return front_; }  ///< infinite at t = 0, when nothing is loaded yet [m]
    Fields at(double X) const { return X >= front_ ? right(X) : left(X); }
    Fields mean(double a, double b) const;

private:
    Fields left(double X) const;
    Fields right(double X) const;

    double L_, c_, e_;
    Transit way_;
    double front_;
};

/// The load is e E sin(omega t). The images pair off to standing waves, whose alternating sum over m is geometric, so
/// that the cost does not grow with t; its quotient sin(M d) / sin(d) takes the distance d to resonance as it is.
/// u and its first derivatives are continuous, the second ones jump at the front.
class SineLoad {
public:
    SineLoad(double L, double c, double e, double omega, double t);

    double front() const { return front_; }  ///< [m]
    Fields at(double X) const { return mean(X, X); }
    Fields mean(double a, double b) const;

private:
    struct Sums {
        double sine, cosine;  ///< sum_{m < M} (-1)^m sin, cos(omega t - (2m+1) theta)
    };
    static Sums alternating(double M, double theta, double transits);
    Fields standing(const Sums& sums, double a, double b) const;
    Fields last_image(double a, double b) const;

    double L_, c_, e_, k_;
    Transit way_;
    double front_;
    double sign_;  ///< of the image without a partner
    Sums left_, right_;
};

}  // namespace ordo::oracles::bars

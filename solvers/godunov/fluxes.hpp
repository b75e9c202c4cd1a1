#pragma once
// Approximate Riemann solvers: what passes the face between two states, and how fast their waves are taken to run.
#include <algorithm>
#include <cmath>
#include <variant>

#include "solvers/media/medium.hpp"

namespace ordo::solvers::godunov {

/// The state on one side of a face.
struct Side {
    Contents q;
    Flow f;
};

/// Bounds of the waves between two states [m/s].
struct Speeds {
    double left;
    double right;
};

/// min and max of v -+ a of both sides.   [Davis1988]
struct Davis {
    template <class M>
    static Speeds between(const M&, const Side& l, const Side& r) {
        return {std::min(l.f.v - l.f.a, r.f.v - r.f.a), std::max(l.f.v + l.f.a, r.f.v + r.f.a)};
    }
};

/// v -+ a of an average weighted by sqrt(rho), with a widened by the difference of the velocities, and no slower than
/// v -+ a of either side.   [Einfeldt1988]
struct Einfeldt {
    template <class M>
    static Speeds between(const M&, const Side& l, const Side& r) {
        const double root = std::sqrt(r.f.rho / l.f.rho);
        const double share = 1 / (1 + root);  // of the left side
        const double dv = r.f.v - l.f.v;
        const double v = share * l.f.v + (1 - share) * r.f.v;
        const double a =
            std::sqrt(share * l.f.a * l.f.a + (1 - share) * r.f.a * r.f.a + 0.5 * share * (1 - share) * dv * dv);
        return {std::min(l.f.v - l.f.a, v - a), std::max(r.f.v + r.f.a, v + a)};
    }
};

/// From an estimate of the pressure between the waves, p* = mean p - mean rho mean a dv / 2: that of a shock where
/// p* > p, v -+ a elsewhere. Of a gas.   [ToroSpruceSpeares1994]
struct PressureBased {
    static Speeds between(const IdealGas& gas, const Side& l, const Side& r) {
        const double impedance = 0.25 * (l.f.rho + r.f.rho) * (l.f.a + r.f.a);
        const double p = 0.5 * (l.f.p + r.f.p) - 0.5 * (r.f.v - l.f.v) * impedance;
        return {l.f.v - wave(gas, l.f, p), r.f.v + wave(gas, r.f, p)};
    }

private:
    static double wave(const IdealGas& gas, const Flow& f, double p) {
        const double rise = std::max(0.0, p - f.p);
        return std::sqrt(f.a * f.a + 0.5 * (gas.gamma + 1) * rise * (1 / f.rho));
    }
};

/// v - a of the left, v + a of the right side. With Hllc this is the linearised solver that matches impedances rho a,
/// which is exact for Hooke's law.   [Toro2009, ch. 9]
struct Acoustic {
    template <class M>
    static Speeds between(const M&, const Side& l, const Side& r) {
        return {l.f.v - l.f.a, r.f.v + r.f.a};
    }
};

/// One state between the two waves.   [Einfeldt1988]
struct Hll {
    static Contents through(const Side& l, const Side& r, const Speeds& s) {
        const double left = std::min(s.left, 0.0);
        const double right = std::max(s.right, 0.0);
        const Contents sum = right * flux(l.q, l.f) - left * flux(r.q, r.f) + (left * right) * (r.q - l.q);
        return (1 / (right - left)) * sum;
    }
};

/// Two states, with the contact between them: its speed v and pressure p + m (v - v_K) follow from the balances of mass
/// and momentum over both waves. F = F_K + S_K (q* - q_K) of the side K that the contact leaves behind, S_K = 0 where
/// both waves run the same way. Both sides are read and one is taken without a branch, so that several faces can be
/// done at a time.   [ToroSpruceSpeares1994]
struct Hllc {
    static Contents through(const Side& l, const Side& r, const Speeds& s) {
        const double m_l = l.f.rho * (s.left - l.f.v);  // mass through the wave
        const double m_r = r.f.rho * (s.right - r.f.v);
        const double v = (r.f.p - l.f.p + m_l * l.f.v - m_r * r.f.v) / (m_l - m_r);
        const double s_l = std::min(s.left, 0.0);
        const double s_r = std::max(s.right, 0.0);
        const bool left = v >= 0;
        const double rho = left ? l.f.rho : r.f.rho;
        const double v_K = left ? l.f.v : r.f.v;
        const double p = left ? l.f.p : r.f.p;
        const double energy = left ? l.q.energy : r.q.energy;
        const double speed = left ? s.left : s.right;
        const double reach = left ? s_l : s_r;
        const double share = reach / (speed - v);
        const double mass = rho * (v - v_K);         // (rho* - rho_K) (speed - v)
        const double p_rise = mass * (speed - v_K);  // p* - p_K
        const double work = (energy + p) * (v - v_K) + p_rise * v;
        return {rho * v_K + mass * share, rho * v_K * v_K + p + mass * speed * share,
                (energy + p) * v_K + work * share};
    }
};

using RiemannSolver = std::variant<Hll, Hllc>;
using SpeedEstimate = std::variant<Davis, Einfeldt, PressureBased, Acoustic>;

/// Whether the estimate is for that medium.
template <class Estimate, class M>
concept Estimates = requires(const M& medium, const Side& side) {
    Estimate::between(medium, side, side);
};

}  // namespace ordo::solvers::godunov

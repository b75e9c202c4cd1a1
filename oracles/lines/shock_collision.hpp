#pragma once
// Three uniform gases: two Riemann problems whose shocks meet, and the third Riemann problem that this begins.
#include <limits>
#include <optional>
#include <vector>

#include "oracles/oracle.hpp"
#include "oracles/riemann/riemann_gas.hpp"

namespace ordo::oracles {

/// At t = 0 the gas `middle` lies between x_L and x_R, `left` and `right` beside it without end. Until the innermost
/// waves meet this is one Riemann problem at x_L beside another at x_R. Where two shocks meet, at t_c and x_c, the two
/// states behind them touch and nothing else is there: a Riemann problem at (x_c, t_c), exact until its outer waves
/// meet what the first two left behind, at t_end. Where any other two waves meet, t_end = t_c.
///
/// x        position in space [m];   t   time, 0 <= t <= t_end [s];   at a jump the state on the right
/// accurate as RiemannGas for each of the three; t_c and places 1e-13 of x_R - x_L and t times the speeds
///          (gate: tests/oracles/lines/shock_collision_test.cpp); throws as RiemannGas, and for x_L >= x_R
/// source   [Walker2012, fig. 41] for the data; [Toro2009, ch. 4] for the Riemann problems
class ShockCollision {
public:
    ShockCollision(const Gas& left, const Gas& middle, const Gas& right, double x_L, double x_R);

    const RiemannGas& from_left() const { return left_; }
    const RiemannGas& from_right() const { return right_; }
    const std::optional<RiemannGas>& after() const { return after_; }  ///< empty where no two shocks meet
    double meeting_time() const { return t_c_; }                       ///< of the innermost waves; may be infinite [s]
    double meeting_place() const { return x_c_; }                      ///< NaN where none meet [m]
    double end_time() const { return t_end_; }

    GasFields at(double x, double t) const;
    GasFields mean(double a, double b, double t) const;  ///< over a < x < b
    std::vector<Wave> waves(double t) const;             ///< contacts between equal gases left out
    std::vector<double> jumps(double t) const;

private:
    /// Left of `left` the first problem tells the state, right of `right` the second, between them the third.
    struct Borders {
        double left, right;
    };
    Borders borders(double t) const;
    bool met(double t) const { return after_ && t > t_c_; }
    void let_shocks_meet(const std::vector<GasWave>& l, const std::vector<GasWave>& r);

    double x_L_, x_R_, gamma_;
    RiemannGas left_, right_;
    std::optional<RiemannGas> after_;
    double inner_ = -std::numeric_limits<double>::infinity();  ///< speed of the left problem's innermost wave [m/s]
    Borders outer_{};                                          ///< speeds of the third problem's outer waves [m/s]
    double t_c_ = std::numeric_limits<double>::infinity();
    double x_c_ = std::numeric_limits<double>::quiet_NaN();
    double t_end_ = std::numeric_limits<double>::infinity();
};

Oracle shock_collision();

}  // namespace ordo::oracles

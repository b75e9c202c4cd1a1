#pragma once
// Exact Riemann problem of gas dynamics: two uniform gases, ideal or stiffened, that touch at t = 0.
#include <array>
#include <vector>

#include "oracles/oracle.hpp"
#include "oracles/riemann/gas_fan.hpp"
#include "oracles/riemann/gas_star.hpp"

namespace ordo::oracles {

/// One of the waves of a Riemann problem. A fan spreads from its head, next to the undisturbed gas, to its tail; of a
/// vacuum between two gases head is the left edge and tail the right one; elsewhere both are the one speed.
struct GasWave {
    enum class Kind { shock, rarefaction, contact, vacuum };
    enum class Side { left, middle, right };

    Kind kind;
    Side side;
    double head;  ///< [m/s]
    double tail;  ///< [m/s]

    bool spread() const { return kind == Kind::rarefaction || (kind == Kind::vacuum && side == Side::middle); }
};

/// rho_t + (rho v)_x = 0,  (rho v)_t + (rho v^2 + p)_x = 0,  (rho e + rho v^2 / 2)_t + ((rho e + rho v^2 / 2 + p) v)_x
/// = 0 with p = (gamma - 1) rho e - gamma p_inf, each gas with its own gamma and p_inf. Everything depends on (x - x0)
/// / t:
///
///   const RiemannGas sod({.rho = 1, .p = 1}, {.rho = 0.125, .p = 0.1});
///   sod.star().p;  sod.at(0.5, 0.2).density;  sod.mean(0.4, 0.6, 0.2).momentum;
///
/// x        position in space [m]      t   time, t >= 0 (t = 0: the data) [s]
/// at a wave's own place the state to its right holds
/// accurate star state: see GasStar; fields there and beside it to 1e-13 of the larger of the data and the star state,
///          in fans for data that differ by 1e-14 (gate: tests/oracles/riemann/riemann_gas_test.cpp)
/// throws   InputError for gamma <= 1, rho < 0, p + p_inf < 0, an empty side that is under pressure, and for states
/// that
///          no double can hold
/// source   [Toro2009, ch. 4]; stiffened gases [MenikoffPlohr1989]
class RiemannGas {
public:
    RiemannGas(const Gas& left, const Gas& right, double x0 = 0);

    const GasStar& star() const { return star_; }
    GasFields at(double x, double t) const;
    GasFields mean(double a, double b, double t) const;  ///< over a < x < b
    std::vector<GasWave> waves() const;                  ///< from left to right, those of no strength left out
    std::vector<double> jumps(double t) const;           ///< where the density or another field jumps at t [m]
    double position(double speed, double t) const;       ///< of what left x0 at t = 0 [m]

private:
    /// From left to right: left gas, left fan, left star state, nothing, right star state, right fan, right gas.
    static constexpr int regions = 7;
    std::array<double, regions - 1> positions(double t) const;
    double left_depth(double x, double t) const;  // behind the head of a fan
    double right_depth(double x, double t) const;
    GasFields mean_within(int region, double a, double b, double t) const;
    void require_finite() const;

    GasSide left_, right_;
    double x0_;
    GasStar star_;
    std::array<double, regions - 1> speeds_;  ///< of the regions' borders, rising
    std::array<GasFields, regions> fields_;   ///< of the uniform regions
};

Oracle riemann_gas();

}  // namespace ordo::oracles

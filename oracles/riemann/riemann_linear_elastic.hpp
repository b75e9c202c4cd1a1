#pragma once
// The Riemann problem of linear elasticity with heat, in closed form.
#include <array>
#include <vector>

#include "oracles/oracle.hpp"
#include "oracles/riemann/elastic_laws.hpp"
#include "oracles/riemann/elastic_state.hpp"

namespace ordo::oracles {

/// Two uniform states of a linear elastic line that meet at x0 at t = 0, sigma = E (lambda - 1):
///
///   c0 = sqrt(E / rho0),   Z = sqrt(E rho0)
///   lambda* = (lambda_L + lambda_R) / 2 + (v_R - v_L) / (2 c0),   v* = (v_L + v_R) / 2 + c0 (lambda_R - lambda_L) / 2
///   jumps at x - x0 = (v_L - c0 lambda_L) t,  v* t,  (v_R + c0 lambda_R) t;   T*_L = T_L,  T*_R = T_R
///
/// Heat exerts no stress and T travels with the material; nothing dissipates. Holds while lambda* > 0.
///
/// x        position in space [m];   t   time [s];   at a jump the state on the right
/// accurate 4 ulp of |v_L| + |v_R| + c0 (lambda_L + lambda_R), and of Z times that for stress
///          (gate: tests/oracles/riemann/riemann_linear_elastic_test.cpp)
/// source   equations [Walker2017]; the solution by characteristics
class RiemannLinearElastic {
public:
    using LinearElastic = elastic::Material<elastic::Linear, elastic::PowerHeat>;

    /// Throws InputError where the material would be crushed to zero length: v_L - v_R >= c0 (lambda_L + lambda_R).
    RiemannLinearElastic(double E, double rho0, double c_v, const elastic::State& left, const elastic::State& right,
                         double x0 = 0);

    double lambda_star() const { return lambda_; }
    double sigma_star() const { return sigma_; }
    double v_star() const { return speeds_[1]; }
    const std::array<double, 3>& speeds() const { return speeds_; }  ///< left wave, contact, right wave [m/s]

    elastic::Row fields(double x, double t) const;              ///< elastic::fields()
    elastic::Row averages(double a, double b, double t) const;  ///< over a < x < b
    std::vector<double> jumps(double t) const;                  ///< where a field jumps
    std::vector<Wave> waves(double t) const;  ///< the same with their kinds; both acoustic ones: shocks
    Constants constants(std::optional<double> t) const;

private:
    bool jumps_at(std::size_t wave) const { return rows_[wave] != rows_[wave + 1]; }

    double rho0_;
    double x0_;
    double lambda_;
    double sigma_;
    std::array<double, 3> speeds_;
    std::array<elastic::Row, 4> rows_;  ///< left, left star, right star, right
};

Oracle riemann_linear_elastic();

}  // namespace ordo::oracles

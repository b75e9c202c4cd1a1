#pragma once
// The blast's similarity profiles by integrating their differential equations: the second route to similarity.hpp.
#include <array>

#include "oracles/numerics/ode.hpp"

namespace ordo::oracles {

/// The Euler equations for u = U y w, rho = rho_ahead g, p = rho_ahead U^2 h, functions of y = r / r_shock alone:
///
///   with H = h / (g y^2), a = 1 - n / 2, n = j + 2 - omega, and derivatives by ln y
///   (ln g)' = ( -a w - (w - 1) b1 - H b3 / (w - 1) ) / ( gamma H - (w - 1)^2 )
///   w'      = b1 - w - (w - 1) (ln g)',      (ln h)' = b3 / (w - 1) + gamma (ln g)'
///   b1 = omega - (j - 1) w,   b3 = omega (1 - gamma) - 2a
///   y = 1: w = 2 / (gamma + 1), g = (gamma + 1) / (gamma - 1), h = 2 / (gamma + 1)
///
/// from the shock inwards, with the integrals J1 and J2 beside them, by steps of rk8pd. No exponent, no special case.
/// accurate some 1e-15 lambda^-j, relative: inwards an error of w grows like that, and faster near the singular case;
/// in a
///          vacuum case down to near the edge of the core, where w = 1
/// source   [Sedov1959]
class SimilarityOde {
public:
    struct State {
        double velocity, density, pressure;  ///< relative to those behind the shock
        double J1, J2;                       ///< of the shell from lambda to the shock
    };

    /// j = 1, 2, 3; gamma > 1; omega < j.
    SimilarityOde(int j, double gamma, double omega);

    /// Goes on to lambda, which must not be larger than the last one. NaN when no step leads there.
    State inwards_to(double lambda);

    SimilarityOde(const SimilarityOde&) = delete;  // the steps hold its address
    SimilarityOde& operator=(const SimilarityOde&) = delete;

private:
    struct Slopes {
        int j;
        double gamma, omega;
        void operator()(double log_y, const double* state, double* slopes) const;
    };
    Slopes slopes_;
    std::array<double, 5> start_;
    std::array<double, 5> state_;  ///< w, ln g, ln h, integrals of g w^2 y^(j+1) dy and of h y^(j-1) dy
    double log_y_ = 0;
    Ode steps_;
};

}  // namespace ordo::oracles

#pragma once
// The compressible neo-Hookean law along principal directions that the motion keeps.
#include "core/elastic_constants.hpp"

namespace ordo::oracles {

/// W = mu/2 (tr F F^T - dim) - mu ln J + lambda/2 (ln J)^2. All in H = F - 1 [-], the strain along one direction, so
/// that small strains keep their digits.
struct NeoHookean {
    double lambda;  ///< [Pa]
    double mu;      ///< [Pa]

    explicit NeoHookean(const ElasticConstants& elastic) : lambda(elastic.lambda), mu(elastic.G) {}

    /// Kirchhoff stress lambda ln J + mu (F^2 - 1) [Pa]; P = this / F, Cauchy stress = this / J.
    double kirchhoff(double H, double ln_J) const { return lambda * ln_J + mu * H * (2 + H); }

    /// dP/dF of one direction at fixed other stretches, less its value M = lambda + 2 mu without strain [Pa]:
    /// mu (1 + 1/F^2) + lambda (1 - ln J) / F^2 - M.
    double hardening(double H, double ln_J) const {
        return -((lambda + mu) * H * (2 + H) + lambda * ln_J) / ((1 + H) * (1 + H));
    }
};

/// M - E [Pa], exactly 0 without Poisson's effect.
inline double wave_excess(const ElasticConstants& elastic) { return 2 * elastic.nu * elastic.lambda; }

}  // namespace ordo::oracles

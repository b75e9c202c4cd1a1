#pragma once
// Constitutive laws: one value struct each. A law turns a strain increment into new stress; a kernel calls it inlined.
#include <Eigen/Core>
#include <concepts>
#include <string>
#include <variant>
#include <vector>

#include "core/parameter.hpp"

namespace ordo::solvers {

template <int dim>
using Vec = Eigen::Matrix<double, dim, 1>;
template <int dim>
using Tensor = Eigen::Matrix<double, dim, dim>;

/// A law given in increments: the Cauchy stress [Pa] after the displacement increment whose gradient is dL [-].
template <class L, int dim>
concept IncrementLaw = requires(const L law, const Tensor<dim>& sigma, const Tensor<dim>& dL) {
    { law.template updated<dim>(sigma, dL) } -> std::same_as<Tensor<dim>>;
    { law.stiffness() } -> std::convertible_to<double>;
};

/// Isotropic moduli [Pa]; a 1D bar of Young's modulus E has lambda = 0, mu = E/2.
struct Moduli {
    double lambda = 0;
    double mu = 0.5;

    /// C : sym(dL).
    template <int dim>
    Tensor<dim> times(const Tensor<dim>& dL) const {
        return lambda * dL.trace() * Tensor<dim>::Identity() + mu * (dL + dL.transpose());
    }
    double p_wave() const { return lambda + 2 * mu; }  ///< [Pa]; the elastic wave speed is sqrt(p_wave / rho)
};

/// W sigma - sigma W, with W the spin part of dL: what keeps a rate frame-indifferent; zero in 1D.
template <int dim>
Tensor<dim> spin_terms(const Tensor<dim>& sigma, const Tensor<dim>& dL) {
    const Tensor<dim> W = 0.5 * (dL - dL.transpose());
    return W * sigma - sigma * W;
}

/// d sigma = C d eps in the Jaumann rate of the Cauchy stress; in 1D it integrates to sigma = E ln F.   [MPMtry]
struct LogarithmicLaw {
    Moduli C;
    template <int dim>
    Tensor<dim> updated(const Tensor<dim>& sigma, const Tensor<dim>& dL) const {
        return sigma + C.times<dim>(dL) + spin_terms<dim>(sigma, dL);
    }
    double stiffness() const { return C.p_wave(); }
};

/// d sigma = C d eps - sigma tr d eps, the Jaumann rate of the Kirchhoff stress over J; in 1D sigma = E (1 - 1/F).
/// The authors of [MPMtry] call it "deformation = 1".
struct ReciprocalLaw {
    Moduli C;
    template <int dim>
    Tensor<dim> updated(const Tensor<dim>& sigma, const Tensor<dim>& dL) const {
        return sigma + C.times<dim>(dL) + spin_terms<dim>(sigma, dL) - dL.trace() * sigma;
    }
    double stiffness() const { return C.p_wave(); }
};

/// d sigma = C d eps + dL sigma + sigma dL^T - sigma tr d eps, the Truesdell rate; in 1D sigma = P = E (F - 1), whose
/// waves are exactly linear at any strain, so that the series solutions are exact for it.
struct NominalLaw {
    Moduli C;
    template <int dim>
    Tensor<dim> updated(const Tensor<dim>& sigma, const Tensor<dim>& dL) const {
        return sigma + C.times<dim>(dL) + dL * sigma + sigma * dL.transpose() - dL.trace() * sigma;
    }
    double stiffness() const { return C.p_wave(); }
};

using Law = std::variant<LogarithmicLaw, ReciprocalLaw, NominalLaw>;

/// The declared choice of a law by the name its 1D integral has in the literature ("E ln F", "E(1-1/F)", "E(F-1)").
Parameter law_parameter(const std::string& fallback);

/// The law of that name with these moduli. Throws std::logic_error on a name that `law_parameter` does not list.
Law make_law(const std::string& name, Moduli moduli);

}  // namespace ordo::solvers

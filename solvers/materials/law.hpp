#pragma once
// Constitutive laws: one value struct each. A law turns a strain increment, or the deformation gradient, into stress; a
// kernel calls it inlined.
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
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
};

/// A law in closed form: the Cauchy stress [Pa] of the deformation gradient F [-], det F > 0.
template <class L, int dim>
concept ClosedLaw = requires(const L law, const Tensor<dim>& F) {
    { law.template cauchy<dim>(F) } -> std::same_as<Tensor<dim>>;
};

/// A law in increments whose stress depends on a history that each point of the material carries.
template <class L, int dim>
concept HistoryLaw = requires(const L law, typename L::History& history, const Tensor<dim>& dL) {
    { law.template updated<dim>(history, dL) } -> std::same_as<Tensor<dim>>;
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

/// sigma turned by the rotation of the increment, R = (I - W/2)^-1 (I + W/2) with W the spin part of dL: what keeps a
/// rate frame-indifferent, to any angle where dL is taken amid the increment; the identity in 1D.   [HughesWinget1980]
template <int dim>
Tensor<dim> turned(const Tensor<dim>& sigma, const Tensor<dim>& dL) {
    if constexpr (dim == 1) return sigma;
    const Tensor<dim> I = Tensor<dim>::Identity();
    const Tensor<dim> half = 0.25 * (dL - dL.transpose());
    const Tensor<dim> R = (I - half).inverse() * (I + half);
    return R * sigma * R.transpose();
}

/// d sigma = C d eps in the Jaumann rate of the Cauchy stress; in 1D it integrates to sigma = E ln F.   [MPMtry]
struct LogarithmicLaw {
    Moduli C;
    template <int dim>
    Tensor<dim> updated(const Tensor<dim>& sigma, const Tensor<dim>& dL) const {
        return turned<dim>(sigma, dL) + C.times<dim>(dL);
    }
    template <int dim>
    requires(dim == 1)  // the rate has no integral in more dimensions
        Tensor<dim> cauchy(const Tensor<dim>& F)
    const { return Tensor<1>(C.p_wave() * std::log(F(0, 0))); }
    double stiffness() const { return C.p_wave(); }
};

/// d sigma = C d eps - sigma tr d eps, the Jaumann rate of the Kirchhoff stress over J; in 1D sigma = E (1 - 1/F).
/// The authors of [MPMtry] call it "deformation = 1".
struct ReciprocalLaw {
    Moduli C;
    template <int dim>
    Tensor<dim> updated(const Tensor<dim>& sigma, const Tensor<dim>& dL) const {
        return turned<dim>(sigma, dL) + C.times<dim>(dL) - dL.trace() * sigma;
    }
    template <int dim>
    requires(dim == 1)  // the rate has no integral in more dimensions
        Tensor<dim> cauchy(const Tensor<dim>& F)
    const { return Tensor<1>(C.p_wave() * (1 - 1 / F(0, 0))); }
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
    template <int dim>
    requires(dim == 1)  // the rate has no integral in more dimensions
        Tensor<dim> cauchy(const Tensor<dim>& F)
    const { return Tensor<1>(C.p_wave() * (F(0, 0) - 1)); }
    double stiffness() const { return C.p_wave(); }
};

/// Neo-Hookean: sigma = (lambda ln J I + mu (F F^T - I)) / J; in 1D with lambda = 0, P = (E/2)(F - 1/F).
/// [BonetWood2008]
struct NeoHookeanLaw {
    Moduli C;
    template <int dim>
    Tensor<dim> cauchy(const Tensor<dim>& F) const {
        const double J = F.determinant();
        const Tensor<dim> I = Tensor<dim>::Identity();
        return (C.lambda * std::log(J) * I + C.mu * (F * F.transpose() - I)) / J;
    }
    double stiffness() const { return C.p_wave(); }
};

/// Hencky: Kirchhoff stress J sigma = C : ln V; in 1D with lambda = 0, P = E ln F / F.   [BonetWood2008]
struct HenckyLaw {
    Moduli C;
    template <int dim>
    Tensor<dim> cauchy(const Tensor<dim>& F) const {
        const Eigen::SelfAdjointEigenSolver<Tensor<dim>> b(F * F.transpose());
        const Vec<dim> ln_V = 0.5 * b.eigenvalues().array().log();
        const Vec<dim> tau = C.lambda * ln_V.sum() * Vec<dim>::Ones() + 2 * C.mu * ln_V;
        return b.eigenvectors() * tau.asDiagonal() * b.eigenvectors().transpose() / F.determinant();
    }
    double stiffness() const { return C.p_wave(); }
};

/// Von Mises plasticity with linear isotropic hardening, radially returned; the Jaumann rate of the Cauchy stress. In
/// 1D the strain is uniaxial, in 2D plane: the stress out of the plane is part of the history.   [SimoHughes1998]
struct J2Law {
    Moduli C;
    double yield = 1;      ///< initial yield stress in tension Y0 [Pa]
    double hardening = 0;  ///< H = dY / d(equivalent plastic strain) >= 0 [Pa]

    struct History {
        Tensor<3> sigma = Tensor<3>::Zero();  ///< [Pa]
        double plastic_strain = 0;            ///< equivalent, accumulated [-]
    };

    template <int dim>
    Tensor<dim> updated(History& history, const Tensor<dim>& dL) const {
        Tensor<3> in_space = Tensor<3>::Zero();
        in_space.topLeftCorner<dim, dim>() = dL;
        const Tensor<3> trial = turned<3>(history.sigma, in_space) + C.times<3>(in_space);
        const Tensor<3> deviator = trial - trial.trace() / 3 * Tensor<3>::Identity();
        const double q = std::sqrt(1.5) * deviator.norm();
        const double excess = q - (yield + hardening * history.plastic_strain);
        history.sigma = trial;
        if (excess > 0) {
            const double dp = excess / (3 * C.mu + hardening);
            history.plastic_strain += dp;
            history.sigma -= 3 * C.mu * dp / q * deviator;
        }
        return history.sigma.topLeftCorner<dim, dim>();
    }
    double stiffness() const { return C.p_wave(); }
};

using Law = std::variant<LogarithmicLaw, ReciprocalLaw, NominalLaw, NeoHookeanLaw, HenckyLaw, J2Law>;

/// Largest P-wave modulus of the undeformed solid [Pa]: its elastic wave speed is sqrt(stiffness / rho).
inline double stiffness(const Law& law) {
    return std::visit([](const auto& kind) { return kind.stiffness(); }, law);
}

/// The declared choice of an elastic law by what its nominal stress is in 1D ("E ln F", "E(1-1/F)", "E(F-1)", ...).
Parameter law_parameter(const std::string& fallback);

/// The law of that name with these moduli. Throws std::logic_error on a name that `law_parameter` does not list.
Law make_law(const std::string& name, Moduli moduli);

}  // namespace ordo::solvers

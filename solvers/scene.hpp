#pragma once
// What a solver is given: the physical problem, in SI or in the dimensionless units its scene states.
#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "solvers/materials/law.hpp"

namespace ordo::solvers {

/// How one face of the body's box is held. `roller` holds the normal component only; in 1D it equals `fixed`.
enum class Face { free, fixed, roller };

/// A vector field over many points at once, so that a kernel pays one call a step and none a particle:
/// out[i] = f(X[i], t), with X the position in the undeformed body [m] and t the time [s].
template <int dim>
using VectorField = std::function<void(std::span<const Vec<dim>> X, double t, std::span<Vec<dim>> out)>;

/// An elastic body that fills the box [lower, upper] at t = 0, stress-free, with its law, faces and loads.
/// Optional members are capabilities: what a scene lacks costs a solver nothing.
template <int dim>
struct SolidScene {
    Vec<dim> lower = Vec<dim>::Zero();             ///< [m]
    Vec<dim> upper = Vec<dim>::Ones();             ///< [m]
    double rho = 1;                                ///< density at t = 0 [kg/m^dim]
    Law law;                                       ///< constitutive law with its moduli
    std::array<std::array<Face, 2>, dim> faces{};  ///< faces[axis][0 lower, 1 upper]
    VectorField<dim> velocity;                     ///< at t = 0 [m/s]
    std::optional<VectorField<dim>> body_force;    ///< per unit mass [m/s^2]
};

/// Every kind of problem there is. A solver accepts some kinds and says so.
using Scene = std::variant<SolidScene<1>, SolidScene<2>, SolidScene<3>>;

/// Space dimension of a scene.
inline int dimension(const Scene& scene) { return static_cast<int>(scene.index()) + 1; }

}  // namespace ordo::solvers

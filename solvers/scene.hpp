#pragma once
// What a solver is given: the physical problem, in SI or in the dimensionless units its scene states.
#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

#include "solvers/materials/law.hpp"
#include "solvers/media/line.hpp"

namespace ordo::solvers {

/// How one face of the body's box is held. `roller` holds the normal component only; in 1D it equals `fixed`. Where one
/// is `periodic` so is the face across, and the body goes on there.
enum class Face { free, fixed, roller, periodic };

/// A vector field over many points at once, so that a kernel pays one call a step and none a particle:
/// out[i] = f(X[i], t), with X the position in the undeformed body [m] and t the time [s].
template <int dim>
using VectorField = std::function<void(std::span<const Vec<dim>> X, double t, std::span<Vec<dim>> out)>;

/// The same for a tensor field.
template <int dim>
using TensorField = std::function<void(std::span<const Vec<dim>> X, double t, std::span<Tensor<dim>> out)>;

/// A body that is not at rest in its undeformed shape at t = 0; the stress follows from F.
template <int dim>
struct Deformed {
    VectorField<dim> displacement;  ///< x - X [m]
    TensorField<dim> F;             ///< dx/dX [-]
};

/// A body that fills the box [lower, upper] when undeformed, with its law, faces and loads.
/// Optional members are capabilities: what a scene lacks costs a solver nothing.
template <int dim>
struct SolidScene {
    Vec<dim> lower = Vec<dim>::Zero();                   ///< [m]
    Vec<dim> upper = Vec<dim>::Ones();                   ///< [m]
    double rho = 1;                                      ///< density of the undeformed body [kg/m^dim]
    Law law = {};                                        ///< constitutive law with its moduli
    std::array<std::array<Face, 2>, dim> faces{};        ///< faces[axis][0 lower, 1 upper]
    VectorField<dim> velocity = {};                      ///< at t = 0 [m/s]
    std::optional<Deformed<dim>> deformed = {};          ///< at t = 0; absent: undeformed and stress-free
    std::optional<VectorField<dim>> body_force = {};     ///< per unit mass [m/s^2]
    std::optional<VectorField<dim>> traction = {};       ///< nominal: force on a unit of undeformed free face [Pa]
    std::optional<VectorField<dim>> face_velocity = {};  ///< of held faces, in the directions held [m/s]; absent: rest
    std::optional<double> damping = {};                  ///< alpha of the body force -alpha v per unit mass [1/s]
};

template <int dim>
bool any_face(const SolidScene<dim>& scene, Face kind) {
    for (const auto& pair : scene.faces) {
        if (pair[0] == kind || pair[1] == kind) return true;
    }
    return false;
}

/// An equation f(x) = 0 in one unknown, and where an iteration begins.
struct ScalarEquation {
    std::function<double(double x)> f;
    std::function<double(double x)> slope;  ///< df/dx
    double start = 0;
    double second_start = 0;  ///< for methods that need two points
};

/// Every kind of problem there is. A solver accepts some kinds and says so.
using Scene = std::variant<SolidScene<1>, SolidScene<2>, SolidScene<3>, ScalarEquation, LineScene>;

inline bool is_line(const Scene& scene) { return std::holds_alternative<LineScene>(scene); }
inline bool is_solid(const Scene& scene) { return !is_line(scene) && !std::holds_alternative<ScalarEquation>(scene); }

/// f(solid), with f a function template over the dimension. Throws std::logic_error for a scene of another kind.
template <class F>
auto on_solid(const Scene& scene, F&& f) {
    using Result = decltype(f(std::declval<const SolidScene<1>&>()));
    const auto call = [&](const auto& kind) -> Result {
        if constexpr (requires { f(kind); }) return f(kind);
        else throw std::logic_error("the scene is no solid body");
    };
    return std::visit(call, scene);
}

}  // namespace ordo::solvers

#pragma once
// What all manufactured motions give: a motion x = X + u(X, t) is chosen, a law gives its stress, and the balance of
// momentum the body force that keeps it going.
#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/elastic_constants.hpp"
#include "oracles/oracle.hpp"

namespace ordo::oracles {

/// One material point X at one time. Tensors row by row: component iJ stands at i dim + J.
///
/// strain    du/dX                                   F   dx/dX = I + strain
/// stress    Cauchy, P F^T / det F                   P   nominal (first Piola-Kirchhoff), dW/dF
/// b         body force per mass, u_tt - Div P / rho
template <std::size_t dim>
struct MaterialPoint {
    using Vector = std::array<double, dim>;
    using Tensor = std::array<double, dim * dim>;

    Vector u;       ///< displacement [m]
    Vector v;       ///< velocity [m/s]
    Tensor stress;  ///< [Pa]
    Tensor strain;  ///< [-]
    Vector b;       ///< [m/s^2]
    Tensor F;       ///< [-]
    Tensor P;       ///< [Pa]
};

/// The standard fields, then body_force, deformation_gradient and nominal_stress.
std::vector<FieldInfo> manufactured_fields();

/// Lines for `explanation`: the law and what the fields are.
std::string manufactured_law();

template <std::size_t dim>
void write(const MaterialPoint<dim>& p, std::span<double> values) {
    auto out = values.begin();
    const auto append = [&](const auto& field) { out = std::copy(field.begin(), field.end(), out); };
    append(p.u);
    append(p.v);
    append(p.stress);
    append(p.strain);
    append(p.b);
    append(p.F);
    append(p.P);
}

/// A Sample from a body's at(X, t), X an array of dim coordinates.
template <std::size_t dim, class Body>
Exact::Sample material_points(const Body& body) {
    return pointwise(dim, 3 * dim + 4 * dim * dim,
                     [body](std::span<const double> x, double t, std::span<double> values) {
                         std::array<double, dim> X{};
                         std::copy(x.begin(), x.end(), X.begin());
                         write(body.at(X, t), values);
                     });
}

/// From t = 0 to omega t = 1e12, beyond which a double knows omega t to 1e-4 only.
Range times_up_to(double omega);

/// E nu K G lambda M c omega. Nothing of it changes in time.
Constants motion_constants(const ElasticConstants& elastic, double c, double omega);

/// Throws InputError where numbers differ so much in size that stress or acceleration could pass the largest double.
/// rate  the highest speed over the smallest length that occur [1/s]
void require_representable(const ElasticConstants& elastic, double rho, double rate, const std::string& where);

}  // namespace ordo::oracles

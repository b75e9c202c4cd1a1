#pragma once
// Loads and initial data of one-dimensional scenes, from functions of one point.
#include <concepts>

#include "solvers/scene.hpp"

namespace ordo::studies {

static_assert(std::same_as<solvers::VectorField<1>, solvers::TensorField<1>>);

/// The field out[i] = f(X[i], t) along a line, from a function f(X, t) of one point, X in [m] and t in [s]. It serves a
/// tensor as well as a vector, for both are one number here.
template <class F>
solvers::VectorField<1> along_x(F f) {
    return [f](std::span<const solvers::Vec<1>> X, double t, std::span<solvers::Vec<1>> out) {
        for (std::size_t i = 0; i < X.size(); ++i) out[i][0] = f(X[i][0], t);
    };
}

inline solvers::VectorField<1> at_rest() {
    return along_x([](double, double) { return 0.0; });
}

/// The nominal traction load(t) [Pa], outward positive, on the end X = L of a bar on [0, L], and none on its other end.
/// A solver's end may miss L by round-off; the nearer end counts.
template <class Load>
solvers::VectorField<1> traction_at_end(double L, Load load) {
    return along_x([=](double X, double t) { return X > L / 2 ? load(t) : 0.0; });
}

}  // namespace ordo::studies

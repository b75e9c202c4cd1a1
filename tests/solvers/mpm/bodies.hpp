#pragma once
// Bodies that the MPM tests share, and the way in through the solver's door.
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solvers/mpm/mpm.hpp"

namespace ordo::solvers::mpm::test {

/// The scene's form of a field that is given point by point.
template <int dim, class F>
VectorField<dim> pointwise(F f) {
    return [f](std::span<const Vec<dim>> X, double t, std::span<Vec<dim>> out) {
        for (std::size_t i = 0; i < X.size(); ++i) out[i] = f(X[i], t);
    };
}

template <int dim>
VectorField<dim> uniform(const Vec<dim>& value) {
    return pointwise<dim>([value](const Vec<dim>&, double) { return value; });
}

template <int dim>
std::array<std::array<Face, 2>, dim> all_faces(Face face) {
    std::array<std::array<Face, 2>, dim> faces;
    for (auto& pair : faces) pair = {face, face};
    return faces;
}

/// A box with its lower corner off the origin, so that an index is never mistaken for a position.
template <int dim>
SolidScene<dim> box(const Vec<dim>& edges, Face face, VectorField<dim> velocity) {
    const Vec<dim> lower = Vec<dim>::LinSpaced(dim, -0.3, 0.4);
    return {.lower = lower,
            .upper = lower + edges,
            .rho = 1.3,
            .law = LogarithmicLaw{{.lambda = 0.7, .mu = 0.4}},
            .faces = all_faces<dim>(face),
            .velocity = std::move(velocity),
            .body_force = {}};
}

/// A bar of Young's modulus E that is held at X = 0 and free at X = L, started by the first mode of velocity.
inline SolidScene<1> fixed_free_bar(double L, double rho, double v0, const Law& law) {
    const double k = 2 * std::atan(1.0) / L;
    return {.lower = Vec<1>(0),
            .upper = Vec<1>(L),
            .rho = rho,
            .law = law,
            .faces = {{{Face::fixed, Face::free}}},
            .velocity = pointwise<1>([=](const Vec<1>& X, double) { return Vec<1>(v0 * std::sin(k * X[0])); }),
            .body_force = {}};
}

inline std::unique_ptr<Simulation> started(const Scene& scene, const Given& options, const Given& resolution) {
    const Solver& mpm = solver_named("mpm", "");
    const std::vector<std::string> fields = mpm.fields;
    return mpm.start(scene, resolve(mpm.options, options, "", "solver mpm"),
                     resolve(mpm.resolution, resolution, "", "solver mpm"), fields);
}

inline const Interrupt never = [] { return false; };

inline Options options_of(const Given& given) {
    return options_from(resolve(option_parameters(), given, "", "solver mpm"));
}

/// Point p of a vector or tensor field (tensors are stored row by row).
template <int dim>
Vec<dim> vector_at(const std::vector<double>& values, std::size_t p) {
    return Eigen::Map<const Vec<dim>>(values.data() + p * dim);
}
template <int dim>
Tensor<dim> tensor_at(const std::vector<double>& values, std::size_t p) {
    return Eigen::Map<const Tensor<dim>>(values.data() + p * dim * dim).transpose();
}

inline const std::vector<std::string> stress_updates{"usf", "usl", "musl", "usavg"};

/// When the stress is updated, and how the step is begun or composed (a leapfrog is refused by USF and USAVG).
struct TimeScheme {
    std::string stress_update;
    std::string time;
    bool leaps() const { return time == "leapfrog"; }
    std::string name() const { return stress_update + ", " + time; }
};
inline const std::vector<TimeScheme> time_schemes{{"usf", "symplectic_euler"},  {"usl", "symplectic_euler"},
                                                  {"musl", "symplectic_euler"}, {"usavg", "symplectic_euler"},
                                                  {"usl", "leapfrog"},          {"musl", "leapfrog"},
                                                  {"musl", "yoshida4"}};

/// The number of that name; NaN, which no check passes, where there is none.
inline double figure(const std::vector<Figure>& figures, const std::string& name) {
    for (const auto& figure : figures) {
        if (figure.name == name) return figure.value;
    }
    return std::nan("");
}

template <int dim>
Vec<dim> momentum(const Particles<dim>& p) {
    Vec<dim> sum = Vec<dim>::Zero();
    for (std::size_t i = 0; i < p.size(); ++i) sum += p.m[i] * p.v[i];
    return sum;
}

inline const std::vector<std::string> strain_increments{"undeformed_mesh", "moved_mesh"};

}  // namespace ordo::solvers::mpm::test

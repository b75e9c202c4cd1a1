#pragma once
// Bars that the finite-element tests share, the way in through the solver's door, and how errors are judged.
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solvers/fem/fem.hpp"

namespace ordo::solvers::fem::test {

/// The scene's form of a field f(X, t) that is given point by point.
template <class F>
VectorField<1> field(F f) {
    return [f](std::span<const Vec<1>> X, double t, std::span<Vec<1>> out) {
        for (std::size_t i = 0; i < X.size(); ++i) out[i] = Vec<1>(f(X[i][0], t));
    };
}

template <class F>
Deformed<1> deformed(F displacement) {
    return {.displacement = field(displacement), .F = {}};  // the bar interpolates, and never asks for F
}

constexpr auto nowhere = [](double, double) { return 0.0; };

/// E(F-1): linear waves at any strain, so that the oracles of linear bars are exact for it.
inline Law linear_law(double E) { return NominalLaw{{.lambda = 0, .mu = E / 2}}; }

/// A bar that is held at X = 0 and free at X = L, at rest.
inline SolidScene<1> fixed_free_bar(double L, double rho, const Law& law) {
    return {.lower = Vec<1>(0),
            .upper = Vec<1>(L),
            .rho = rho,
            .law = law,
            .faces = {{{Face::fixed, Face::free}}},
            .velocity = field(nowhere)};
}

/// A bar with two free ends and its lower one off the origin, so that an index is never mistaken for a position.
inline SolidScene<1> free_bar(double L, double rho, const Law& law) {
    auto scene = fixed_free_bar(L, rho, law);
    scene.lower = Vec<1>(-0.3);
    scene.upper = Vec<1>(L - 0.3);
    scene.faces = {{{Face::free, Face::free}}};
    return scene;
}

inline std::unique_ptr<Simulation> started(const Scene& scene, const Given& options, const Given& resolution) {
    static const Solver fem = solver();
    return fem.start(scene, resolve(fem.options, options, "", "solver fem"),
                     resolve(fem.resolution, resolution, "", "solver fem"), fem.fields);
}

inline const Interrupt never = [] { return false; };

inline double figure(const std::vector<Figure>& figures, const std::string& name) {
    for (const auto& figure : figures) {
        if (figure.name == name) return figure.value;
    }
    return std::nan("");
}

/// Errors of one field against exact(X, t) at a snapshot's points; NaN stays NaN.
struct Errors {
    double rms = 0;
    double most = 0;

    template <class Exact>
    Errors(const Snapshot& shot, const std::string& name, Exact exact) {
        const auto& found = shot.field(name).values;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const double error = std::abs(found[i] - exact(shot.X[i], shot.t));
            rms += error * error / static_cast<double>(found.size());
            if (!(error <= most)) most = error;
        }
        rms = std::sqrt(rms);
    }
};

/// Largest distance of a neighbour order from the expected one, to both sides, for h or dt that fall by `ratio`; NaN
/// where an error is no positive number.
inline double order_defect(double expected, std::span<const double> errors, double ratio = 2) {
    double worst = 0;
    for (std::size_t k = 1; k < errors.size(); ++k) {
        const double distance = std::abs(std::log(errors[k - 1] / errors[k]) / std::log(ratio) - expected);
        if (!(distance <= worst)) worst = distance;
    }
    return worst;
}

inline const std::vector<std::string> masses{"lumped", "consistent"};
inline const std::vector<std::string> times{"symplectic_euler", "leapfrog"};
inline const std::vector<std::string> body_forces{"consistent", "lumped"};
inline const std::vector<std::string> samplings{"nodes", "centres"};

/// Angular frequency of the wave sin(k X) on elements of width h, exact in time [1/s].   [Hughes2000]
inline double frequency_on_mesh(const std::string& mass, double k, double h, double c) {
    const double lumped = 2 * c / h * std::sin(k * h / 2);
    return mass == "lumped" ? lumped : lumped * std::sqrt(3 / (2 + std::cos(k * h)));
}

}  // namespace ordo::solvers::fem::test

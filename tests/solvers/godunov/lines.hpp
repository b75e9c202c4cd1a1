#pragma once
// Lines that the tests of the fixed grid share, the way in through the solver's door, and how errors are judged.
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "oracles/riemann/riemann_gas.hpp"
#include "solvers/godunov/godunov.hpp"
#include "tests/catch.hpp"

namespace ordo::solvers::godunov::test {

inline const std::vector<std::string> gas_fields{"density", "velocity", "pressure",
                                                 "energy",  "momentum", "total_energy"};
inline const std::vector<std::string> elastic_fields{"velocity",    "density", "stress",   "strain",
                                                     "temperature", "energy",  "momentum", "total_energy"};

inline std::unique_ptr<Simulation> started(const Scene& scene, const Given& options, const Given& resolution,
                                           const std::vector<std::string>& fields = gas_fields) {
    static const Solver godunov = solver();
    return godunov.start(scene, resolve(godunov.options, options, "", "solver godunov"),
                         resolve(godunov.resolution, resolution, "", "solver godunov"), fields);
}

inline const Interrupt never = [] { return false; };

/// The line at time t.
inline Snapshot at(const Scene& scene, double t, const Given& options, const Given& resolution,
                   const std::vector<std::string>& fields = gas_fields) {
    const auto run = started(scene, options, resolution, fields);
    run->advance_to(t, never);
    return run->snapshot();
}

inline double figure(const std::vector<Figure>& figures, const std::string& name) {
    for (const auto& figure : figures) {
        if (figure.name == name) return figure.value;
    }
    return std::nan("");
}

/// Two uniform gases, gamma = 1.4, on -half < x < half.
struct GasPair {
    oracles::Gas left, right;
    double half;

    LineScene scene(double shift = 0, double boost = 0) const {
        const IdealGas gas;
        const auto held = [&](const oracles::Gas& g) { return gas.contents(g.rho, g.v + boost, g.p); };
        return {gas, {shift - half, shift, shift + half}, {held(left), held(right)}};
    }
};
inline const GasPair sod{{.rho = 1, .v = 0, .p = 1}, {.rho = 0.125, .v = 0, .p = 0.1}, 5};
inline const GasPair toro_3{{.rho = 1, .v = 0, .p = 1000}, {.rho = 1, .v = 0, .p = 0.01}, 2.5};
inline const GasPair toro_4{
    {.rho = 5.99924, .v = 19.5975, .p = 460.894}, {.rho = 5.99242, .v = -6.19633, .p = 46.095}, 2.5};

/// Integral of |uniform cell - exact(x)| over the line by midpoints, `samples` a cell.
inline double l1(const Snapshot& shot, const std::string& name, const std::function<double(double x)>& exact,
                 int samples = 16) {
    const auto& found = shot.field(name).values;
    double sum = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double width = (shot.edges[i + 1] - shot.edges[i]) / samples;
        for (int k = 0; k < samples; ++k) sum += width * std::abs(found[i] - exact(shot.edges[i] + (k + 0.5) * width));
    }
    return sum;
}

/// A medium at rest in a wave of n cells: contents are exact means of a periodic state(x) over [0, 1], by Simpson's
/// rule on each piece.
template <class M>
LineScene periodic_wave(const M& medium, int n, const std::function<Contents(double x)>& state) {
    LineScene scene{medium, {}, {}, {LineEnd{LineEnd::Kind::periodic}, LineEnd{LineEnd::Kind::periodic}}};
    for (int i = 0; i <= n; ++i) scene.edges.push_back(static_cast<double>(i) / n);
    for (int i = 0; i < n; ++i) {
        const double a = scene.edges[static_cast<std::size_t>(i)];
        const double b = scene.edges[static_cast<std::size_t>(i) + 1];
        scene.pieces.push_back((1.0 / 6) * (state(a) + 4 * state(0.5 * (a + b)) + state(b)));
    }
    return scene;
}

}  // namespace ordo::solvers::godunov::test

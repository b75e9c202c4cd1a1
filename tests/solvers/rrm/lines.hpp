#pragma once
// Lines with exact solutions that the tests of the Repeated Replacement Method share, the way in through the solver's
// door, and how errors are judged.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "oracles/riemann/riemann_gas.hpp"
#include "oracles/riemann/riemann_linear_elastic.hpp"
#include "oracles/riemann/riemann_nonlinear_elastic.hpp"
#include "solvers/rrm/rrm.hpp"
#include "tests/catch.hpp"

namespace ordo::solvers::rrm::test {

inline const std::vector<std::string> gas_fields{"density", "velocity", "pressure", "momentum", "total_energy"};
inline const std::vector<std::string> elastic_fields{"density",     "velocity", "stress",
                                                     "temperature", "momentum", "total_energy"};
inline const std::vector<std::string>& fields_of(const Medium& medium) {
    return std::holds_alternative<IdealGas>(medium) ? gas_fields : elastic_fields;
}

/// More than 3e6 events are a hang: no run here needs as many.
inline std::unique_ptr<Simulation> started(const LineScene& scene, Given options, double delta) {
    static const Solver rrm = solver();
    options.try_emplace("most_events", 3e6);
    return rrm.start(scene, resolve(rrm.options, options, "", "solver rrm"),
                     resolve(rrm.resolution, {{"delta", delta}}, "", "solver rrm"), fields_of(scene.medium));
}

inline const Interrupt never = [] { return false; };

/// The run that has reached t.
inline std::unique_ptr<Simulation> run_to(double t, const LineScene& scene, const Given& options, double delta) {
    auto run = started(scene, options, delta);
    run->advance_to(t, never);
    return run;
}

inline Snapshot at(double t, const LineScene& scene, const Given& options, double delta) {
    return run_to(t, scene, options, delta)->snapshot();
}

inline double figure(const std::vector<Figure>& figures, const std::string& name) {
    const auto found = std::ranges::find(figures, name, &Figure::name);
    return found == figures.end() ? std::nan("") : found->value;
}

/// The largest of the three drifts; NaN where one is.
inline double worst_drift(const Simulation& run) {
    double worst = 0;
    for (const auto& drift : run.drift()) worst = drift.value <= worst ? worst : drift.value;
    return worst;
}

using Row = std::array<double, 4>;  ///< density, velocity, pressure or stress, temperature

/// A Riemann problem at x = 0 until t, with its exact solution then.
struct Problem {
    LineScene scene;
    double t;
    std::function<Row(double x)> exact;
    std::vector<double> places;  ///< of shocks, contacts and the edges of fans, rising

    double length() const { return scene.edges.back() - scene.edges.front(); }
    std::size_t watched() const { return std::holds_alternative<IdealGas>(scene.medium) ? 3 : 4; }
    std::string field(std::size_t k) const { return fields_of(scene.medium)[k]; }

    /// Largest less smallest value of a field: waves are monotone, so that the states between them tell.
    double range(std::size_t k) const {
        std::vector<double> cuts = places;
        cuts.insert(cuts.begin(), places.front() - 1);
        cuts.push_back(places.back() + 1);
        double least = exact(cuts.front())[k];
        double most = least;
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const double value = exact(0.5 * (cuts[i] + cuts[i + 1]))[k];
            least = std::min(least, value);
            most = std::max(most, value);
        }
        return most - least;
    }

    /// Options with the allowed flattening errors at delta = 1 at a tenth of range times length; a field that stays
    /// uniform has the solver's default.
    Given watching(Given options) const {
        const char* changes[] = {"density_change", "velocity_change", "pressure_change", "temperature_change"};
        for (std::size_t k = 0; k < watched(); ++k) {
            if (range(k) > 0) options[changes[k]] = 0.1 * length() * range(k);
        }
        return options;
    }
};

inline Problem gas_problem(const oracles::Gas& left, const oracles::Gas& right, double half, double t) {
    const IdealGas gas{left.gamma};
    const auto exact = std::make_shared<oracles::RiemannGas>(left, right);
    Problem problem{
        {gas, {-half, 0, half}, {gas.contents(left.rho, left.v, left.p), gas.contents(right.rho, right.v, right.p)}},
        t,
        [exact, t](double x) -> Row {
            const auto f = exact->at(x, t);
            return {f.density, f.velocity, f.pressure, 0};
        },
        {}};
    for (const auto& wave : exact->waves()) {
        for (const double speed : {wave.head, wave.tail}) problem.places.push_back(speed * t);
    }
    std::ranges::sort(problem.places);
    return problem;
}

using Stretched = oracles::elastic::State;

template <class Energy, class Exact>
Problem elastic_problem(const ElasticMedium<Energy>& medium, std::shared_ptr<Exact> exact, const Stretched& left,
                        const Stretched& right, double half, double t) {
    Problem problem{{medium,
                     {-half, 0, half},
                     {medium.contents(left.lambda, left.v, left.T), medium.contents(right.lambda, right.v, right.T)}},
                    t,
                    [exact, t](double x) -> Row {
                        const auto row = exact->fields(x, t);
                        return {row[1], row[0], row[2], row[4]};
                    },
                    {}};
    for (const double speed : exact->speeds()) problem.places.push_back(speed * t);
    return problem;
}

inline Problem linear_problem(const Stretched& left, const Stretched& right, double half = 2.5, double t = 1,
                              const ElasticMedium<HookeEnergy>& m = {}) {
    return elastic_problem(m, std::make_shared<oracles::RiemannLinearElastic>(m.E, m.rho0, m.c_v, left, right), left,
                           right, half, t);
}

/// Material A with heat that pushes.
inline Problem rubber_problem(const Stretched& left, const Stretched& right, double half = 4, double t = 1,
                              const ElasticMedium<RubberEnergy>& m = {.k = 1}) {
    namespace elastic = oracles::elastic;
    using Rubber = elastic::Material<elastic::NeoHookean, elastic::PowerHeat>;
    const Rubber rubber{{m.E}, {m.c_v, m.k}, m.rho0};
    return elastic_problem(m, std::make_shared<oracles::RiemannNonlinearElastic<Rubber>>(rubber, left, right), left,
                           right, half, t);
}

/// Sod's problem, Toro's five, and the elastic ones of our own: states (rho, v, p) or (lambda, v, T).
inline const Problem sod = gas_problem({.rho = 1, .v = 0, .p = 1}, {.rho = 0.125, .v = 0, .p = 0.1}, 5, 1.5);
inline const std::array<Problem, 5> toro{
    gas_problem({.rho = 1, .v = 0.75, .p = 1}, {.rho = 0.125, .v = 0, .p = 0.1}, 2.5, 0.8),
    gas_problem({.rho = 1, .v = -2, .p = 0.4}, {.rho = 1, .v = 2, .p = 0.4}, 2.5, 0.6),
    gas_problem({.rho = 1, .v = 0, .p = 1000}, {.rho = 1, .v = 0, .p = 0.01}, 2.5, 0.04),
    gas_problem({.rho = 5.99924, .v = 19.5975, .p = 460.894}, {.rho = 5.99242, .v = -6.19633, .p = 46.095}, 2.5, 0.15),
    gas_problem({.rho = 1, .v = -19.59745, .p = 1000}, {.rho = 1, .v = -19.59745, .p = 0.01}, 2.5, 0.03)};
inline const std::array<std::array<Stretched, 2>, 4> elastic_states{{{{{0.5, 0, 1}, {1, 0, 0.2}}},
                                                                     {{{1, 0.4, 0.5}, {1, -0.4, 0.5}}},
                                                                     {{{1, -0.4, 0.5}, {1, 0.4, 0.5}}},
                                                                     {{{0.8, 0.3, 0.4}, {1.25, -0.1, 0.9}}}}};
inline Problem linear(std::size_t i) { return linear_problem(elastic_states[i][0], elastic_states[i][1]); }
inline Problem rubber(std::size_t i) { return rubber_problem(elastic_states[i][0], elastic_states[i][1]); }

/// Integral of |cell - exact(x)| over the stretch [from, to] of a snapshot, with the cells' rises where they have any:
/// midpoints, 16 between each two of the cells' borders and `places`, where the exact solution has corners.
inline double l1(const Snapshot& shot, std::size_t field, const std::function<double(double x)>& exact,
                 const std::vector<double>& places, double from, double to) {
    constexpr int samples = 16;
    double sum = 0;
    for (std::size_t i = 0; i < shot.points(); ++i) {
        const double rise = shot.slopes.empty() ? 0 : shot.slopes[field].values[i] / shot.weights[i];
        double a = std::max(from, shot.edges[i]);
        const double end = std::min(to, shot.edges[i + 1]);
        for (auto place = places.begin(); a < end;) {
            while (place != places.end() && *place <= a) ++place;
            const double b = place == places.end() ? end : std::min(end, *place);
            for (int k = 0; k < samples; ++k) {
                const double x = a + (b - a) * (k + 0.5) / samples;
                sum += (b - a) / samples * std::abs(shot.fields[field].values[i] + rise * (x - shot.x[i]) - exact(x));
            }
            a = b;
        }
    }
    return sum;
}

inline double l1(const Snapshot& shot, const Problem& problem, std::size_t field) {
    const auto exact = [&](double x) { return problem.exact(x)[field]; };
    return l1(shot, field, exact, problem.places, problem.scene.edges.front(), problem.scene.edges.back());
}

/// L1 errors of density, velocity, pressure or stress, and temperature.
inline Row errors(const Snapshot& shot, const Problem& problem) {
    Row found{};
    for (std::size_t k = 0; k < problem.watched(); ++k) found[k] = l1(shot, problem, k);
    return found;
}

}  // namespace ordo::solvers::rrm::test

#pragma once
// What is true of every manufactured motion, said without closed forms: the motion x = X + u(X, t) alone gives F, v,
// the stress (through the energy) and, with the balance of momentum, the body force. Over callables, so that faulty
// motions can be passed too.
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "oracles/manufactured/material_point.hpp"
#include "tests/oracles/differences.hpp"

namespace ordo::oracles::gate::manufactured {

inline constexpr double pi = 3.141592653589793;
inline constexpr double eps = std::numeric_limits<double>::epsilon();

template <std::size_t dim>
using Place = std::array<double, dim>;

/// A claimed motion, with the data that it was claimed for.
template <std::size_t dim>
struct Motion {
    std::function<MaterialPoint<dim>(const Place<dim>& X, double t)> at;
    ElasticConstants elastic;
    double rho;
    double length;                    ///< over which the motion changes [m]
    double omega;                     ///< [1/s]
    std::vector<Place<dim>> points;   ///< at least 0.4 lengths inside of where at() ends, if it ends
    std::vector<Place<dim>> peaks{};  ///< more points, only to see how large fields are
    double digits = 8 * eps;          ///< stated accuracy at t = 0, relative to a field's amplitude
    double share = 0.05;              ///< steps of differences in lengths and in 1 / omega
    std::vector<double> phases{0.0, 0.37, 1.21, 2.9, 8.3};  ///< omega t

    double accuracy(double t) const { return digits * (1 + omega * t); }
};

template <std::size_t dim, class Visit>
void at_samples(const Motion<dim>& motion, Visit&& visit) {
    for (const double phase : motion.phases) {
        for (const auto& X : motion.points) visit(X, phase / motion.omega);
    }
}

/// Largest component of a field at the samples and a quarter period after each.
template <std::size_t dim, class Field>
double largest(const Motion<dim>& motion, Field&& field) {
    double most = 0;
    const auto look = [&](const Place<dim>& X, double t) {
        for (const double later : {t, t + pi / 2 / motion.omega}) {
            const auto value = field(motion.at(X, later));
            for (const double component : value) most = std::max(most, std::abs(component));
        }
    };
    at_samples(motion, look);
    for (const auto& X : motion.peaks) look(X, motion.phases.front() / motion.omega);
    return most;
}

/// f(X) along axis J through X.
template <std::size_t dim, class F>
auto along(const Place<dim>& X, std::size_t J, F f) {
    return [=](double place) {
        auto moved = X;
        moved[J] = place;
        return f(moved);
    };
}

template <std::size_t dim>
double determinant(const std::array<double, dim * dim>& F) {
    if constexpr (dim == 1) return F[0];
    else if constexpr (dim == 2) return F[0] * F[3] - F[1] * F[2];
    else
        return F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) +
               F[2] * (F[3] * F[7] - F[4] * F[6]);
}

/// strain = du/dX, F = I + strain, det F > 0.
template <std::size_t dim>
Defect deformation(const Motion<dim>& motion) {
    const double u_scale = largest(motion, [](const auto& p) { return p.u; });
    const double scale = largest(motion, [](const auto& p) { return p.strain; });
    const double h = motion.share * motion.length;
    Defect defect;
    at_samples(motion, [&](const Place<dim>& X, double t) {
        const auto p = motion.at(X, t);
        defect.add(determinant<dim>(p.F) > 0 ? 0 : 1, 0, 1);
        for (std::size_t i = 0; i < dim; ++i) {
            for (std::size_t J = 0; J < dim; ++J) {
                const std::size_t iJ = i * dim + J;
                const auto u = along<dim>(X, J, [&](const Place<dim>& Y) { return motion.at(Y, t).u[i]; });
                const auto u_J = first_derivative(u, X[J], h, u_scale * motion.accuracy(t));
                defect.add(p.strain[iJ] - u_J.value, u_J.error + motion.accuracy(t) * scale, scale);
                defect.add(p.F[iJ] - (i == J) - p.strain[iJ], eps, 1);
            }
        }
    });
    return defect;
}

/// velocity = u_t.
template <std::size_t dim>
Defect velocity(const Motion<dim>& motion) {
    const double u_scale = largest(motion, [](const auto& p) { return p.u; });
    const double scale = largest(motion, [](const auto& p) { return p.v; });
    const double dt = motion.share / motion.omega;
    Defect defect;
    at_samples(motion, [&](const Place<dim>& X, double t) {
        const auto p = motion.at(X, t);
        for (std::size_t i = 0; i < dim; ++i) {
            const auto u = [&](double s) { return motion.at(X, s).u[i]; };
            const auto u_t = first_derivative(u, t, dt, u_scale * motion.accuracy(t + 4 * dt));
            defect.add(p.v[i] - u_t.value, u_t.error + motion.accuracy(t) * scale, scale);
        }
    });
    return defect;
}

/// W = mu/2 (tr F F^T - dim) - mu ln J + lambda/2 (ln J)^2.
template <std::size_t dim>
double energy(const ElasticConstants& elastic, const std::array<double, dim * dim>& F) {
    double trace = -static_cast<double>(dim);
    for (const double component : F) trace += component * component;
    const double ln_J = std::log(determinant<dim>(F));
    return elastic.G / 2 * trace - elastic.G * ln_J + elastic.lambda / 2 * ln_J * ln_J;
}

/// nominal_stress = dW/dF; stress = P F^T / det F.
template <std::size_t dim>
Defect law(const Motion<dim>& motion) {
    const double scale = largest(motion, [](const auto& p) { return p.P; });
    const double stress_scale = largest(motion, [](const auto& p) { return p.stress; });
    const double round_off = 16 * eps * motion.elastic.M;  // of an energy whose terms are about 1 to 10 M
    Defect defect;
    at_samples(motion, [&](const Place<dim>& X, double t) {
        const auto p = motion.at(X, t);
        const double J = determinant<dim>(p.F);
        double most = 1;  // component; to the power dim - 1, how fast J changes with one of them
        for (const double component : p.F) most = std::max(most, std::abs(component));
        const double step = 0.4 * motion.share * std::min(1.0, J) / std::pow(most, dim - 1);
        for (std::size_t k = 0; k < dim * dim; ++k) {
            const auto W = [&](double component) {
                auto F = p.F;
                F[k] = component;
                return energy<dim>(motion.elastic, F);
            };
            const auto W_F = first_derivative(W, p.F[k], step, round_off * most * most);
            defect.add(p.P[k] - W_F.value, W_F.error + motion.accuracy(t) * scale, scale);
        }
        for (std::size_t i = 0; i < dim; ++i) {
            for (std::size_t j = 0; j < dim; ++j) {
                double tau = 0, size = 0;
                for (std::size_t K = 0; K < dim; ++K) {
                    tau += p.P[i * dim + K] * p.F[j * dim + K];
                    size += std::abs(p.P[i * dim + K] * p.F[j * dim + K]);
                }
                const double error = (8 * eps * size + motion.accuracy(t) * scale * (1 + size / scale)) / J;
                defect.add(p.stress[i * dim + j] - tau / J, error, stress_scale);
            }
        }
    });
    return defect;
}

/// rho u_tt = Div P + rho body_force, relative to the largest of the terms.
template <std::size_t dim>
Defect balance(const Motion<dim>& motion) {
    const double u_scale = largest(motion, [](const auto& p) { return p.u; });
    const double P_scale = largest(motion, [](const auto& p) { return p.P; });
    const double b_scale = largest(motion, [](const auto& p) { return p.b; });
    const double h = motion.share * motion.length, dt = motion.share / motion.omega;
    const double scale = motion.rho * std::max(b_scale, motion.omega * motion.omega * u_scale);
    Defect defect;
    at_samples(motion, [&](const Place<dim>& X, double t) {
        const double later = motion.accuracy(t + 4 * dt);
        const auto b = motion.at(X, t).b;
        for (std::size_t i = 0; i < dim; ++i) {
            const auto u = [&](double s) { return motion.at(X, s).u[i]; };
            const auto u_tt = second_derivative(u, t, dt, u_scale * later);
            double divergence = 0, error = motion.rho * u_tt.error + motion.rho * later * b_scale;
            for (std::size_t J = 0; J < dim; ++J) {
                const auto P = along<dim>(X, J, [&](const Place<dim>& Y) { return motion.at(Y, t).P[i * dim + J]; });
                const auto P_J = first_derivative(P, X[J], h, P_scale * later);
                divergence += P_J.value;
                error += P_J.error;
            }
            defect.add(motion.rho * u_tt.value - divergence - motion.rho * b[i], error, scale);
        }
    });
    return defect;
}

template <std::size_t dim>
struct Gate {
    std::string name;
    Defect (*defect)(const Motion<dim>&);
};
template <std::size_t dim>
inline const std::vector<Gate<dim>> gates{
    {"deformation", deformation<dim>}, {"velocity", velocity<dim>}, {"law", law<dim>}, {"balance", balance<dim>}};

/// Names of the gates that the motion does not pass, joined; with figures for a message.
template <std::size_t dim>
std::string ringing(const Motion<dim>& motion) {
    std::string names;
    for (const auto& [name, gate] : gates<dim>) {
        const Defect defect = gate(motion);
        if (!defect.holds())
            names += name + " (" + std::to_string(defect.found * 1e12) + "e-12, allowed " +
                     std::to_string(defect.allowed * 1e12) + "e-12); ";
    }
    return names;
}

/// The same motion with something done to each of its points.
template <std::size_t dim, class Fault>
Motion<dim> with(Motion<dim> motion, Fault fault) {
    motion.at = [good = motion.at, fault](const Place<dim>& X, double t) {
        auto p = good(X, t);
        fault(p, X, t);
        return p;
    };
    return motion;
}

}  // namespace ordo::oracles::gate::manufactured

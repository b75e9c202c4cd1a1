#pragma once
// Fields of a motion from the motion alone, in 50 digits: derivatives by differences that are good to 20 digits, the
// stress from the energy, the body force from the balance of momentum. Slow to compile: for one source.
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "oracles/manufactured/material_point.hpp"

namespace ordo::oracles::gate::manufactured {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type, boost::multiprecision::et_off>;
inline const Real real_pi = boost::math::constants::pi<Real>();
/// Second-order differences over 1e-12 of the natural scale: truncation 1e-24, round-off 1e-26 of the stiffness at
/// most. A body force of order A^2 is known to 1e-15 of itself down to A = 1e-5 of the length.
inline const Real step("1e-12");

template <std::size_t n>
using Reals = std::array<Real, n>;

/// A motion with its data, in 50 digits.
template <std::size_t dim>
struct Truth {
    std::function<Reals<dim>(const Reals<dim>& X, const Real& t)> u;
    Real lambda, mu, rho, length, omega;
};

template <class F>
auto slope(F&& f, const Real& at, const Real& h) {
    auto up = f(Real(at + h));
    const auto down = f(Real(at - h));
    for (std::size_t k = 0; k < up.size(); ++k) up[k] = (up[k] - down[k]) / (2 * h);
    return up;
}

template <std::size_t dim>
Real determinant(const Reals<dim * dim>& F) {
    if constexpr (dim == 1) return F[0];
    else if constexpr (dim == 2) return F[0] * F[3] - F[1] * F[2];
    else
        return F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) +
               F[2] * (F[3] * F[7] - F[4] * F[6]);
}

template <std::size_t dim>
Reals<dim * dim> displacement_gradient(const Truth<dim>& truth, const Reals<dim>& X, const Real& t) {
    Reals<dim * dim> H;
    for (std::size_t J = 0; J < dim; ++J) {
        const auto along = [&](const Real& place) {
            auto moved = X;
            moved[J] = place;
            return truth.u(moved, t);
        };
        const auto column = slope(along, X[J], step * truth.length);
        for (std::size_t i = 0; i < dim; ++i) H[i * dim + J] = column[i];
    }
    return H;
}

template <std::size_t dim>
Reals<dim * dim> identity_plus(Reals<dim * dim> H) {
    for (std::size_t i = 0; i < dim; ++i) H[i * dim + i] += 1;
    return H;
}

/// P = dW/dF by differences of the energy.
template <std::size_t dim>
Reals<dim * dim> nominal_stress(const Truth<dim>& truth, const Reals<dim * dim>& F) {
    const auto energy = [&](const Reals<dim * dim>& G) {
        Real trace = -Real(dim);
        for (const auto& component : G) trace += component * component;
        const Real ln_J = log(determinant<dim>(G));
        return Reals<1>{truth.mu / 2 * trace - truth.mu * ln_J + truth.lambda / 2 * ln_J * ln_J};
    };
    Reals<dim * dim> P;
    for (std::size_t k = 0; k < F.size(); ++k) {
        const auto along = [&](const Real& component) {
            auto changed = F;
            changed[k] = component;
            return energy(changed);
        };
        P[k] = slope(along, F[k], step)[0];
    }
    return P;
}

/// All fields in the order of manufactured_fields(), from the motion, the energy and the balance of momentum.
template <std::size_t dim>
std::vector<Real> fields(const Truth<dim>& truth, const Reals<dim>& X, const Real& t) {
    const Real dt = step / truth.omega;
    const auto in_time = [&](const Real& s) { return truth.u(X, s); };
    const auto u = in_time(t), up = in_time(t + dt), down = in_time(t - dt);
    const auto v = slope(in_time, t, dt);
    const auto H = displacement_gradient(truth, X, t);
    const auto F = identity_plus<dim>(H);
    const auto P = nominal_stress(truth, F);
    Reals<dim * dim> stress{};
    Reals<dim> b{};
    for (std::size_t i = 0; i < dim; ++i) {
        for (std::size_t j = 0; j < dim; ++j) {
            for (std::size_t K = 0; K < dim; ++K)
                stress[i * dim + j] += P[i * dim + K] * F[j * dim + K] / determinant<dim>(F);
        }
        b[i] = (up[i] - 2 * u[i] + down[i]) / (dt * dt);
    }
    for (std::size_t J = 0; J < dim; ++J) {
        const auto along = [&](const Real& place) {
            auto moved = X;
            moved[J] = place;
            return nominal_stress(truth, identity_plus<dim>(displacement_gradient(truth, moved, t)));
        };
        const auto change = slope(along, X[J], step * truth.length);
        for (std::size_t i = 0; i < dim; ++i) b[i] -= change[i * dim + J] / truth.rho;
    }
    std::vector<Real> all;
    const auto append = [&all](const auto& field) { all.insert(all.end(), field.begin(), field.end()); };
    append(u), append(v), append(stress), append(H), append(b), append(F), append(P);
    return all;
}

/// What a body claims: its fields at a point, and how exact they are at a time.
template <std::size_t dim>
struct Claim {
    std::function<MaterialPoint<dim>(const std::array<double, dim>& X, double t)> at;
    std::function<double(double t)> accuracy;
    std::vector<std::array<double, dim>> points;
    double body_force_scale = 0;  ///< where it is not the largest value itself [m/s^2]
};

struct Digits {
    double worst = 0;     ///< error over stated error
    std::string where{};  ///< the field it is of
};

/// Errors over stated errors; the amplitude of a field is its largest component at these points and times.
template <std::size_t dim>
Digits digits(const Truth<dim>& truth, const Claim<dim>& claim) {
    const auto infos = manufactured_fields();
    std::vector<double> amplitude(infos.size(), 0.0), excess(infos.size(), 0.0);
    for (const double phase : {0.0, 0.41, 1.37, 2.03, 4.4, 63.0}) {
        const double t = phase / static_cast<double>(truth.omega);
        for (const auto& X : claim.points) {
            Reals<dim> place;
            for (std::size_t k = 0; k < dim; ++k) place[k] = X[k];
            const auto exact = fields(truth, place, Real(t));
            std::vector<double> found(exact.size());
            write(claim.at(X, t), found);
            std::size_t k = 0;
            for (std::size_t f = 0; f < infos.size(); ++f) {
                for (int component = 0; component < components_of(infos[f].rank, dim); ++component, ++k) {
                    amplitude[f] = std::max(amplitude[f], std::abs(static_cast<double>(exact[k])));
                    const double error = std::abs(static_cast<double>(exact[k] - found[k]));
                    if (!(error / claim.accuracy(t) <= excess[f])) excess[f] = error / claim.accuracy(t);
                }
            }
        }
    }
    Digits result;
    for (std::size_t f = 0; f < infos.size(); ++f) {
        const bool scaled = infos[f].name == "body_force" && claim.body_force_scale > 0;
        const double share = excess[f] / (scaled ? claim.body_force_scale : amplitude[f]);
        if (!(share <= result.worst)) result = {share, infos[f].name};
    }
    return result;
}

}  // namespace ordo::oracles::gate::manufactured

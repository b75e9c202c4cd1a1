#include "bench/reference/wave.hpp"

#include <cmath>
#include <numbers>

namespace ordo::bench {
namespace {

constexpr double pi = std::numbers::pi;

double wave_number(const Wave& wave, int axis) { return pi / (wave.cells[axis] * wave.h) / (wave.free_end ? 2 : 1); }

/// A component of grad prod cos, in units of the first wave number.
double shape(const Wave& wave, const std::array<double, 3>& X, int axis) {
    double product = wave_number(wave, axis) / wave_number(wave, 0);
    for (int a = 0; a < wave.dim; ++a) {
        const double angle = wave_number(wave, a) * X[a];
        product *= a == axis ? std::sin(angle) : std::cos(angle);
    }
    return product;
}

}  // namespace

double Wave::speed() const { return std::sqrt((lambda + 2 * mu) / rho); }

double Wave::omega() const {
    double sum = 0;
    for (int a = 0; a < dim; ++a) sum += std::pow(wave_number(*this, a), 2);
    return speed() * std::sqrt(sum);
}

long Wave::particles() const { return static_cast<long>(cells[0]) * cells[1] * cells[2] * slots(); }

double Wave::velocity(const std::array<double, 3>& X, int axis) const {
    return v0 * shape(*this, X, axis) + (axis == 0 ? drift : 0);
}

double Wave::displacement(const std::array<double, 3>& X, int axis, double t) const {
    return v0 / omega() * shape(*this, X, axis) * std::sin(omega() * t) + (axis == 0 ? drift * t : 0);
}

Particles seeded(const Wave& wave) {
    Particles p;
    const double volume = std::pow(wave.h / 2, wave.dim);
    const auto place = [&](int cell, int slot, int axis) {
        return axis < wave.dim ? wave.h * (cell + 0.25 + 0.5 * (slot >> axis & 1)) : 0.0;
    };
    for (int cz = 0; cz < wave.cells[2]; ++cz) {
        for (int cy = 0; cy < wave.cells[1]; ++cy) {
            for (int cx = 0; cx < wave.cells[0]; ++cx) {
                for (int slot = 0; slot < wave.slots(); ++slot) {
                    const std::array<double, 3> X{place(cx, slot, 0), place(cy, slot, 1), place(cz, slot, 2)};
                    for (int axis = 0; axis < wave.dim; ++axis) {
                        p.x[axis].push_back(X[axis]);
                        p.v[axis].push_back(wave.velocity(X, axis));
                    }
                }
            }
        }
    }
    const std::size_t count = p.x[0].size();
    for (int k = 0; k < wave.dim * (wave.dim + 1) / 2; ++k) p.sigma[k].assign(count, 0);
    p.volume.assign(count, volume);
    p.m.assign(count, wave.rho * volume);
    return p;
}

double error_of(const Wave& wave, const Particles& now, double t) {
    const Particles first = seeded(wave);
    double error = 0;
    double scale = 0;
    for (std::size_t p = 0; p < first.size(); ++p) {
        std::array<double, 3> X{};
        for (int axis = 0; axis < wave.dim; ++axis) X[axis] = first.x[axis][p];
        for (int axis = 0; axis < wave.dim; ++axis) {
            const double exact = wave.displacement(X, axis, t);
            error += std::pow(now.x[axis][p] - X[axis] - exact, 2);
            scale += exact * exact;
        }
    }
    return std::sqrt(error / scale);
}

}  // namespace ordo::bench

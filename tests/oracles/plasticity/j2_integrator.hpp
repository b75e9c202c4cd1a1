#pragma once
// Von Mises plasticity in three dimensions, integrated from its rate equations: what the closed forms are held to.
#include <array>
#include <cmath>
#include <cstddef>

namespace ordo::oracles::gate::plasticity {

using Tensor = std::array<double, 9>;  ///< row by row

inline Tensor combined(double a, const Tensor& A, double b, const Tensor& B) {
    Tensor sum{};
    for (std::size_t k = 0; k < 9; ++k) sum[k] = a * A[k] + b * B[k];
    return sum;
}
inline double trace(const Tensor& A) { return A[0] + A[4] + A[8]; }
inline Tensor deviator(const Tensor& A) { return combined(1, A, -trace(A) / 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}); }
inline double inner(const Tensor& A, const Tensor& B) {
    double sum = 0;
    for (std::size_t k = 0; k < 9; ++k) sum += A[k] * B[k];
    return sum;
}
inline double von_mises(const Tensor& stress) {
    const Tensor s = deviator(stress);
    return std::sqrt(1.5 * inner(s, s));
}

struct Metal {
    double K, G, Y0, H;

    Tensor elastic(const Tensor& strain) const {
        return combined(2 * G, deviator(strain), K * trace(strain), {1, 0, 0, 0, 1, 0, 0, 0, 1});
    }
    /// Of the elastic strain that carries this stress, per volume.
    double energy(const Tensor& stress) const {
        const Tensor s = deviator(stress);
        return inner(s, s) / (4 * G) + trace(stress) * trace(stress) / (18 * K);
    }
};

struct Point {
    Tensor stress{};
    double p = 0;  ///< equivalent plastic strain
};

/// One step of backward Euler: d stress = C : (d strain - dp n), n = 3 s / (2 q) of the end, q = Y0 + H p of the end.
/// The end's s is parallel to the elastic trial's, so that dp = (q_trial - Y) / (3 G + H): radial return.
inline Point backward_euler(const Metal& metal, const Point& from, const Tensor& strain_step) {
    Point to{combined(1, from.stress, 1, metal.elastic(strain_step)), from.p};
    const double q = von_mises(to.stress);
    const double excess = q - metal.Y0 - metal.H * from.p;
    if (excess <= 0) return to;
    const double dp = excess / (3 * metal.G + metal.H);
    to.p += dp;
    to.stress = combined(1, to.stress, -3 * metal.G * dp / q, deviator(to.stress));
    return to;
}

/// d stress / dt during plastic flow, from the consistency condition (d/dt)(q - Y0 - H p) = 0.
inline Tensor flowing(const Metal& metal, const Tensor& stress, const Tensor& strain_rate) {
    const Tensor s = deviator(stress);
    const double q = std::sqrt(1.5 * inner(s, s));
    const double dp = 3 * metal.G * inner(s, strain_rate) / q / (3 * metal.G + metal.H);
    return combined(1, metal.elastic(strain_rate), -3 * metal.G * dp / q, s);
}

}  // namespace ordo::oracles::gate::plasticity

#pragma once
// What the exact solutions of straight elastic bars share: fields, the way of a front to and fro, means over cells.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "oracles/oracle.hpp"

namespace ordo::oracles::bars {

/// The state of a bar at a point, or its mean over a cell. The nominal stress is E times the strain.
struct Fields {
    double displacement = 0;  ///< u [m]
    double velocity = 0;      ///< u_t [m/s]
    double strain = 0;        ///< u_X [-]
};

inline Fields operator+(const Fields& a, const Fields& b) {
    return {a.displacement + b.displacement, a.velocity + b.velocity, a.strain + b.strain};
}
inline Fields operator*(double s, const Fields& a) { return {s * a.displacement, s * a.velocity, s * a.strain}; }

/// A row of values in the order of standard_fields(); + 0.0 turns -0 into 0.
inline std::array<double, 4> row(const Fields& f, double E) {
    return {f.displacement + 0.0, f.velocity + 0.0, E * f.strain + 0.0, f.strain + 0.0};
}

/// A Sample from at(t), which does once what does not depend on X and has `Fields at(X)`.
template <class At>
Exact::Sample points_of(At at, double E) {
    return [=](std::span<const double> x, double t, std::span<double> values) {
        const auto now = at(t);
        auto out = values.begin();
        for (const double X : x) {
            for (const double value : row(now.at(X), E)) *out++ = value;
        }
    };
}

/// Averages from at(t), which has `Fields mean(a, b)`.
template <class At>
Exact::Sample cells_of(At at, double E) {
    return [=](std::span<const double> edges, double t, std::span<double> values) {
        const auto now = at(t);
        auto out = values.begin();
        for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
            for (const double value : row(now.mean(edges[i], edges[i + 1]), E)) *out++ = value;
        }
    };
}

/// How far a front has come that left one end of a bar at t = 0 and runs to and fro: the path c t in lengths L is a
/// whole number of transits and a share of the next one.
struct Transit {
    Transit(double t, double c, double L)
        : count(std::floor(c * t / L)),
          part(c * t / L - count),
          phase(static_cast<int>(count - 4 * std::floor(count / 4))) {}

    bool outward() const { return phase % 2 == 0; }  ///< away from the end where it started

    double count;
    double part;  ///< in [0, 1)
    int phase;    ///< count modulo 4: with one end fixed and one free everything repeats after 4 L / c
};

/// The mean over [a, b] of what is smooth on either side of `front`: piece(low, high) is the mean over a part.
template <class Piece>
Fields mean_in_parts(double a, double b, double front, Piece piece) {
    if (front <= a || front >= b) return piece(a, b);
    const double share = (front - a) / (b - a);
    return share * piece(a, front) + (1 - share) * piece(front, b);
}

/// The mean over [a, b] of a polynomial of degree 7 or less: Gauss-Legendre with 4 points is exact to round-off, and
/// its positive weights lose nothing on a tiny interval.
template <class F>
Fields polynomial_mean(double a, double b, F f) {
    constexpr double near = 0.33998104358485626;    // sqrt(3/7 - sqrt(24/245))
    constexpr double far = 0.86113631159405258;     // sqrt(3/7 + sqrt(24/245))
    constexpr double weight = 0.32607257743127307;  // (18 + sqrt 30) / 72, of each of the two near ones
    const double middle = (a + b) / 2;
    const double half = (b - a) / 2;
    return weight * (f(middle - near * half) + f(middle + near * half)) +
           (0.5 - weight) * (f(middle - far * half) + f(middle + far * half));
}

/// What a front is in a field, where it makes that derivative of the displacement jump: of velocity, stress and strain
/// the one before.
Feature front_feature(const std::string& field, double x, int derivative);

/// Throws InputError where sqrt(E / rho), the transit time L / c or their inverses are no ordinary numbers.
void require_waves(double L, double E, double rho, const std::string& where);

/// Throws InputError, naming `what`, unless the number is finite.
void require_finite(double value, const std::string& what, const std::string& where);

/// Latest time [s]: beyond 1e12 radians a phase has less than four digits left.
inline constexpr double most_radians = 1e12;

}  // namespace ordo::oracles::bars

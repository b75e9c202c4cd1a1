#pragma once
// The similarity profiles of a strong point blast, in one closed form for every gamma and omega.
#include <array>
#include <cstddef>

namespace ordo::oracles {

/// What lies inside the shock: gas down to the centre; the linear velocity between the two; a vacuum core.
enum class BlastKind { standard, singular, vacuum };

/// Sedov's solution of the Euler equations for a strong shock in a cold gas of density ~ r^-omega, as functions of
/// lambda = r / r_shock. With v = u t / (delta r), delta = 2 / n, n = j + 2 - omega, it is a product of powers of
///
///   x1 ~ v,  x2 ~ gamma v - 1,  x3 ~ v* - v,  x4 ~ 1 - v,      v* = n / Q,  Q = 2 + j (gamma - 1)
///
/// (each 1 at the shock), whose exponents have the denominators D = 2 (gamma - 1) + j - gamma omega and
/// B = j (2 - gamma) - omega. They vanish where x3 falls on x2 (D = 0) or on x4 (B = 0); and v no longer varies where
/// x3 vanishes at the shock (S = D + B = 0, the singular case). The pairs of diverging exponents are divided
/// differences, and the parameter is not v but the cross-ratio
///
///   q = ln(x3 / x_end),  0 at the shock, infinite at the inner end;  end = 2 if S >= 0 (centre), else 4 (vacuum)
///   M_i(q) = -ln(1 - r_i (1 - e^-q)) / r_i,      ln(x_i / x3) = -r_i M_i,  ln x3 = r_3 M_3
///   Y = D if S >= 0, else -B:  r_1 = n (gamma - 1) / (2Y),  r_2 = D / Y,  r_3 = (gamma - 1) Q / ((gamma + 1) Y),
///   r_4 = -B / Y;  M_i = 1 - e^-q at r_i = 0 and M_i = q at r_i = 1
///
/// in which everything is regular:
///
///   Y ln lambda = (gamma - 1) (M_1 - M_2 - M_3)
///   Y ln g = -omega (gamma - 1) M_1 + (gamma omega - j) M_2 + 2 (gamma - 1) (j - 1) / (gamma + 1) M_3
///            + (omega (gamma + 1) - 2j) M_4
///   Y ln h = -j (gamma - 1) M_1 + 2 gamma (gamma - 1) (j - 1) / (gamma + 1) M_3 - gamma (j - omega) M_4
///   Y ln m = (j - omega) ((gamma - 1) M_1 - gamma M_2 - gamma M_4)
///   f = lambda x1
///
/// accurate to 1e-13 for lambda >= 1e-3, and 1e-15 r / (r - r_core) times the steepest power near a core; below 1e-3 to
/// an
///          ulp of lambda times its power  (gate: tests/oracles/blasts/similarity_digits_test.cpp)
/// source   [KammTimmes2007] for the products of powers; this form of them is derived in docs/oracles/sedov.md
class Similarity {
public:
    /// f = u / u2, g = rho / rho2, h = p / p2 and h / g, relative to the values behind the shock.
    struct Profile {
        double velocity, density, pressure, energy;
    };

    /// What a shell dq holds: g, g f^2 and h, each times lambda^(j - 1) |d lambda / dq|.
    struct Shell {
        double mass, kinetic, pressure;
    };

    /// j = 1, 2, 3; gamma > 1; omega < j.
    Similarity(int j, double gamma, double omega);

    BlastKind kind() const { return kind_; }
    double core() const { return core_; }    ///< lambda at the edge of the vacuum core, 0 where there is none
    double decay() const { return decay_; }  ///< shells fall as e^-decay q towards the inner end, or faster

    /// At core() <= lambda <= 1. Not finite where the limit at the inner end is infinite, or beyond a double.
    Profile profile(double lambda) const;

    /// The share of all swept mass that lies within lambda, core() <= lambda <= 1: m = g lambda^j x4.
    double enclosed_mass(double lambda) const;

    Shell shell(double q) const;  ///< q >= 0

private:
    /// e = e^-q and z = 1 - e, each to its own last bits.
    struct Place {
        double q, e, z;
    };
    /// M_i and the arguments A_i = 1 - r_i z of their logarithms.
    struct Terms {
        std::array<double, 4> M, A;
    };
    Place place_of_q(double q) const;
    Place place_of(double M_k) const;
    Place place_of_lambda(double lambda) const;
    Terms terms(const Place& place) const;
    Profile profile(const Terms& terms, double lambda) const;
    double log_lambda(const Terms& terms) const;
    double ratio(const Terms& terms, std::size_t i) const;

    BlastKind kind_;
    int j_;
    std::size_t k_;  ///< M_k, counted from 0, is the unknown of the inversion
    double core_;
    double decay_;
    double rate_;                                               ///< (gamma - 1) / Y
    double last_;                                               ///< M_k at the inner end
    std::array<double, 4> r_;                                   ///< r_i
    std::array<double, 4> s_;                                   ///< 1 - r_i, by factors of S
    std::array<double, 4> density_, pressure_, energy_, mass_;  ///< coefficients of M_i in ln g, ln h, ln(h / g), ln m
};

}  // namespace ordo::oracles

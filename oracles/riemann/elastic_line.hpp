#pragma once
// Linear elastic waves from any piecewise uniform state of an infinite line: d'Alembert's solution.
#include <algorithm>
#include <vector>

#include "oracles/riemann/elastic_laws.hpp"
#include "oracles/riemann/elastic_state.hpp"

namespace ordo::oracles {

/// The line at one time: uniform pieces, each from its begin to that of the next one.
struct ElasticProfile {
    struct Piece {
        double x;  ///< where it begins, in space; the first one has no begin and ends where the second begins
        double X;  ///< the same in the reference
        elastic::State state;
    };
    std::vector<Piece> pieces;  ///< by rising x; some may be empty

    /// Calls visit(piece, from, to) for each stretch of a piece within [a, b].
    template <class Visit>
    void over(double a, double b, Visit&& visit) const {
        for (auto piece = pieces.begin() + (&at(a) - pieces.data()); piece != pieces.end() && a < b; ++piece) {
            const double to = piece + 1 == pieces.end() ? b : std::min(b, (piece + 1)->x);
            if (to > a) visit(*piece, a, to);
            a = std::max(a, to);
        }
    }

    const Piece& at(double x) const;   ///< the one on the right at a border
    double reference(double x) const;  ///< X(x, t), exact
};

/// rho0 v_t = E lambda_X, lambda_t = v_X, T_t = 0 from cells of uniform stretch, velocity and temperature, the outer
/// two without end. With c = sqrt(E / rho0), and P' = lambda - v/c, Q' = lambda + v/c at t = 0, P = Q = x at the first
/// edge:
///
///   x(X, t) = (P(X - c t) + Q(X + c t)) / 2,   lambda = (P' + Q') / 2,   v = c (Q' - P') / 2,   T(X, t) = T(X, 0)
///
/// which holds until waves meet that crush a piece to lambda <= 0.
///
/// X        position in the reference [m];   x   position in space [m];   t   time [s];   at a jump the state on the
/// right accurate round-off  (gate: tests/oracles/riemann/elastic_line_test.cpp) source   d'Alembert's solution of the
/// wave equation; equations [Walker2017]
class ElasticLine {
public:
    using LinearElastic = elastic::Material<elastic::Linear, elastic::PowerHeat>;

    /// `edges`: the n >= 1 rising borders of n + 1 cells in the reference; `place`: of the first one in space at t = 0.
    /// Throws InputError for data that make no line, and where a piece is crushed from the start.
    ElasticLine(double E, double rho0, double c_v, std::vector<double> edges, std::vector<elastic::State> cells,
                double place);

    double wave_speed() const { return c_; }           ///< in the reference [m/s]
    double crushed_at() const { return crushed_at_; }  ///< until when there is a solution; infinite if for ever [s]
    double position(double X, double t) const;         ///< x(X, t) [m]
    elastic::State state(double X, double t) const;    ///< in the reference
    ElasticProfile profile(double t) const;            ///< in space; throws InputError from crushed_at() on
    elastic::Row fields(const elastic::State& state) const { return elastic::fields_of(material_, state); }
    elastic::Row averages(const ElasticProfile& profile, double a, double b) const;  ///< over a < x < b
    std::vector<double> jumps(double t) const;  ///< places in space where a field jumps at t

private:
    double right_going(double X) const;  // P
    double left_going(double X) const;   // Q
    std::size_t cell(double X) const;

    LinearElastic material_;
    double c_;
    std::vector<double> edges_;
    std::vector<elastic::State> cells_;
    std::vector<double> P_, Q_;              ///< at the edges
    std::vector<double> P_slope_, Q_slope_;  ///< in the cells
    double crushed_at_;
};

}  // namespace ordo::oracles

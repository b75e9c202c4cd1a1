#pragma once
// Moving least squares in one dimension: a local polynomial through what lies near, by weights on the particles'
// values.
#include <array>
#include <span>
#include <vector>

#include "solvers/instruction_set.hpp"

namespace ordo::solvers::mpm {

/// Weights phi with sum phi_p f(x_p) = P(at), P the polynomial of `degree` that fits f best near `at`; exact for
/// polynomials of that degree to about 1e-13 of their size. Memory is kept from one fit to the next. The same bits
/// whatever the instruction set.
class MovingLeastSquares {
public:
    static constexpr int highest_degree = 6;

    explicit MovingLeastSquares(int degree) : degree_(degree) {}

    /// x: rising positions of the particles. places: where values are wanted; where they rise, windows cost no search.
    /// Their windows have the given radius, widened until they hold `fewest` particles. False where there are not so
    /// many, or where they do not determine a polynomial.
    bool fit(std::span<const double> x, std::span<const double> places, double radius, std::size_t fewest);

    /// out_k = sum_p phi_kp f_p for each place k of the last fit.
    void sample(std::span<const double> f, std::span<double> out) const;

    /// The window about a place: particles `first` to `last`, one beyond.
    struct Window {
        std::size_t first = 0, last = 0;
    };
    Window window(std::size_t place) const { return windows_[place]; }
    double weight(std::size_t place, std::size_t p) const;  ///< phi of particle p of that window

    static constexpr std::size_t together = 8;
    /// One number for each of the neighbouring places that are fitted together.
    struct alignas(64) Lanes : std::array<double, together> {};
    /// Their weights, on all particles from the first of any window to the last: 0 outside a place's own.
    struct Group {
        Window span;
        std::size_t phi;  ///< where those of the span's first particle are
    };

private:
    int degree_;
    InstructionSet set_ = instruction_set();
    std::vector<Window> windows_;
    std::vector<Group> groups_;
    std::vector<Lanes> phi_;
};

}  // namespace ordo::solvers::mpm

#pragma once
// Moving least squares in one dimension: a local polynomial through what lies near, by weights on the particles'
// values.
#include <array>
#include <span>
#include <vector>

#include "solvers/instruction_set.hpp"

namespace ordo::solvers::mpm {

/// Weights phi with sum phi_k f(x_k) = P(at), P the polynomial of `degree` that fits f best near `at`; exact for
/// polynomials of that degree to about 1e-13 of their size. Windows are found from those of the call before, so that
/// rising places cost no search. The same bits whatever the instruction set.
class MovingLeastSquares {
public:
    static constexpr int highest_degree = 6;
    static constexpr std::size_t together = 8;  ///< places of one fit, at most

    /// x: rising positions.
    MovingLeastSquares(std::span<const double> x, int degree) : x_(x), degree_(degree) {}

    /// Windows of the given radius about some rising places, each widened until it holds `fewest` particles. False
    /// where there are not so many, or where they do not determine a polynomial.
    bool fit(std::span<const double> places, double radius, std::size_t fewest);

    /// The window about one of the places: particles `first` to `last`, one beyond.
    struct Window {
        std::size_t first = 0, last = 0;
    };
    Window window(std::size_t place) const { return windows_[place]; }
    /// Weight of particle p of that window.
    double weight(std::size_t place, std::size_t p) const { return phi_[(p - low_) * together + place]; }

private:
    bool widen(Window& window, double at, double& radius, std::size_t fewest) const;

    std::span<const double> x_;
    int degree_;
    InstructionSet set_ = instruction_set();
    std::array<Window, together> windows_{};
    std::size_t low_ = 0;      ///< first particle of any window
    std::vector<double> phi_;  ///< of the particles from `low` on, `together` numbers each
};

}  // namespace ordo::solvers::mpm

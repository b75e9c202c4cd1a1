#pragma once
// Moving least squares in one dimension: a local polynomial through what lies near, by weights on the particles'
// values.
#include <span>
#include <vector>

namespace ordo::solvers::mpm {

/// Weights phi with sum phi_k f(x_k) = P(at), P the polynomial of `degree` that fits f best near `at`; exact for
/// polynomials of that degree to about 1e-13 of their size. The window is found from that of the call before, so that
/// rising places cost no search.
class MovingLeastSquares {
public:
    static constexpr int highest_degree = 6;

    /// x: rising positions.
    MovingLeastSquares(std::span<const double> x, int degree) : x_(x), degree_(degree) {}

    /// Window of the given radius, widened until it holds `fewest` particles. False where there are not so many.
    bool fit(double at, double radius, std::size_t fewest);

    std::size_t first() const { return first_; }                 ///< of the window
    const std::vector<double>& weights() const { return phi_; }  ///< of the window's particles

private:
    template <int degree>
    bool solve(double at, double radius);

    std::span<const double> x_;
    int degree_;
    std::size_t first_ = 0;
    std::size_t last_ = 0;  ///< one beyond
    std::vector<double> phi_;
};

}  // namespace ordo::solvers::mpm

#pragma once
// Three ways from particles to places: each is prepared for the positions once and then takes any number of fields.
#include <array>
#include <span>
#include <vector>

#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/reconstruction/cubic_spline.hpp"
#include "solvers/mpm/reconstruction/least_squares.hpp"

namespace ordo::solvers::mpm {

/// What samplers are told: rising positions of the particles and their volumes, and the places wanted, rising too.
struct Layout {
    std::span<const double> x, volume, places;
};

/// f of the particles -> its values at the places, through the not-a-knot spline.
class SplineSampler {
public:
    void prepare(const Layout& layout);
    void sample(std::span<const double> f, std::span<double> out);

private:
    std::vector<double> x_, places_;
    CubicSpline spline_;
};

/// By moving least squares, within a radius.
class MovingSampler {
public:
    explicit MovingSampler(int degree) : degree_(degree), mls_(degree) {}
    void prepare(const Layout& layout, double radius);
    void sample(std::span<const double> f, std::span<double> out) const { mls_.sample(f, out); }

private:
    int degree_;
    MovingLeastSquares mls_;
};

/// Cell by cell, by the functions 1, xi and xi^2/2 - 1/6 on the cell from -1 to 1 about the mean that the cell's
/// particles have: sum over the cell of V f / length. Fewer than three particles: fewer functions. An integral over a
/// cell by a rule that is exact for the second and the third function is that of the particles: sum V f.
class TaylorSampler {
public:
    /// A stretch of a cell with as many places as every other one.
    struct Stretch {
        double from, to;
    };
    void prepare(const Layout& layout, std::span<const Stretch> stretches);
    void sample(std::span<const double> f, std::span<double> out) const;

private:
    struct Part {
        Stretch stretch;
        std::size_t first, last;  ///< particles
    };
    std::vector<double> x_, volume_, places_;
    std::vector<Part> parts_;
};

}  // namespace ordo::solvers::mpm

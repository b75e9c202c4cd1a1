#include "solvers/mpm/reconstruction/samplers.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/text.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::mpm {
namespace {

[[noreturn]] void too_few(double at) {
    throw Diverged("too few particles near x = " + shortest(at) + " to reconstruct their fields");
}

/// The three functions at xi in [-1, 1]; the second and the third have mean zero.
Eigen::Vector3d taylor(double xi) { return {1, xi, 0.5 * xi * xi - 1.0 / 6}; }

}  // namespace

void SplineSampler::prepare(const Layout& layout) {
    if (layout.x.size() < 4) too_few(layout.x.front());
    x_.assign(layout.x.begin(), layout.x.end());
    places_.assign(layout.places.begin(), layout.places.end());
}

void SplineSampler::sample(std::span<const double> f, std::span<double> out) {
    spline_.fit(x_, f);
    for (std::size_t k = 0; k < places_.size(); ++k) out[k] = spline_(places_[k]);
}

void MovingSampler::prepare(const Layout& layout, double radius) {
    const auto fewest = static_cast<std::size_t>(degree_ == 1 ? 2 : degree_ + 2);
    if (mls_.fit(layout.x, layout.places, radius, fewest)) return;
    for (const double& at : layout.places) {
        if (!mls_.fit(layout.x, std::span(&at, 1), radius, fewest)) too_few(at);
    }
}

void TaylorSampler::prepare(const Layout& layout, std::span<const Stretch> stretches) {
    x_.assign(layout.x.begin(), layout.x.end());
    volume_.assign(layout.volume.begin(), layout.volume.end());
    places_.assign(layout.places.begin(), layout.places.end());
    parts_.clear();
    std::size_t first = 0;
    for (std::size_t k = 0; k < stretches.size(); ++k) {
        std::size_t last = first;
        while (last < x_.size() && (x_[last] < stretches[k].to || k + 1 == stretches.size())) ++last;
        parts_.push_back({stretches[k], first, last});
        first = last;
    }
}

void TaylorSampler::sample(std::span<const double> f, std::span<double> out) const {
    const std::size_t places_a_part = places_.size() / parts_.size();
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        const auto& [stretch, first, last] = parts_[k];
        const double length = stretch.to - stretch.from;
        const auto psi_at = [&, from = stretch.from, to = stretch.to](double x) {
            return taylor((2 * x - from - to) / length);
        };
        Eigen::Vector3d c = Eigen::Vector3d::Zero();
        for (std::size_t p = first; p < last; ++p) c[0] += volume_[p] * f[p] / length;
        Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
        Eigen::Vector2d right = Eigen::Vector2d::Zero();
        for (std::size_t p = first; p < last; ++p) {
            const Eigen::Vector2d psi = psi_at(x_[p]).tail<2>();
            normal += psi * psi.transpose();
            right += psi * (f[p] - c[0]);
        }
        if (last - first == 2) c[1] = right[0] / normal(0, 0);
        if (last - first > 2) c.tail<2>() = normal.ldlt().solve(right);
        for (std::size_t place = k * places_a_part; place < (k + 1) * places_a_part; ++place)
            out[place] = c.dot(psi_at(places_[place]));
    }
}

}  // namespace ordo::solvers::mpm

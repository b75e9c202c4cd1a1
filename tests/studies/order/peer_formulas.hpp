#pragma once
// Orders as public tools compute them, written from their documented formulas, to be set beside ours.
#include <algorithm>
#include <cmath>
#include <vector>

#include "studies/order/order_fit.hpp"

namespace ordo::peers {

using Points = std::vector<studies::FitPoint>;  ///< coarse to fine

/// deal.II, MFEM, DUNE: the order between the two finest points.
inline double last_neighbour(const Points& points) {
    return studies::neighbour_order(points[points.size() - 2], points.back());
}

/// SciML: the mean of |log2| of neighbouring errors' ratio, whatever the ratio of the steps.
inline double mean_of_halvings(const Points& points) {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += std::abs(std::log2(points[i - 1].error / points[i].error));
    return sum / static_cast<double>(points.size() - 1);
}

/// MOOSE, PETSc, Polaris: the slope of the least-squares line through all logarithms.
inline double slope_of_all(const Points& points) {
    double x = 0, y = 0, xx = 0, xy = 0;
    const auto n = static_cast<double>(points.size());
    for (const auto& point : points) {
        x += std::log(point.abscissa) / n;
        y += std::log(point.error) / n;
    }
    for (const auto& point : points) {
        xx += std::pow(std::log(point.abscissa) - x, 2);
        xy += (std::log(point.abscissa) - x) * (std::log(point.error) - y);
    }
    return xy / xx;
}

/// Uintah: a h^b by unweighted least squares of the errors themselves, best b of a fine scan and its refinement.
inline double linear_space_fit(const Points& points) {
    const auto squares = [&](double b) {
        double ee = 0, he = 0, hh = 0;
        for (const auto& [h, e] : points) {
            const double power = std::pow(h / points.front().abscissa, b);
            ee += e * e;
            he += power * e;
            hh += power * power;
        }
        return ee - he * he / hh;
    };
    double best = 0;
    double step = 0.05;
    for (double b = -3; b <= 10; b += step) best = squares(b) < squares(best) ? b : best;
    for (step /= 2; step > 1e-6; step /= 2) {
        const double low = best - step;
        const double high = best + step;
        best = std::min({best, low, high}, [&](double a, double b) { return squares(a) < squares(b); });
    }
    return best;
}

}  // namespace ordo::peers

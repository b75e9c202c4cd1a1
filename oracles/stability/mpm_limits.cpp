#include "oracles/stability/mpm_limits.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>

namespace ordo::oracles {
namespace {

constexpr double pi = boost::math::constants::pi<double>();

/// What C^2 times must not exceed one.
double demand(const TentScheme& scheme, double kappa, double s) {
    const double mu = 1 - (1 - kappa) * s;
    if (scheme.consistent) return mu > 0 ? s / mu : std::numeric_limits<double>::infinity();
    return scheme.order == TentScheme::Order::stress_last ? s * (2 - mu) : s * mu;
}

/// s of the most demanding wave, of those of any length.
double worst_wave(const TentScheme& scheme, double kappa) {
    const bool inside =
        !scheme.consistent && scheme.order == TentScheme::Order::stress_first_or_remapped && kappa < 0.5;
    return inside ? 0.5 / (1 - kappa) : 1;
}

}  // namespace

double saw_tooth_share(std::span<const double> xi) {
    double sum = 0;
    for (const double place : xi) sum += (1 - 2 * place) * (1 - 2 * place);
    return sum / static_cast<double>(xi.size());
}

double largest_courant(const TentScheme& scheme, std::span<const double> xi, int cells) {
    const double kappa = saw_tooth_share(xi);
    if (cells == 0) return 1 / std::sqrt(demand(scheme, kappa, worst_wave(scheme, kappa)));
    double worst = 0;
    for (int n = 1; 2 * n <= cells; ++n)
        worst = std::max(worst, demand(scheme, kappa, std::pow(std::sin(pi * n / cells), 2)));
    return 1 / std::sqrt(worst);
}

double largest_courant_of_one_cell(TentScheme::Order order, double xi) {
    return order == TentScheme::Order::stress_last ? 2 * std::sqrt(xi / (2 - xi)) : 2;
}

double largest_courant_of_elements(int elements, bool free_end) {
    const double quarter_waves = free_end ? 2 * elements - 1 : 2 * elements - 2;
    return 1 / std::sin(pi * quarter_waves / (4 * elements));
}

}  // namespace ordo::oracles

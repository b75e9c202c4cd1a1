#pragma once
// The bootstrap of an order: what the order would be, had the residuals fallen otherwise.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "studies/order/models.hpp"

namespace ordo::studies {

struct Drawn {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

/// The 2.5 and 97.5 % quantiles of 199 orders refitted to the model plus its residuals, drawn with replacement and
/// enlarged by sqrt(n/(n - k)); the empty interval below eight points. The draws are the same for every series.
/// `refit(series)` fits again.
template <class Refit>
Drawn bootstrap_of_order(const LogSeries& series, const LeastSquares& fit, Refit&& refit) {
    constexpr int draws = 199;
    const Eigen::Index n = series.size();
    Drawn drawn;
    if (n < 8) return drawn;
    const double enlarged = std::sqrt(static_cast<double>(n) / static_cast<double>(n - fit.parameters.size()));
    std::mt19937_64 random(1);
    std::vector<double> orders;
    LogSeries other = series;
    for (int k = 0; k < draws; ++k) {
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto j = static_cast<Eigen::Index>(random() % static_cast<std::uint64_t>(n));
            other.y[i] = series.y[i] - fit.residuals[i] + enlarged * fit.residuals[j];
        }
        const LeastSquares again = refit(other);
        if (again.found) orders.push_back(again.parameters[1]);
    }
    if (orders.size() < draws / 2) return drawn;
    std::sort(orders.begin(), orders.end());
    const auto cut = orders.size() / 40;
    return {orders[cut], orders[orders.size() - 1 - cut]};
}

}  // namespace ordo::studies

#include "reports/gate/steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "studies/order/distributions.hpp"

namespace ordo::reports {
namespace {

constexpr double false_alarms = 1e-5;     ///< wanted share of series of noise with a step
constexpr double normal_median = 0.6745;  ///< of the size of a standard normal number

/// Values of one place as one.
struct Place {
    double mean = 0;
    double count = 0;
};

Place place_of(const std::vector<double>& values) {
    Place place{0, static_cast<double>(values.size())};
    double count = 0;
    for (const double value : values) place.mean += (value - place.mean) / ++count;
    return place;
}

/// Standard deviation, and how many numbers it rests on.
struct Noise {
    double deviation = 0;
    double freedom = 0;
};

Noise noise_at(const std::vector<std::vector<double>>& places) {
    double squares = 0;
    double freedom = 0;
    for (const auto& values : places) {
        const double mean = place_of(values).mean;
        if (std::isnan(mean)) continue;
        for (const double value : values) squares += (value - mean) * (value - mean);
        freedom += static_cast<double>(values.size()) - 1;
    }
    return {freedom > 0 ? std::sqrt(squares / freedom) : 0, freedom};
}

Noise noise_between(const std::vector<Place>& places) {
    std::vector<double> differences;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double size = std::sqrt(1 / places[i - 1].count + 1 / places[i].count);
        const double difference = std::abs(places[i].mean - places[i - 1].mean) / size;
        if (!std::isnan(difference)) differences.push_back(difference);
    }
    if (differences.size() + 1 < places_for_noise) return {};
    const auto middle = differences.begin() + static_cast<std::ptrdiff_t>((differences.size() - 1) / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    return {*middle / normal_median, static_cast<double>(differences.size()) / 2};
}

double penalty_of(double freedom, std::size_t places) {
    const double tail = false_alarms / (2 * static_cast<double>(places));
    const double bound = studies::student_bound(std::max(freedom, 1.0), tail);
    return bound * bound;
}

/// Where the segments of the cheapest piecewise-constant fit begin, the first at 0. Values are in units of the noise.
std::vector<std::size_t> segments(const std::vector<Place>& places, double penalty) {
    const std::size_t n = places.size();
    std::vector<double> cost(n + 1, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> begin(n + 1, 0);
    cost[0] = -penalty;
    for (std::size_t end = 1; end <= n; ++end) {
        Place sum;
        double squares = 0;  // about the mean, updated so that equal values give 0 exactly
        for (std::size_t first = end; first-- > 0;) {
            const auto& [mean, count] = places[first];
            const double delta = mean - sum.mean;
            squares += delta * delta * sum.count * count / (sum.count + count);
            sum.mean += delta * count / (sum.count + count);
            sum.count += count;
            const double total = cost[first] + squares + penalty;
            if (total < cost[end]) std::tie(cost[end], begin[end]) = std::pair(total, first);
        }
    }
    std::vector<std::size_t> starts;
    for (std::size_t end = n; end > 0; end = begin[end]) starts.push_back(begin[end]);
    std::ranges::reverse(starts);
    return starts;
}

double level_of(const std::vector<Place>& places, std::size_t first, std::size_t end) {
    Place sum;
    for (std::size_t i = first; i < end; ++i) {
        sum.count += places[i].count;
        sum.mean += (places[i].mean - sum.mean) * places[i].count / sum.count;
    }
    return sum.mean;
}

/// Levels of the places [first, end), all of them numbers; appended.
void add_levels(const std::vector<Place>& places, std::size_t first, std::size_t end, double noise, double penalty,
                std::vector<std::pair<std::size_t, double>>& levels) {
    std::vector<Place> scaled;
    for (std::size_t i = first; i < end; ++i)
        scaled.push_back({(places[i].mean - places[first].mean) / noise, places[i].count});
    const auto starts = segments(scaled, penalty);
    for (std::size_t k = 0; k < starts.size(); ++k) {
        const std::size_t next = k + 1 < starts.size() ? starts[k + 1] : end - first;
        levels.emplace_back(first + starts[k], level_of(places, first + starts[k], first + next));
    }
}

}  // namespace

Steps steps_in(const std::vector<std::vector<double>>& values, double least) {
    std::vector<Place> places;
    double largest = 0;
    for (const auto& at_place : values) {
        places.push_back(place_of(at_place));
        if (std::isfinite(places.back().mean)) largest = std::max(largest, std::abs(places.back().mean));
    }
    if (places.empty()) return {};
    const Noise here = noise_at(values);
    const Noise between = noise_between(places);
    const double penalty = penalty_of(here.freedom + between.freedom, places.size());
    // A change by `least` between two places of one value each costs least^2 / 2: twice the penalty.
    const double floor = std::max(least / (2 * std::sqrt(penalty)), 1e-140 * std::max(largest, 1e-150));
    Steps found{{}, std::max({here.deviation, between.deviation, floor}), between.freedom == 0};

    std::vector<std::pair<std::size_t, double>> levels;
    for (std::size_t i = 0; i < places.size();) {
        const bool number = std::isfinite(places[i].mean);
        std::size_t end = i;
        while (end < places.size() && std::isfinite(places[end].mean) == number) ++end;
        if (number) add_levels(places, i, end, found.noise, penalty, levels);
        else levels.emplace_back(i, std::numeric_limits<double>::quiet_NaN());
        i = end;
    }
    for (std::size_t k = 1; k < levels.size(); ++k)
        found.steps.push_back({levels[k].first, levels[k - 1].second, levels[k].second});
    return found;
}

}  // namespace ordo::reports

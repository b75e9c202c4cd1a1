#include "oracles/features.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ordo::oracles {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A step aside that stays on the state beside the wave.
double step_beside(const WaveSides& sides) {
    const double room = std::min(sides.wave.left - sides.before, sides.after - sides.wave.right);
    if (std::isfinite(room)) return 1e-9 * room;
    return sides.wave.left == 0 ? std::numeric_limits<double>::min() : 1e-9 * std::abs(sides.wave.left);
}

std::vector<double> row_of(const Exact& exact, double x, double t) {
    std::vector<double> row(exact.width());
    exact.sample(std::span(&x, 1), t, row);
    return row;
}

void add_features(const WaveSides& sides, std::size_t offset, double size, Feature::Kind acoustic,
                  std::vector<Feature>& features) {
    const auto& [kind, left, right] = sides.wave;
    const bool vacuum_left = sides.to_vacuum(false), vacuum_right = sides.to_vacuum(true);
    const bool changes = sides.changes(offset, size);
    if (kind != Wave::Kind::fan) {
        const auto own = kind == Wave::Kind::shock ? acoustic : Feature::Kind::contact;
        if (vacuum_left || vacuum_right) features.push_back({Feature::Kind::singular, left});
        else if (changes) features.push_back({own, left});
        return;
    }
    const auto add_corner = [&](double x, bool vacuum) {
        if (vacuum) features.push_back({Feature::Kind::singular, x});
        else if (changes) features.push_back({Feature::Kind::fan_corner, x, 1});
    };
    add_corner(left, vacuum_left);
    add_corner(right, vacuum_right);
}

}  // namespace

bool WaveSides::changes(std::size_t offset, double size) const {
    const auto differ = [&](double a, double b) { return !(std::abs(a - b) <= 1e-9 * size); };
    const bool within = wave.kind == Wave::Kind::fan && differ(left[offset], middle[offset]);
    return within || differ(left[offset], right[offset]);
}

bool WaveSides::to_vacuum(bool on_right) const {
    return std::ranges::any_of(on_right ? right : left, [](double value) { return std::isnan(value); });
}

std::vector<WaveSides> sides_of_waves(const Exact& exact, double t) {
    const auto waves = exact.waves ? exact.waves(t) : std::vector<Wave>{};
    std::vector<WaveSides> all;
    for (std::size_t i = 0; i < waves.size(); ++i) {
        WaveSides sides{.wave = waves[i],
                        .before = i == 0 ? -infinity : waves[i - 1].right,
                        .after = i + 1 == waves.size() ? infinity : waves[i + 1].left};
        const double step = step_beside(sides);
        sides.left = row_of(exact, sides.wave.left - step, t);
        sides.right = row_of(exact, sides.wave.right + step, t);
        sides.middle = row_of(exact, 0.5 * (sides.wave.left + sides.wave.right), t);
        all.push_back(std::move(sides));
    }
    return all;
}

double size_beside(const std::vector<WaveSides>& waves, std::size_t offset) {
    double size = 0;
    for (const auto& sides : waves)
        size = std::max({size, std::abs(sides.left[offset]), std::abs(sides.right[offset])});
    return size;
}

Exact::Features features_of_waves(const Exact& exact, Feature::Kind acoustic) {
    return [exact, acoustic](const std::string& field, double t) {
        std::vector<Feature> features;
        const auto offset = exact.offset(field).value();
        const auto waves = sides_of_waves(exact, t);
        const double size = size_beside(waves, offset);
        for (const auto& sides : waves) add_features(sides, offset, size, acoustic, features);
        return features;
    };
}

Exact::Features with_singular_centre(Exact::Features features, bool singular) {
    return [features = std::move(features), singular](const std::string& field, double t) {
        auto all = features(field, t);
        if (singular) all.push_back({Feature::Kind::singular, 0});
        return all;
    };
}

std::vector<double> places_of_features(const Exact& exact, double t) {
    std::vector<double> places;
    if (!exact.features) return places;
    for (const auto& field : exact.fields) {
        for (const auto& feature : exact.features(field.name, t)) places.push_back(feature.x);
    }
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

std::string text_of(Feature::Kind kind) {
    static const std::array<const char*, 5> words{"shock", "contact", "linear", "fan_corner", "singular"};
    return words.at(static_cast<std::size_t>(kind));
}

}  // namespace ordo::oracles

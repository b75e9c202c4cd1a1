#include "studies/engine/profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ordo::studies {
namespace {

/// Whether `level` lies between two different values or is one of them.
bool between(double level, double a, double b) { return a != b && std::min(a, b) <= level && level <= std::max(a, b); }

}  // namespace

double Profile::crossing(double level, double x, double from, double to) const {
    double nearest = std::numeric_limits<double>::quiet_NaN();
    const auto offer = [&](double place) {
        if (place < from || place > to) return;
        if (!(std::abs(place - x) >= std::abs(nearest - x))) nearest = place;
    };
    for (std::size_t i = 0; i < cells(); ++i) {
        if (edges[i] > to || edges[i + 1] < from) continue;
        const double left = at_left(i), right = at_right(i);
        if (i > 0 && between(level, at_right(i - 1), left)) offer(edges[i]);
        if (between(level, left, right)) offer(edges[i] + (level - left) / (right - left) * (edges[i + 1] - edges[i]));
    }
    return nearest;
}

}  // namespace ordo::studies

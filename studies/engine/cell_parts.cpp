#include "studies/engine/cell_parts.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>

#include "oracles/features.hpp"

namespace ordo::studies {
namespace {

using oracles::Exact;
using oracles::Wave;

/// Where the exact solution is not smooth, the quarters of its fans, and `near` on both sides of these places: inside
/// (low, high), rising.
std::vector<double> cuts_of(const Exact& exact, const std::vector<Wave>& waves, const std::vector<double>& masked,
                            double near, double t, double low, double high) {
    std::vector<double> places = exact.jumps ? exact.jumps(t) : std::vector<double>{};
    for (const auto& wave : waves) {
        const double quarter = 0.25 * (wave.right - wave.left);
        places.insert(places.end(), {wave.left, wave.left + quarter, wave.right - quarter, wave.right});
    }
    for (const double x : masked) places.insert(places.end(), {x - near, x + near});
    std::erase_if(places, [&](double x) { return !(x > low && x < high); });
    std::ranges::sort(places);
    return places;
}

bool in_middle_of_fan(const std::vector<Wave>& waves, double x) {
    return std::ranges::any_of(waves, [&](const Wave& wave) {
        const double quarter = 0.25 * (wave.right - wave.left);
        return wave.kind == Wave::Kind::fan && x > wave.left + quarter && x < wave.right - quarter;
    });
}

}  // namespace

const Kronrod& kronrod() {
    using Fine = boost::math::quadrature::gauss_kronrod<double, 15>;
    using Coarse = boost::math::quadrature::gauss<double, 7>;
    static const Kronrod made = [] {
        Kronrod rule;
        rule.place.front() = 1e-6;
        rule.place.back() = 1 - 1e-6;
        for (std::size_t k = 0; k < 8; ++k) {
            for (const std::size_t i : {8 - k, 8 + k}) {
                rule.place[i] = 0.5 + (i < 8 ? -0.5 : 0.5) * Fine::abscissa()[k];
                rule.weight[i] = 0.5 * Fine::weights()[k];
                rule.coarse[i] = k % 2 == 0 ? 0.5 * Coarse::weights()[k / 2] : 0;
            }
        }
        rule.barycentric.fill(1);
        for (std::size_t i = 0; i < Kronrod::size; ++i) {
            for (std::size_t j = 0; j < Kronrod::size; ++j) {
                if (i != j) rule.barycentric[i] /= 4 * (rule.place[i] - rule.place[j]);
            }
        }
        return rule;
    }();
    return made;
}

double Kronrod::interpolated(const Values& values, double s) const {
    double above = 0, below = 0;
    for (std::size_t i = 0; i < size; ++i) {
        if (s == place[i]) return values[i];
        const double share = barycentric[i] / (s - place[i]);
        above += share * values[i];
        below += share;
    }
    return above / below;
}

double Kronrod::integral(const Values& values, double from, double to) const {
    using Exact = boost::math::quadrature::gauss<double, 10>;  // for degrees up to 19; ours is 16
    return Exact::integrate([&](double s) { return interpolated(values, s); }, from, to);
}

std::vector<double> Kronrod::sign_changes(const Values& values, double noise) const {
    std::vector<double> places;
    const auto value = [&](double s) { return interpolated(values, s); };
    const auto close = [](double a, double b) { return b - a <= 1e-9; };
    std::size_t before = size;
    for (std::size_t i = 0; i < size; ++i) {
        if (!(std::abs(values[i]) > noise)) continue;
        if (before < i && (values[before] > 0) != (values[i] > 0)) {
            std::uintmax_t steps = 60;
            const auto [a, b] = boost::math::tools::toms748_solve(value, place[before], place[i], values[before],
                                                                  values[i], close, steps);
            places.push_back(0.5 * (a + b));
        }
        before = i;
    }
    return places;
}

bool is_near(double x, std::span<const double> places, double near) {
    return std::ranges::any_of(places, [&](double place) { return std::abs(x - place) <= near; });
}

std::vector<CellPart> parts_of(const Exact& exact, double t, std::span<const double> edges, double near) {
    const auto waves = exact.waves ? exact.waves(t) : std::vector<Wave>{};
    const auto masked = near > 0 ? oracles::places_of_features(exact, t) : std::vector<double>{};
    const auto cuts = cuts_of(exact, waves, masked, near, t, edges.front(), edges.back());
    std::vector<CellPart> parts;
    auto cut = cuts.begin();
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        for (double a = edges[i]; a < edges[i + 1];) {
            while (cut != cuts.end() && *cut <= a) ++cut;
            const double b = cut == cuts.end() ? edges[i + 1] : std::min(*cut, edges[i + 1]);
            const double middle = 0.5 * (a + b);
            const CellPart part{a, b, i, in_middle_of_fan(waves, middle), is_near(middle, masked, near)};
            if (part.has_inside()) parts.push_back(part);
            a = b;
        }
    }
    return parts;
}

std::vector<double> rows_at_nodes(const Exact& exact, double t, std::span<const CellPart> parts) {
    std::vector<double> x;
    x.reserve(parts.size() * Kronrod::size);
    for (const CellPart& part : parts) {
        for (std::size_t i = 0; i < Kronrod::size; ++i) x.push_back(part.node(i));
    }
    std::vector<double> rows(x.size() * exact.width());
    if (!x.empty()) exact.sample(x, t, rows);
    return rows;
}

}  // namespace ordo::studies

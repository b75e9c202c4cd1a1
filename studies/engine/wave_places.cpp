#include "studies/engine/wave_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.hpp"

namespace ordo::studies {
namespace {

using oracles::Exact;
using oracles::Wave;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double inside = 0.05;  // of a fan's width

/// One field of an exact solution at one time.
struct FieldAt {
    const Exact& exact;
    std::size_t offset;
    double t;

    double operator()(double x) const {
        std::vector<double> row(exact.width());
        exact.sample(std::span(&x, 1), t, row);
        return row[offset];
    }
};

/// A wave with room around it: from the last edge of the wave before to the first one of the next.
struct Neighbourhood {
    Wave wave;
    double before, after;

    double from() const { return 0.5 * (before + wave.left); }
    double to() const { return 0.5 * (wave.right + after); }
    /// A step aside that stays on the state beside the wave.
    double step() const {
        const double room = std::min(wave.left - before, after - wave.right);
        if (std::isfinite(room)) return 1e-9 * room;
        return wave.left == 0 ? std::numeric_limits<double>::min() : 1e-9 * std::abs(wave.left);
    }
    double state_before(const FieldAt& field) const { return field(wave.left - step()); }
    double state_after(const FieldAt& field) const { return field(wave.right + step()); }
};

std::vector<Neighbourhood> neighbourhoods(const std::vector<Wave>& waves) {
    std::vector<Neighbourhood> all;
    for (std::size_t i = 0; i < waves.size(); ++i) {
        const double before = i == 0 ? -infinity : waves[i - 1].right;
        all.push_back({waves[i], before, i + 1 == waves.size() ? infinity : waves[i + 1].left});
    }
    return all;
}

Wave::Kind kind_of(Norm norm) {
    return norm == Norm::shock ? Wave::Kind::shock : norm == Norm::contact ? Wave::Kind::contact : Wave::Kind::fan;
}

}  // namespace

std::vector<WaveMark> marks_of(Norm kind, const Exact& exact, std::size_t offset, double t) {
    const FieldAt field{exact, offset, t};
    const auto all = neighbourhoods(exact.waves ? exact.waves(t) : std::vector<Wave>{});
    double size = 0;
    for (const auto& around : all)
        size = std::max({size, std::abs(around.state_before(field)), std::abs(around.state_after(field))});
    std::vector<WaveMark> marks;
    for (const auto& around : all) {
        const auto& [of, left, right] = around.wave;
        const double before = around.state_before(field), after = around.state_after(field);
        if (of != kind_of(kind) || !(std::abs(after - before) > 1e-9 * size)) continue;
        if (of != Wave::Kind::fan) {
            marks.push_back({left, 0.5 * (before + after), around.from(), around.to()});
            continue;
        }
        const double a = left + inside * (right - left), b = right - inside * (right - left);
        const double middle = 0.5 * (left + right);
        marks.push_back({a, field(a), around.from(), middle});
        marks.push_back({b, field(b), middle, around.to()});
    }
    return marks;
}

std::string why_nothing_of(Norm kind, const Exact& exact, const std::string& field, double t) {
    if (!exact.waves) return "the exact solution does not tell where its waves are";
    const auto waves = exact.waves(t);
    const auto of = kind_of(kind);
    const std::string name = of == Wave::Kind::fan ? "fan" : text_of(kind);
    if (std::ranges::none_of(waves, [&](const Wave& wave) { return wave.kind == of; }))
        return "the exact solution has no " + name + " at t = " + shortest(t);
    if (!is_place(kind)) return "";
    const auto offset = exact.offset(field);
    if (offset && !marks_of(kind, exact, *offset, t).empty()) return "";
    return "the field '" + field + "' is the same on both sides of every " + name + " at t = " + shortest(t);
}

double place_error(const Profile& found, const std::vector<WaveMark>& marks) {
    double largest = std::numeric_limits<double>::quiet_NaN();
    for (const auto& [x, level, from, to] : marks) {
        if (x < found.edges.front() || x > found.edges.back()) continue;
        const double error = std::abs(found.crossing(level, x, from, to) - x);
        if (std::isnan(error)) return error;
        if (!(error <= largest)) largest = error;
    }
    return largest;
}

}  // namespace ordo::studies

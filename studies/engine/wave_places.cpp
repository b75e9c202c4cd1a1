#include "studies/engine/wave_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.hpp"
#include "oracles/features.hpp"

namespace ordo::studies {
namespace {

using oracles::Exact;
using oracles::Wave;

constexpr double inside = 0.05;  // of a fan's width

Wave::Kind kind_of(Norm norm) {
    return norm == Norm::shock ? Wave::Kind::shock : norm == Norm::contact ? Wave::Kind::contact : Wave::Kind::fan;
}

}  // namespace

std::vector<WaveMark> marks_of(Norm kind, const Exact& exact, std::size_t offset, double t) {
    const auto value_at = [&](double x) {
        std::vector<double> row(exact.width());
        exact.sample(std::span(&x, 1), t, row);
        return row[offset];
    };
    const auto all = oracles::sides_of_waves(exact, t);
    const double size = oracles::size_beside(all, offset);
    std::vector<WaveMark> marks;
    for (const auto& sides : all) {
        const auto& [of, left, right] = sides.wave;
        const double from = 0.5 * (sides.before + left), to = 0.5 * (right + sides.after);
        const double before = sides.left[offset], after = sides.right[offset];
        if (of != kind_of(kind) || !(std::abs(after - before) > 1e-9 * size)) continue;
        if (of != Wave::Kind::fan) {
            marks.push_back({left, 0.5 * (before + after), from, to});
            continue;
        }
        const double a = left + inside * (right - left), b = right - inside * (right - left);
        const double middle = 0.5 * (left + right);
        marks.push_back({a, value_at(a), from, middle});
        marks.push_back({b, value_at(b), middle, to});
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

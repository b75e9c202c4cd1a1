#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "studies/reader/parts.hpp"
#include "studies/amplification/figures.hpp"

namespace ordo::studies {
namespace {

double above_zero(const Node& node, const std::string& member, double fallback) {
    if (!node.has(member)) return fallback;
    const double value = node.at(member).number();
    if (!(value > 0) || !std::isfinite(value)) node.at(member).refuse("is " + shortest(value) + ", but must be > 0");
    return value;
}

/// [from, to] of the Courant numbers that are tried.
void read_bracket(const Node& node, Stability& asked) {
    if (!node.has("between")) return;
    const auto ends = node.at("between").items();
    if (ends.size() != 2) node.at("between").refuse("must hold two Courant numbers");
    asked.from = ends[0].number();
    asked.to = ends[1].number();
    if (!(asked.from > 0 && asked.from < asked.to) || !std::isfinite(asked.to))
        node.at("between").refuse("must hold two rising Courant numbers > 0");
}

}  // namespace

Measure stability_from(const Node& node, const Study& study) {
    node.only({"stability", "crossings", "between", "tolerance", "growth", "motion"});
    Measure measure;
    Stability& asked = measure.stability.emplace();
    asked.crossings = above_zero(node, "crossings", asked.crossings);
    asked.tolerance = above_zero(node, "tolerance", asked.tolerance);
    asked.as_scene = node.has("motion") && node.at("motion").one_of({"noise", "scene"}) == 1;
    // Noise in a stable scheme is enlarged too, as the eigenvectors are far from orthogonal, but never a thousand times.
    asked.growth = above_zero(node, "growth", asked.as_scene ? 10 : 1000);
    if (!(asked.growth > 1)) node.at("growth").refuse("is " + shortest(asked.growth) + ", but must be > 1");
    if (asked.crossings > 1e6) node.at("crossings").refuse("is " + shortest(asked.crossings) + ", but at most 1e6");
    read_bracket(node, asked);
    const bool swept = std::ranges::find(study.sweep.axes, "courant", &Axis::name) != study.sweep.axes.end();
    for (const auto& item : node.at("stability").items()) {
        item.one_of(stability_names());
        const std::string name = item.text();
        if (is_at_courant(name) && !swept)
            item.refuse("is '" + name + "', a figure of one Courant number: sweep 'courant'");
        if (!is_at_courant(name) && name != "limit_by_theory" && swept)
            item.refuse("is '" + name + "', a limit of all Courant numbers: 'courant' must not be swept");
        if (std::ranges::find(measure.quantities, name, &Quantity::field) != measure.quantities.end())
            item.refuse("repeats '" + name + "'");
        measure.quantities.push_back({.field = name, .norm = Norm::value});
    }
    if (measure.quantities.empty()) node.at("stability").refuse("is an empty list");
    return measure;
}

}  // namespace ordo::studies

#include <algorithm>
#include <cmath>
#include <regex>

#include "core/text.hpp"
#include "oracles/features.hpp"
#include "solvers/solver.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/engine/wave_places.hpp"
#include "studies/reader/parts.hpp"

namespace ordo::studies {
namespace {

oracles::Exact truth_of(const Study& study) { return scene_named(study.scene.name, "").truth(study.scene.values); }

solvers::Scene problem_of(const Study& study) { return scene_named(study.scene.name, "").problem(study.scene.values); }

/// Every solver and the exact solution must have each field.
void check_fields(const Node& node, const Study& study) {
    const auto exact = truth_of(study);
    for (const auto& item : node.items()) {
        std::vector<std::string> known;
        for (const auto& field : exact.fields) known.push_back(field.name);
        for (const auto& choice : study.solvers) {
            const auto& offered = solvers::solver_named(choice.name, "").fields;
            std::erase_if(known, [&](const std::string& name) {
                return std::find(offered.begin(), offered.end(), name) == offered.end();
            });
        }
        item.one_of(known);
    }
}

void read_end(const Node& node, const Study& study, Measure& measure) {
    measure.at = node.at("at").number();
    if (node.has("until"))
        measure.until = static_cast<Until>(node.at("until").one_of({"exact", "accumulated", "steps"}));
    if (!(measure.at > 0) || !std::isfinite(measure.at))
        node.at("at").refuse("is " + shortest(measure.at) + ", but must be > 0");
    const Range times = truth_of(study).times;
    if (measure.until != Until::steps && !times.contains(measure.at)) {
        node.at("at").refuse("is " + shortest(measure.at) + ", but the exact solution holds for t " + times.text());
    }
    if (measure.until == Until::steps && measure.at != std::floor(measure.at)) {
        node.at("at").refuse("is " + shortest(measure.at) + ", but must be a whole number of steps");
    }
}

/// The words of a member that stands for one of them or a list; `fallback` where it is absent.
template <class Word>
std::vector<Word> words_from(const Node& node, const std::string& member, const std::vector<std::string>& words,
                             Word fallback) {
    if (!node.has(member)) return {fallback};
    std::vector<Word> found;
    for (const auto& item : node.at(member).items()) found.push_back(static_cast<Word>(item.one_of(words)));
    if (found.empty()) node.at(member).refuse("is an empty list");
    return found;
}

/// Norms about waves want cells, waves, and a field that feels them, as far as that is known before a run.
void check_waves(const Node& node, const Study& study, const Measure& measure) {
    const auto exact = truth_of(study);
    for (const auto& quantity : measure.quantities) {
        if (!is_about_waves(quantity.norm)) continue;
        const std::string norm = "'" + text_of(quantity.norm) + "'";
        const Node norms = node.at("norms");
        if (!solvers::is_line(problem_of(study)))
            norms.refuse(norm + " needs a scene on a line of gas or elastic cells");
        if (quantity.maximum) norms.refuse(norm + " needs 'over' to be 'final': at t = 0 all waves are at one place");
        if (quantity.against != Against::exact) norms.refuse(norm + " needs 'against' to be 'exact'");
        if (measure.until == Until::steps) continue;
        const auto why = why_nothing_of(quantity.norm, exact, quantity.field, measure.at);
        if (!why.empty()) norms.refuse(norm + " has nothing to measure: " + why);
    }
}

/// How far the part near the waves goes; 0 where no norm asks for a part.
double near_from(const Node& node, const std::vector<Norm>& norms) {
    const bool asked = std::ranges::any_of(norms, is_part);
    if (!asked && node.has("near")) node.at("near").refuse("belongs to the norms l1_near and l1_away only");
    if (!asked) return 0;
    const double near = node.at("near").number();
    if (!(near > 0) || !std::isfinite(near)) node.at("near").refuse("is " + shortest(near) + ", but must be > 0");
    return near;
}

/// Parts of l1 want places where the exact solution is not smooth.
void check_parts(const Node& node, const Study& study, const Measure& measure) {
    const auto exact = truth_of(study);
    for (const auto& quantity : measure.quantities) {
        if (!is_part(quantity.norm)) continue;
        const std::string norm = "'" + text_of(quantity.norm) + "'";
        const Node norms = node.at("norms");
        if (quantity.maximum) norms.refuse(norm + " needs 'over' to be 'final': at t = 0 all waves are at one place");
        if (quantity.against == Against::finest) norms.refuse(norm + " needs 'against' to be 'exact'");
        if (!exact.features) norms.refuse(norm + ": the exact solution does not tell where its waves are");
        if (measure.until == Until::steps) continue;
        if (oracles::places_of_features(exact, measure.at).empty())
            norms.refuse(norm + " has nothing to measure: the exact solution is smooth everywhere at t = " +
                         shortest(measure.at) + " (nearest: l1)");
    }
}

std::vector<std::string> orders_against_from(const Node& node, const Study& study) {
    static const std::regex one_over(R"(1/[A-Za-z_]\w*)");
    const auto own = own_abscissae(study.sweep.path);
    auto known = own;
    for (const auto& axis : study.sweep.axes) {
        if (axis.name != "dt" && axis.values.size() > 1) known.push_back(axis.name);
    }
    std::vector<std::string> abscissae;
    for (const auto& item : node.items()) {
        const std::string word = item.text();
        if (std::ranges::find(known, word) == known.end() && !std::regex_match(word, one_over)) {
            item.refuse("is '" + word + "', but must be " + joined(own, " or ") +
                        " (the sweep's path), a swept axis, or one over an axis or a counter of work: '1/ppc', "
                        "'1/steps'" +
                        did_you_mean(word, known));
        }
        if (std::ranges::find(abscissae, word) != abscissae.end()) item.refuse("repeats '" + word + "'");
        abscissae.push_back(word);
    }
    if (abscissae.empty()) node.refuse("is an empty list");
    return abscissae;
}

}  // namespace

Measure measure_from(const Node& node, const Study& study) {
    if (node.has("stability")) return stability_from(node, study);
    node.only({"at", "until", "fields", "norms", "over", "volume", "against", "near", "orders_against"});
    Measure measure;
    read_end(node, study, measure);
    measure.fields = node.at("fields").texts();
    if (measure.fields.empty()) node.at("fields").refuse("is an empty list");
    check_fields(node.at("fields"), study);
    const auto norms = words_from(node, "norms", norm_names(), Norm::rms);
    const double near = near_from(node, norms);
    const bool maximum = node.has("over") && node.at("over").one_of({"final", "maximum"}) == 1;
    const bool undeformed = node.has("volume") && node.at("volume").one_of({"current", "undeformed"}) == 1;
    if (undeformed && !solvers::is_solid(problem_of(study)))
        node.at("volume").refuse("is \"undeformed\", but the scene has no body");
    for (const Against truth : words_from(node, "against", {"exact", "finest", "itself"}, Against::exact)) {
        if (truth == Against::finest && (study.sweep.path != Path::time || maximum)) {
            node.refuse("'against' may be 'finest' only where the sweep's path is 'time' and 'over' is 'final'");
        }
        for (const auto& field : measure.fields) {
            for (const Norm norm : norms)
                measure.quantities.push_back({field, norm, truth, maximum, undeformed, is_part(norm) ? near : 0});
        }
    }
    check_waves(node, study, measure);
    check_parts(node, study, measure);
    if (node.has("orders_against")) measure.orders_against = orders_against_from(node.at("orders_against"), study);
    return measure;
}

}  // namespace ordo::studies

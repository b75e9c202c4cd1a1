#include "studies/engine/expected_order.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "oracles/features.hpp"

namespace ordo::studies {
namespace {

using oracles::Feature;
using Kind = Feature::Kind;

bool holds(const std::vector<std::string>& words, Kind kind) {
    return std::ranges::find(words, oracles::text_of(kind)) != words.end();
}

/// 1/q of the norm L_q.
double inverse_power(Norm norm) { return norm == Norm::linf ? 0 : norm == Norm::rms || norm == Norm::l2 ? 0.5 : 1; }

/// The power of h in the width over which a feature is smeared.
double width_power(const Method& method, Kind kind) {
    const bool steep = kind == Kind::shock || holds(method.steep, kind);
    const double q = method.waves > 0 ? method.waves : method.order;
    return steep ? 1 : q / (q + 1);
}

/// "contact, l1, formal order 2"; "kink, l2, formal order 3, of waves 4"
std::string theory_of(const std::string& what, Norm norm, const Method& method) {
    const bool other = method.waves > 0 && method.waves != method.order;
    return what + ", " + text_of(norm) + ", formal order " + shortest(method.order) +
           (other ? ", of waves " + shortest(method.waves) : "");
}

ExpectedOrder none(const std::string& why) { return {.refused = "theory expects no order: " + why}; }

ExpectedOrder of_place(Norm norm, const Method& method, const std::vector<Feature>& features) {
    if (norm != Norm::shock) return none("it has no rule for the place of a " + text_of(norm));
    if (std::ranges::none_of(features, [](const Feature& feature) { return feature.kind == Kind::shock; }))
        return none("the field has no shock");
    if (holds(method.sharp, Kind::shock)) return none("it has no rule for the place of a shock that is kept sharp");
    return {.order = 1, .theory = theory_of("place of a shock", norm, method)};
}

}  // namespace

std::string words_of(const Feature& feature) {
    switch (feature.kind) {
        case Kind::shock: return "shock";
        case Kind::contact: return "contact";
        case Kind::fan_corner: return "corner of a fan";
        case Kind::singular: return "singular place";
        case Kind::linear: break;
    }
    if (feature.derivative == 0) return "jump of a linear wave";
    return feature.derivative == 1 ? "kink" : "jump in derivative " + std::to_string(feature.derivative);
}

ExpectedOrder expected_order(Norm norm, const Method& method, const std::vector<Feature>& features) {
    if (!(method.order > 0)) return none("the method claims none");
    if (is_place(norm)) return of_place(norm, method, features);
    if (norm == Norm::l1_fans || norm == Norm::l1_away)
        return none("it has no rule for '" + text_of(norm) + "' (nearest: l1)");
    const bool all_sharp = std::ranges::all_of(features, [&](const Feature& f) { return holds(method.sharp, f.kind); });
    const std::string what = features.empty() ? "smooth" : all_sharp ? "waves kept sharp" : "smooth enough";
    ExpectedOrder worst{.order = method.order, .theory = theory_of(what, norm, method)};
    for (const auto& feature : features) {
        if (holds(method.sharp, feature.kind)) continue;
        const std::string where = words_of(feature) + " at x = " + shortest(feature.x);
        if (feature.kind == Kind::singular) return none("it has no rule for the " + where);
        const double order = width_power(method, feature.kind) * (feature.derivative + inverse_power(norm));
        if (!(order > 0)) return none("in linf the " + where + " does not converge");
        if (order < worst.order && method.rings && norm != Norm::l2 && norm != Norm::rms)
            return none("in " + text_of(norm) + " it has no rule for the " + where +
                        " by a method that rings (nearest: l2, rms)");
        if (order < worst.order) worst = {.order = order, .theory = theory_of(words_of(feature), norm, method)};
    }
    return worst;
}

}  // namespace ordo::studies

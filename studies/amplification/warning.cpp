#include "studies/amplification/warning.hpp"

#include <fmt/format.h>

#include <map>

#include "core/text.hpp"
#include "studies/amplification/limits.hpp"
#include "studies/engine/run.hpp"
#include "studies/engine/scene_entry.hpp"

namespace ordo::studies {
namespace {

/// The Courant number of the planned step over the largest stable one, with words for both.
struct Beyond {
    double ratio = 0;
    std::string words;
};

Beyond beyond(const RunSpec& spec, const solvers::Scene& scene) {
    const auto* body = std::get_if<solvers::SolidScene<1>>(&scene);
    const auto& solver = solvers::solver_named(spec.solver.name, "");
    if (body == nullptr || find_parameter(solver.resolution, "courant") == nullptr) return {};
    const auto limit = limit_by_theory({scene, &solver, spec.solver.options, spec.resolution});
    if (!limit || *limit == 0) return {};
    const double courant = wave_speed(*body) * spec.plan.dt / spec.plan.h;
    std::vector<std::string> axes;
    for (const auto& axis : spec.axes) axes.push_back(axis.name + " = " + shortest(axis.value));
    return {courant / *limit,
            fmt::format("{} at {} takes steps of Courant number {:.4g}, beyond the largest stable one, "
                        "{:.4g} (closed form)",
                        spec.solver.label, joined(axes), courant, *limit)};
}

}  // namespace

std::vector<std::string> beyond_limits(const Study& study) {
    if (study.measure.stability) return {};
    const auto scene = scene_named(study.scene.name, "").problem(study.scene.values);
    // Small bars with ends bear a few per cent more than those without.
    constexpr double ends = 1.1;
    std::map<std::string, Beyond> worst;
    for (const auto& spec : specs_of(study)) {
        auto found = beyond(spec, scene);
        if (found.ratio > ends && found.ratio > worst[spec.solver.label].ratio)
            worst[spec.solver.label] = std::move(found);
    }
    std::vector<std::string> lines;
    for (auto& [label, one] : worst) {
        if (!one.words.empty()) lines.push_back(study.name + ": " + one.words);
    }
    return lines;
}

}  // namespace ordo::studies

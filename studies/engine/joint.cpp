#include "studies/engine/joint.hpp"

#include <algorithm>

#include "studies/engine/judge.hpp"

namespace ordo::studies {
namespace {

JointResult joint_fit_of(const Series& grid, const Quantity& quantity, const std::vector<Run>& runs) {
    JointResult result{grid.label, quantity.key(), {}, {}, {}};
    std::vector<JointPoint> points;
    for (const int id : grid.runs) {
        const Run& run = runs[static_cast<std::size_t>(id)];
        if (run.status != Status::ok) {
            result.left_out.push_back({id, text_of(run.status) + (run.reason.empty() ? "" : ": " + run.reason)});
            continue;
        }
        result.used.push_back(id);
        points.push_back({run.h, run.dt, run.error(quantity.key())});
    }
    result.fit = fit_joint(points);
    return result;
}

bool is_exact(const Study& study, const std::string& quantity, const std::string& solver) {
    return std::ranges::any_of(study.expect, [&](const Expectation& expectation) {
        return expectation.kind == Expectation::Kind::exact_within && speaks_of(expectation, quantity, solver);
    });
}

}  // namespace

std::vector<JointResult> joint_fits_of(const Study& study, const std::vector<Run>& runs) {
    std::vector<JointResult> results;
    for (const auto& quantity : study.measure.quantities) {
        if (quantity.against == Against::itself) continue;
        for (const auto& grid : grids_of(study, runs)) {
            const auto& solver = runs[static_cast<std::size_t>(grid.runs.front())].solver;
            if (!is_exact(study, quantity.key(), solver)) results.push_back(joint_fit_of(grid, quantity, runs));
        }
    }
    return results;
}

}  // namespace ordo::studies

// Broken studies: the plan of runs, or the list of those that came back, is not what the study says.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/catch.hpp"
#include "tests/mutations/broken.hpp"
#include "tests/mutations/shipped.hpp"

namespace ordo::tests {
namespace {

using enum studies::Fault;
using solvers::Plan;
using solvers::Snapshot;
using studies::Run;
using studies::RunSpec;
using studies::Status;
using Specs = std::vector<RunSpec>;
using Runs = std::vector<Run>;

/// Every run takes the step of the first, at its own mesh.
void dt_not_refined(Specs& specs) {
    for (auto& spec : specs) {
        Given resolution = spec.resolution.all();
        resolution.erase("courant");
        resolution["dt"] = specs.front().plan.dt;
        spec.resolution = Values(resolution);
        spec.plan.dt = specs.front().plan.dt;
    }
}

/// Every run has the resolution of the first of its solver; axes still say what the study says.
void all_alike(Specs& specs) {
    for (auto& spec : specs) {
        const auto first = std::ranges::find(specs, spec.solver.label, [](const RunSpec& s) { return s.solver.label; });
        spec.resolution = first->resolution;
    }
}

/// The finest run is the one before it once more.
void finest_not_run(Specs& specs) { specs.back().resolution = specs[specs.size() - 2].resolution; }

/// One run ends, and is compared, earlier than the study says.
void ends_early(Specs& specs) { specs.back().t_end *= 0.9; }

void renumber(Runs& runs) {
    for (std::size_t i = 0; i < runs.size(); ++i) runs[i].id = static_cast<int>(i);
}
void twice(Runs& runs) {
    runs.insert(runs.begin() + 1, runs[1]);
    renumber(runs);
}
void left_out(Runs& runs) {
    runs.erase(runs.begin() + 1);
    renumber(runs);
}
void twice_for_another(Runs& runs) {
    runs[2] = runs[1];
    renumber(runs);
}
void unplanned(Runs& runs) {
    for (auto& axis : runs[1].axes) axis.value += axis.name == "cells" ? 4 : 0;
}
void swapped(Runs& runs) { std::swap(runs[0].errors, runs[2].errors); }
void stale(Runs& runs) { runs.back().errors = runs[runs.size() - 2].errors; }

/// The abscissa counts nodes: L / (cells + 1).
void h_of_nodes(Runs& runs) {
    for (auto& run : runs) run.h /= 1 + 1 / run.axis("cells");
}
/// The abscissa is the number of cells.
void h_inverted(Runs& runs) {
    for (auto& run : runs) run.h = 1 / run.h;
}

/// The errors of the run amid the list become `value`.
auto amid(double value) {
    return [value](Runs& runs) {
        for (auto& error : runs[runs.size() / 2].errors) error.value = value;
    };
}

void first_is_nan(Runs& runs) { runs.front().errors.front().value = std::nan(""); }

auto ends_as(Status status) {
    return [status](Runs& runs) {
        runs[1].status = status;
        runs[1].errors.clear();
    };
}

/// Each quantity has the value of the next one.
void other_column(Runs& runs) {
    for (auto& run : runs) {
        for (std::size_t k = 0; k + 1 < run.errors.size(); ++k) std::swap(run.errors[k].value, run.errors[k + 1].value);
    }
}

void places_for_displacements(Snapshot& shot, const Plan&) { shot.fields[0].values = shot.x; }

/// The finest run stops a tenth early and says that it has not.
Broken stops_early() {
    const auto clock = [](double t, const Plan& plan) { return plan.h < 0.02 ? 0.9 * t : t; };
    return behind("mpm", {.clock = clock, .shown = {}});
}

void nan_in_an_unjudged_run(Runs& runs) {
    for (auto& run : runs) {
        if (run.solver != "rrm nothing") continue;
        for (auto& error : run.errors) error.value = std::nan("");
    }
}

std::vector<Mutation> broken_plans() {
    return {
        {"dt is not refined", shipped::mpm_flight, with_plan(dt_not_refined), {point_repeated, stalled}},
        {"dt is not refined with h, second order",
         shipped::mpm_manufactured,
         with_plan(dt_not_refined),
         {order_too_high, order_uncertain, published_differs}},
        {"all levels have one resolution", shipped::mpm_bar, with_plan(all_alike), {stalled}},
        {"the finest level is the one before it",
         shipped::mpm_gauss_3,
         with_plan(finest_not_run),
         {order_too_low, stalled, published_differs}},
        {"one run is compared at an earlier time", shipped::mpm_gauss_2, with_plan(ends_early), {published_differs}},
        {"a run stops early and says ok",
         shipped::mpm_gauss_2,
         stops_early(),
         {order_too_low, diverges, published_differs}},
        {"another solver than the one named",
         shipped::mpm_gauss_3,
         with_choices("mpm", [](Given& options, Given&) { options["basis"] = std::string("linear"); }),
         {order_too_low}},
        {"another mass than the one named",
         shipped::mpm_gauss_3,
         with_choices("mpm", [](Given& options, Given&) { options["mass"] = std::string("lumped"); }),
         {order_too_low}},
        {"a level is run twice", shipped::mpm_bar, with_runs(twice), {point_repeated}},
        {"a level is left out", shipped::mpm_bar, with_runs(left_out), {point_missing}},
        {"a level stands in another's place",
         shipped::mpm_bar,
         with_runs(twice_for_another),
         {point_repeated, point_missing}},
    };
}

std::vector<Mutation> broken_lists() {
    const double nan = std::nan("");
    const double infinity = std::numeric_limits<double>::infinity();
    return {
        {"a level that nobody planned", shipped::mpm_bar, with_runs(unplanned), {point_repeated, point_missing}},
        {"errors of two levels are swapped",
         shipped::fem_bar,
         with_runs(swapped),
         {order_too_low, order_uncertain, published_differs}},
        {"the finest level has the error of the one before",
         shipped::fem_bar,
         with_runs(stale),
         {order_too_low, stalled, published_differs}},
        {"the abscissa counts nodes for cells", shipped::mpm_bar, with_runs(h_of_nodes), {order_too_high, off_plan}},
        {"the abscissa is the number of cells",
         shipped::fem_bar,
         with_runs(h_inverted),
         {order_too_low, diverges, off_plan}},
        {"NaN amid the list", shipped::fem_bar, with_runs(amid(nan)), {error_is_nan}},
        {"infinity amid the list", shipped::fem_bar, with_runs(amid(infinity)), {error_is_infinite}},
        {"zero amid the list", shipped::fem_bar, with_runs(amid(0)), {error_is_zero}},
        {"a negative error amid the list", shipped::fem_bar, with_runs(amid(-1e-4)), {error_is_negative}},
        {"NaN in a list that shall be exact", shipped::elastic_wall, with_runs(first_is_nan), {error_is_nan}},
        {"zeros for errors in an order against work", shipped::gas_tube, with_runs(amid(0)), {error_is_zero}},
        {"a run blew up", shipped::mpm_bar, with_runs(ends_as(Status::diverged)), {run_diverged}},
        {"a run threw", shipped::mpm_bar, with_runs(ends_as(Status::failed)), {run_failed}},
        {"a run passed its time", shipped::mpm_bar, with_runs(ends_as(Status::timed_out)), {run_failed}},
        {"errors stand under another quantity's name", shipped::mpm_flight, with_runs(other_column), {error_too_large}},
        {"the field of another name",
         shipped::mpm_bar,
         behind("mpm", {.clock = {}, .shown = places_for_displacements}),
         {order_too_low, stalled, at_floor}},
        {"one run is compared at an earlier time", shipped::fem_column, with_plan(ends_early), {off_plan}},
        {"NaN in runs that no expectation speaks of",
         shipped::elastic_wall,
         with_runs(nan_in_an_unjudged_run),
         {error_is_nan}},
        {"nothing was run",
         shipped::mpm_bar,
         with_runs([](Runs& runs) { runs.clear(); }),
         {point_missing, nothing_measured, no_such_series}},
    };
}

}  // namespace

MutationClass broken_studies() {
    MutationClass both{"study", broken_plans()};
    for (auto& row : broken_lists()) both.rows.push_back(std::move(row));
    return both;
}

TEST_CASE("mutations: broken studies ring", "[alarm]") { try_all(broken_studies()); }

}  // namespace ordo::tests

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "studies/engine/judge.hpp"

namespace ordo::studies {
namespace {

/// One way to refine: which axes move, and what the abscissa is.
struct Refinement {
    std::vector<std::string> moving;
    std::string abscissa;
    std::string shown;
};

bool swept(const Study& study, const std::string& name) {
    return std::any_of(study.sweep.axes.begin(), study.sweep.axes.end(),
                       [&](const Axis& axis) { return axis.name == name; });
}

/// The axis that refines h for the run's solver; for a solver that the study does not have, that of its first one.
std::string width_of(const Study& study, const Run& run) {
    if (study.solvers.empty()) return "";
    const auto found = std::ranges::find(study.solvers, run.solver, &SolverChoice::label);
    return width_axis(found == study.solvers.end() ? study.solvers.front() : *found);
}

/// In the order of own_abscissae.
std::vector<Refinement> refinements(const Study& study, const std::string& width) {
    const std::string step = swept(study, "courant") ? "courant" : "dt";
    const Refinement space{{width}, "h", width};
    const Refinement time{{step}, "dt", step};
    switch (study.sweep.path) {
        case Path::space: return {space};
        case Path::time: return {time};
        case Path::joint: return {{{width, "dt"}, "h", width}};
        case Path::grid: break;
    }
    return {space, time};
}

bool moves(const Refinement& refinement, const std::string& axis) {
    return std::find(refinement.moving.begin(), refinement.moving.end(), axis) != refinement.moving.end();
}

/// What all runs of the series share and other series do not: "mpm usl, ppc = 4".
std::string label_of(const Study& study, const Run& run, const Refinement& refinement) {
    std::string label = study.solvers.size() > 1 ? run.solver : "";
    for (const auto& axis : study.sweep.axes) {
        const bool known = !std::isnan(run.axis(axis.name));  // not every solver knows every axis
        if (!known || moves(refinement, axis.name) || axis.values.size() == 1) continue;
        label += (label.empty() ? "" : ", ") + axis.name + " = " + shortest(run.axis(axis.name));
    }
    return label.empty() ? run.solver : label;
}

/// Puts the run into the series of its label, one of those from `first` on; makes it where there is none.
void add_to(std::vector<Series>& all, std::size_t first, const Run& run, const std::string& label,
            const Refinement& refinement) {
    auto found = std::find_if(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(),
                              [&](const Series& series) { return series.label == label; });
    if (found == all.end()) found = all.insert(all.end(), {label, refinement.abscissa, refinement.shown, {}});
    found->runs.push_back(run.id);
}

void sort_by_falling_abscissa(Series& series, const std::vector<Run>& runs) {
    const auto abscissa = [&](int id) { return runs[static_cast<std::size_t>(id)].at(series.abscissa); };
    std::stable_sort(series.runs.begin(), series.runs.end(), [&](int a, int b) { return abscissa(a) > abscissa(b); });
}

/// Of "tolerance" or "1/ppc" the axis, where the sweep has it; "" for h, dt and counters of work.
std::string swept_abscissa(const Study& study, const std::string& abscissa) {
    if (abscissa == "h" || abscissa == "dt") return "";
    const std::string counter = counter_of(abscissa);
    const std::string& name = counter.empty() ? abscissa : counter;
    return swept(study, name) ? name : "";
}

/// Lines that refine this axis alone, through the runs that have it.
void add_lines_along(const std::string& axis, const std::string& abscissa, const Study& study,
                     const std::vector<Run>& runs, std::vector<Series>& all) {
    const std::size_t first = all.size();
    const Refinement refinement{{axis}, abscissa, axis};
    for (const auto& run : runs) {
        if (!std::isnan(run.axis(axis))) add_to(all, first, run, label_of(study, run, refinement), refinement);
    }
    for (std::size_t k = first; k < all.size(); ++k) sort_by_falling_abscissa(all[k], runs);
}

}  // namespace

std::vector<Series> lines_of(const Study& study, const std::vector<Run>& runs) {
    std::vector<Series> all;
    for (std::size_t way = 0; way < own_abscissae(study.sweep.path).size(); ++way) {
        const std::size_t first = all.size();
        for (const auto& run : runs) {
            const Refinement refinement = refinements(study, width_of(study, run))[way];
            add_to(all, first, run, label_of(study, run, refinement), refinement);
        }
    }
    for (auto& series : all) sort_by_falling_abscissa(series, runs);
    return all;
}

std::vector<Series> grids_of(const Study& study, const std::vector<Run>& runs) {
    std::vector<Series> all;
    if (study.sweep.path != Path::grid) return all;
    for (const auto& run : runs) {
        const std::string width = width_of(study, run);
        const Refinement both{{width, "dt"}, "h", width};
        add_to(all, 0, run, label_of(study, run, both), both);
    }
    return all;
}

std::vector<Series> series_of(const Study& study, const std::vector<Run>& runs) {
    auto lines = lines_of(study, runs);
    if (study.measure.orders_against.empty()) return lines;
    std::vector<Series> all;
    for (const auto& abscissa : study.measure.orders_against) {
        if (const std::string axis = swept_abscissa(study, abscissa); !axis.empty()) {
            add_lines_along(axis, abscissa, study, runs, all);
            continue;
        }
        const std::string counter = counter_of(abscissa);
        for (const auto& line : lines) {
            if (counter.empty() && line.abscissa != abscissa) continue;
            all.push_back(counter.empty() ? line : Series{line.label, abscissa, counter, line.runs});
        }
    }
    return all;
}

}  // namespace ordo::studies

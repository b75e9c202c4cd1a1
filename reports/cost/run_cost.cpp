#include "reports/cost/run_cost.hpp"

#include <algorithm>
#include <cmath>

namespace ordo::reports {

using namespace ordo::studies;

std::string text_of(Cost cost) { return cost == Cost::time ? "time" : "work"; }

std::string counted_in(const Run& run) {
    const auto first = [&](auto&& fits) {
        const auto found = std::ranges::find_if(run.work, fits, &RunFigure::name);
        return found == run.work.end() ? std::string() : found->name;
    };
    std::string unit = first([](const std::string& name) { return name.ends_with("_steps"); });
    for (const char* plain : {"iterations", "chop_outs", "cell_updates", "steps"}) {
        if (unit.empty()) unit = first([&](const std::string& name) { return name == plain; });
    }
    return unit;
}

double cost_of(const Run& run, Cost cost) {
    if (cost == Cost::time) return run.seconds;
    const auto found = std::ranges::find(run.work, counted_in(run), &RunFigure::name);
    return found == run.work.end() ? std::nan("") : found->value;
}

double spread_of(const Run& run, Cost cost) {
    if (cost == Cost::work) return 0;
    return run.repeats ? run.repeats->spread : std::nan("");
}

std::vector<Series> lines_in(const Result& result) {
    std::vector<Series> lines;
    for (const auto& series : result.series) {
        const auto same = [&](const Series& line) { return line.label == series.label && line.runs == series.runs; };
        if (std::ranges::none_of(lines, same)) lines.push_back(series);
    }
    return lines;
}

}  // namespace ordo::reports

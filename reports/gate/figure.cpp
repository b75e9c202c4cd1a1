#include "reports/gate/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "reports/view.hpp"

namespace ordo::reports {
namespace {

void add_run(const studies::Run& run, std::vector<Figure>& figures) {
    for (const auto& [name, value] : run.errors)
        figures.push_back({FigureKind::error, run_words(run), run.solver, name, value});
    for (const auto& [name, value] : run.work)
        figures.push_back({FigureKind::work, run_words(run), run.solver, name, value});
}

double finite(double value) { return std::isfinite(value) ? value : std::nan(""); }

void add_fit(const studies::Result& result, const studies::SeriesFit& fit, std::vector<Figure>& figures) {
    if (fit.used.empty() && fit.left_out.empty()) return;
    const int first = fit.used.empty() ? fit.left_out.front().run : fit.used.front();
    const auto add = [&](const char* which, double studies::OrderFit::*member) {
        const double value = fit.outcome.fit ? finite((*fit.outcome.fit).*member) : std::nan("");
        const std::string range = fit.where.empty() ? "" : " where " + fit.where;
        figures.push_back({FigureKind::order, fit.series, run_of(result, first).solver,
                           fmt::format("{}: {} against {}{}", fit.quantity, which, fit.abscissa, range), value});
    };
    add("order", &studies::OrderFit::order);
    add("low end of the order", &studies::OrderFit::low);
    add("high end of the order", &studies::OrderFit::high);
}

}  // namespace

const std::vector<std::string>& figure_kinds() {
    static const std::vector<std::string> names{"error", "order", "work"};
    return names;
}

std::string run_words(const studies::Run& run) {
    std::string words = run.solver;
    for (const auto& [name, value] : run.axes) words += ", " + name + " = " + shortest(value);
    return words;
}

std::vector<Figure> figures_of(const studies::Result& result) {
    std::vector<Figure> figures;
    for (const auto& run : result.runs) add_run(run, figures);
    for (const auto& fit : result.fits) add_fit(result, fit, figures);
    return figures;
}

double value_of(const std::vector<Figure>& figures, const std::string& name) {
    const auto found = std::ranges::find_if(figures, [&](const Figure& figure) { return figure.name() == name; });
    return found == figures.end() ? std::nan("") : found->value;
}

}  // namespace ordo::reports

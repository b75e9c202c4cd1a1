#include "reports/plot/plot.hpp"

#include <algorithm>
#include <filesystem>

#include "core/error.hpp"
#include "reports/files.hpp"
#include "reports/plot/board.hpp"
#include "reports/plot/numbers.hpp"
#include "reports/plot/script.hpp"
#include "reports/table/numbers.hpp"
#include "solvers/solver.hpp"

namespace ordo::reports {
namespace {

namespace fs = std::filesystem;

/// "study-displacement.rms-h" with the characters of plain file names only.
std::string file_name(const studies::Study& study, const studies::Quantity& quantity, const std::string& abscissa) {
    std::string name = study.name + "-" + quantity.key() + "-" + abscissa;
    std::ranges::replace(name, '/', '_');
    return safe_path(name);
}

/// "h"; "h-delta" where solvers of one study refine widths of several kinds, which have a figure each.
std::string abscissa_name(const std::vector<View>& views, const View& view) {
    const auto rivals = [&](const View& other) {
        return other.quantity == view.quantity && other.abscissa == view.abscissa && other.shown != view.shown;
    };
    return std::ranges::any_of(views, rivals) ? view.abscissa + "-" + view.shown : view.abscissa;
}

/// What h is, says the solver that refines it by the axis shown.
std::string abscissa_words(const studies::Study& study, const View& view) {
    const std::string counter = studies::counter_of(view.abscissa);
    if (!counter.empty()) return "1 / " + spoken(counter) + ", as the solver counts [-]";
    if (view.abscissa == "dt") return "time step dt [s]";
    if (view.abscissa != "h") return view.abscissa;
    if (study.solvers.empty()) return "mesh width h [m]";
    const auto refines = [&](const studies::SolverChoice& choice) { return studies::width_axis(choice) == view.shown; };
    const auto found = std::ranges::find_if(study.solvers, refines);
    return solvers::solver_named((found == study.solvers.end() ? study.solvers.front() : *found).name, "").width;
}

bool has_hollow(const Curve& curve) {
    return std::ranges::any_of(curve.points, [](const CurvePoint& point) { return point.drawn && !point.used; });
}

Words convergence_words(const studies::Result& result, const View& view, const Layout& layout) {
    Words words = words_of(result, view.quantity);
    words.abscissa = abscissa_words(result.study, view);
    words.legend = "observed order [95 % interval]";
    if (std::ranges::any_of(layout.curves, has_hollow)) words.legend += "; hollow points are outside the fit";
    return words;
}

Drawing number_figure(const studies::Result& result, PlotFormat format) {
    const bool map = makes_map(result.study);
    std::string name = result.study.name + (map ? "-map" : "-numbers");
    std::ranges::replace(name, '/', '_');
    name = safe_path(name);
    const auto script = map ? map_script : curves_script;
    return {name, script(result, format, name + ending_of(format))};
}

}  // namespace

std::vector<Drawing> figures(const Report& report, PlotFormat format) {
    if (gives_numbers(report.result.study)) return {number_figure(report.result, format)};
    std::vector<Drawing> all;
    const auto views = views_of(report.result);
    for (const auto& view : views) {
        if (view.quantity.against == studies::Against::itself) continue;  // a norm is no error
        const std::string name = file_name(report.result.study, view.quantity, abscissa_name(views, view));
        const Layout layout = layout_of(report.result, view);
        const Words words = convergence_words(report.result, view, layout);
        all.push_back({name, script_of(layout, words, format, name + ending_of(format))});
    }
    return all;
}

std::vector<Drawing> figures(const Report& report, PlotFormat format, Cost cost, const std::vector<double>& errors) {
    refuse_without(report.result, cost);
    if (gives_numbers(report.result.study))
        throw InputError(report.result.study.name, "gives numbers and no errors, which are not drawn over their cost");
    std::vector<Drawing> all;
    for (const auto& quantity : report.result.study.measure.quantities) {
        if (quantity.against == studies::Against::itself) continue;
        const std::string name = file_name(report.result.study, quantity, text_of(cost));
        const Layout layout = layout_of(report.result, quantity, cost, errors);
        const Words words = cost_words(report, quantity, cost);
        all.push_back({name, script_of(layout, words, format, name + ending_of(format))});
    }
    return all;
}

Drawing board(const std::vector<Report>& reports, PlotFormat format, Cost cost) {
    for (const auto& report : reports) refuse_without(report.result, cost);
    const std::string name = "board-" + text_of(cost);
    return {name, script_of(board_of(reports, cost), format, name + ending_of(format))};
}

std::vector<std::string> draw(const std::vector<Drawing>& figures, const std::string& folder, PlotFormat format) {
    std::vector<std::string> scripts;
    check_writable((fs::path(folder) / ".ordo").string());
    for (const auto& figure : figures) {
        scripts.push_back((fs::path(folder) / (figure.name + ".gp")).string());
        check_writable(scripts.back());
    }
    for (std::size_t i = 0; i < figures.size(); ++i) write_whole(scripts[i], figures[i].script);
    std::vector<std::string> files = scripts;
    for (const auto& script : scripts) {
        files.push_back(fs::path(script).replace_extension(ending_of(format)).string());
        draw_picture(script, files.back());
    }
    return files;
}

std::vector<std::string> draw(const Report& report, const std::string& folder, PlotFormat format) {
    return draw(figures(report, format), folder, format);
}

}  // namespace ordo::reports

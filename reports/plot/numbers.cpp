#include "reports/plot/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/text.hpp"
#include "reports/view.hpp"

namespace ordo::reports {
namespace {

using namespace ordo::studies;

constexpr std::size_t most_across = 3;
constexpr int panel_height = 300;  // px
constexpr int heading_height = 60;

/// The swept axis with most values; of `skipped` and of what is not swept none.
std::string main_axis(const Study& study, const std::string& skipped) {
    std::string found;
    std::size_t most = 0;
    for (const auto& axis : study.sweep.axes) {
        if (axis.name == skipped || axis.values.size() <= most) continue;
        found = axis.name;
        most = axis.values.size();
    }
    return found;
}

/// "ppc = 2, courant = 0.4": the axes of a run that have several values, but for those named.
std::string rest_of(const Study& study, const Run& run, const std::set<std::string>& but) {
    std::vector<std::string> words;
    for (const auto& axis : study.sweep.axes) {
        if (axis.values.size() > 1 && !but.contains(axis.name))
            words.push_back(axis.name + " = " + shortest(run.axis(axis.name)));
    }
    return joined(words);
}

struct Grid {
    std::size_t across = 1, down = 1;
    int height = 0;
};

Grid grid_of(std::size_t panels, int legend) {
    Grid grid;
    grid.across = std::min(most_across, panels);
    grid.down = (panels + grid.across - 1) / grid.across;
    grid.height = heading_height + static_cast<int>(grid.down) * panel_height + legend;
    return grid;
}

std::string head(const Result& result, const Grid& grid, int legend, const std::string& below) {
    const double height = grid.height;
    std::string text =
        fmt::format("set multiplot layout {},{} margins screen 0.07,0.985,{:.4f},{:.4f} spacing screen 0.06,{:.4f}\n",
                    grid.down, grid.across, (legend + 48.0) / height, 1 - heading_height / height, 75.0 / height);
    text += fmt::format("set label 1 {} at screen 0.5,{:.4f} center noenhanced font ',13'\n",
                        quoted(clipped(result.study.about, 100)), 1 - 18.0 / height);
    text += fmt::format(
        "set key at screen 0.02,{:.4f} left bottom vertical maxrows {} Left reverse noenhanced samplen 2 "
        "font ',10'\n",
        6.0 / height, std::max(1, legend / 20));
    return text + "set tics font ',9'\nset grid linetype 1 linecolor '#dddddd' linewidth 0.6\nset xlabel " +
           quoted(below) + " noenhanced offset 0,0.5\n";
}

std::string style_of(const std::string& quantity, std::size_t colour) {
    const std::string paint =
        fmt::format("dashtype {} linecolor '{}'", 1 + colour / colours.size(), colours[colour % colours.size()]);
    if (quantity == "limit_by_matrix") return "with points pointtype 7 pointsize 0.8 " + paint;
    if (quantity == "limit_by_runs") return "with points pointtype 6 pointsize 1.5 linewidth 1.5 " + paint;
    if (quantity == "limit_by_theory") return "with lines linewidth 1.5 " + paint;
    return "with linespoints pointtype 7 pointsize 0.5 linewidth 1.2 " + paint;
}

struct Line {
    std::string quantity, rest;
    std::vector<std::pair<double, double>> points;
};

/// Curves of the runs that `ours` admits.
template <class Ours>
std::vector<Line> lines_of_panel(const Result& result, const std::string& axis,
                                 const std::vector<std::string>& quantities, Ours&& ours) {
    std::vector<Line> lines;
    for (const auto& quantity : quantities) {
        for (const Run& run : result.runs) {
            const double value = run.error(quantity);
            if (stopped(run) || !ours(run) || !std::isfinite(value)) continue;
            const std::string rest = rest_of(result.study, run, {axis});
            auto line = std::ranges::find_if(
                lines, [&](const Line& other) { return other.quantity == quantity && other.rest == rest; });
            if (line == lines.end()) line = lines.insert(lines.end(), {quantity, rest, {}});
            line->points.emplace_back(run.axis(axis), value);
        }
    }
    return lines;
}

std::vector<std::string> solvers_of(const Study& study) {
    std::vector<std::string> labels;
    for (const auto& choice : study.solvers) labels.push_back(choice.label);
    return labels;
}

bool is_geometric(const Study& study, const std::string& name) {
    const auto axis = std::ranges::find(study.sweep.axes, name, &Axis::name);
    const auto [low, high] = std::ranges::minmax(axis->values);
    return low > 0 && high >= 8 * low;
}

std::string pairs(const std::vector<std::pair<double, double>>& points) {
    std::string rows;
    for (const auto& [x, y] : points) rows += shortest(x) + " " + shortest(y) + "\n";
    return rows;
}

// --- maps ---

enum class Outcome { stable, growing, blown_up };
constexpr std::array outcome_colours{"#cfe8cf", "#f5d9a8", "#e8a39b"};
constexpr std::array outcome_words{"stable", "growing", "blown up"};

/// By its growth where the study asks for it, else by the radius.
Outcome outcome_of(const Study& study, const Run& run) {
    if (stopped(run)) return Outcome::blown_up;
    const double growth = run.error("growth");
    if (!std::isnan(growth)) return growth <= study.measure.stability->growth ? Outcome::stable : Outcome::growing;
    return run.error("spectral_radius") <= 1 + 1e-6 ? Outcome::stable : Outcome::growing;
}

/// Cell borders half-way between values.
std::pair<double, double> borders(const std::vector<double>& values, std::size_t k) {
    const double below = k > 0 ? 0.5 * (values[k - 1] + values[k]) : 1.5 * values[0] - 0.5 * values[1];
    const double above =
        k + 1 < values.size() ? 0.5 * (values[k] + values[k + 1]) : 1.5 * values[k] - 0.5 * values[k - 1];
    return {below, above};
}

std::vector<double> values_of(const Study& study, const std::string& name) {
    auto values = std::ranges::find(study.sweep.axes, name, &Axis::name)->values;
    std::ranges::sort(values);
    return values;
}

/// One panel: boxes by outcome, the matrix's curve, the closed form.
struct MapPanel {
    std::array<std::string, 3> boxes;
    std::string matrix, theory;
};

MapPanel panel_of(const Result& result, const std::string& solver, const std::string& axis) {
    const auto across = values_of(result.study, axis);
    const auto courants = values_of(result.study, "courant");
    MapPanel panel;
    for (std::size_t i = 0; i < across.size(); ++i) {
        std::optional<double> crossed;
        double theory = std::nan("");
        for (std::size_t j = 0; j < courants.size(); ++j) {
            const auto run = std::ranges::find_if(result.runs, [&](const Run& one) {
                return one.solver == solver && one.axis(axis) == across[i] && one.axis("courant") == courants[j];
            });
            if (run == result.runs.end()) continue;
            const auto [low, high] = borders(courants, j);
            panel.boxes[static_cast<std::size_t>(outcome_of(result.study, *run))] +=
                fmt::format("{} {} {} {} {} {}\n", i, courants[j], static_cast<double>(i) - 0.5,
                            static_cast<double>(i) + 0.5, low, high);
            if (!crossed && run->error("spectral_radius") > 1 + 1e-6) crossed = low;
            if (const double closed = run->error("limit_by_theory"); std::isfinite(closed)) theory = closed;
        }
        if (crossed) panel.matrix += fmt::format("{} {}\n", i, *crossed);
        if (std::isfinite(theory)) panel.theory += fmt::format("{} {}\n", i, theory);
    }
    return panel;
}

}  // namespace

bool makes_map(const Study& study) {
    const auto& quantities = study.measure.quantities;
    const bool outcomes = std::ranges::any_of(
        quantities, [](const Quantity& one) { return one.field == "growth" || one.field == "spectral_radius"; });
    return outcomes && study.sweep.axes.size() > 1 && std::ranges::any_of(study.sweep.axes, [](const Axis& axis) {
               return axis.name == "courant" && axis.values.size() > 2;
           });
}

std::string curves_script(const Result& result, PlotFormat format, const std::string& picture) {
    const std::string axis = main_axis(result.study, "");
    const bool limits = result.study.measure.quantities.front().field.starts_with("limit");
    std::vector<std::string> quantities;
    for (const auto& quantity : result.study.measure.quantities) quantities.push_back(quantity.key());
    const auto solvers = solvers_of(result.study);
    const std::size_t panels = limits ? solvers.size() : quantities.size();
    std::vector<std::string> keys;
    std::string data;
    std::vector<std::string> plots(panels);
    for (std::size_t k = 0; k < panels; ++k) {
        const auto ours = [&](const Run& run) { return !limits || run.solver == solvers[k]; };
        std::vector<Line> lines;
        if (limits) lines = lines_of_panel(result, axis, quantities, ours);
        else {
            for (const auto& solver : solvers) {
                for (auto& line : lines_of_panel(result, axis, {quantities[k]},
                                                 [&](const Run& run) { return run.solver == solver; })) {
                    line.rest = solver + (line.rest.empty() ? "" : ", " + line.rest);
                    lines.push_back(std::move(line));
                }
            }
        }
        std::vector<std::string> parts;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::string key = lines[i].rest.empty() ? spoken(lines[i].quantity) : lines[i].rest;
            auto place = std::ranges::find(keys, key);
            if (place == keys.end()) place = keys.insert(keys.end(), key);
            data += data_block(fmt::format("line{}_{}", k, i), pairs(lines[i].points));
            parts.push_back(fmt::format("$line{}_{} using 1:2 {} notitle", k, i,
                                        style_of(lines[i].quantity, static_cast<std::size_t>(place - keys.begin()))));
        }
        const std::string heading = limits ? solvers[k] : spoken(quantities[k]);
        plots[k] = "set title " + quoted(clipped(heading, 40)) + " noenhanced font ',10' offset 0,-0.7\n";
        plots[k] += parts.empty() ? "plot NaN notitle" : "plot " + joined(parts, ", \\\n     ");
    }
    const bool wide = std::ranges::any_of(keys, [](const std::string& key) { return key.size() > 24; });
    const std::size_t columns = wide ? 2 : 4;
    const int legend = 20 * static_cast<int>((keys.size() + columns - 1) / columns);
    const Grid grid = grid_of(panels, legend);
    std::string text = opening(format, grid.height, picture) + data + head(result, grid, legend, axis);
    if (is_geometric(result.study, axis)) text += "set logscale x 2\n";
    text += "set offsets graph 0.04,graph 0.04,graph 0.06,graph 0.06\n";
    for (std::size_t k = 0; k < panels; ++k) {
        text += plots[k];
        for (std::size_t i = 0; k == 0 && i < keys.size(); ++i)
            text += fmt::format(", \\\n     keyentry with lines linewidth 2 dashtype {} linecolor '{}' title {}",
                                1 + i / colours.size(), colours[i % colours.size()], quoted(keys[i]));
        text += "\n";
        if (k == 0) text += "unset label 1\nunset key\n";
    }
    return text + "unset multiplot\nunset output\n";
}

std::string map_script(const Result& result, PlotFormat format, const std::string& picture) {
    const std::string axis = main_axis(result.study, "courant");
    const auto solvers = solvers_of(result.study);
    const Grid grid = grid_of(solvers.size(), 40);
    std::string data, body;
    for (std::size_t k = 0; k < solvers.size(); ++k) {
        const MapPanel panel = panel_of(result, solvers[k], axis);
        std::vector<std::string> parts;
        for (std::size_t c = 0; c < panel.boxes.size(); ++c) {
            if (panel.boxes[c].empty()) continue;
            data += data_block(fmt::format("map{}_{}", k, c), panel.boxes[c]);
            parts.push_back(
                fmt::format("$map{}_{} using 1:2:3:4:5:6 with boxxyerror fillstyle solid noborder linecolor "
                            "'{}' notitle",
                            k, c, outcome_colours[c]));
        }
        if (!panel.matrix.empty()) {
            data += data_block(fmt::format("matrix{}", k), panel.matrix);
            parts.push_back(
                fmt::format("$matrix{} using 1:2 with points pointtype 7 pointsize 0.6 linecolor 'black' "
                            "notitle",
                            k));
        }
        if (!panel.theory.empty()) {
            data += data_block(fmt::format("theory{}", k), panel.theory);
            parts.push_back(fmt::format("$theory{} using 1:2 with lines linewidth 2 linecolor '#0072B2' notitle", k));
        }
        for (std::size_t c = 0; k == 0 && c < outcome_words.size(); ++c)
            parts.push_back(fmt::format("keyentry with points pointtype 5 pointsize 1.5 linecolor '{}' title '{}'",
                                        outcome_colours[c], outcome_words[c]));
        if (k == 0) {
            parts.emplace_back("keyentry with points pointtype 7 linecolor 'black' title 'spectral radius passes 1'");
            parts.emplace_back("keyentry with lines linewidth 2 linecolor '#0072B2' title 'closed form, no ends'");
        }
        body += "set title " + quoted(clipped(solvers[k], 40)) + " noenhanced font ',10' offset 0,-0.7\n";
        body += "plot " + joined(parts, ", \\\n     ") + "\n";
        if (k == 0) body += "unset label 1\nunset key\n";
    }
    std::string text = opening(format, grid.height, picture) + data + head(result, grid, 40, axis);
    text += "set key maxrows 2\nset ylabel 'Courant number' offset 1.5,0\nset xrange [-0.5:" +
            shortest(static_cast<double>(values_of(result.study, axis).size()) - 0.5) + "]\nset xtics (";
    std::vector<std::string> tics;
    const auto across = values_of(result.study, axis);
    const std::size_t every = (across.size() + 7) / 8;  // that labels do not meet
    for (std::size_t i = 0; i < across.size(); i += every)
        tics.push_back(quoted(shortest(across[i])) + " " + std::to_string(i));
    return text + joined(tics) + ")\n" + body + "unset multiplot\nunset output\n";
}

}  // namespace ordo::reports

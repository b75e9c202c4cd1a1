#include "reports/plot/board.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/view.hpp"

namespace ordo::reports {
namespace {

constexpr std::size_t most_across = 3;
constexpr int panel_height = 260;  // px
constexpr int heading_height = 50;
constexpr double least_error = 1e-10;
constexpr std::array shapes{7, 5, 9, 13, 11, 15};

const studies::Quantity& quantity_of(const studies::Result& result) {
    const auto& quantities = result.study.measure.quantities;
    const auto found = std::ranges::find_if(
        quantities, [](const auto& quantity) { return quantity.against != studies::Against::itself; });
    if (found == quantities.end()) throw InputError(result.study.name, "measures no error");
    return *found;
}

std::size_t place_of(std::vector<std::string>& labels, const std::string& label) {
    const auto found = std::ranges::find(labels, label);
    const auto place = static_cast<std::size_t>(found - labels.begin());
    if (found == labels.end()) labels.push_back(label);
    return place;
}

/// Rows of what can be drawn; a blank line, which breaks the line, for a run without an error.
std::string rows_of(const Method& method) {
    std::string rows;
    for (const auto& [cost, error] : method.points)
        rows += cost > 0 && error > 0 ? shortest(cost) + " " + shortest(error) + "\n" : "\n";
    return rows;
}

std::string front_rows(const std::vector<Method>& methods) {
    std::string rows;
    for (const auto& point : front_of(methods))
        rows += shortest(point.at.cost) + " " + shortest(std::max(point.at.error, least_error)) + "\n";
    return rows;
}

bool drawable(const Method& method) {
    return std::ranges::any_of(method.points, [](const CostPoint& point) { return point.cost > 0 && point.error > 0; });
}

std::string style_of(std::size_t k) {
    return fmt::format("linewidth 1.2 linecolor '{}' pointtype {} pointsize 0.7", colours[k % colours.size()],
                       shapes[(k / colours.size() + k) % shapes.size()]);
}

std::string data_of(const Board& board) {
    std::string text;
    for (std::size_t i = 0; i < board.panels.size(); ++i) {
        const auto& methods = board.panels[i].methods;
        text += data_block(fmt::format("front{}", i), front_rows(methods));
        for (std::size_t k = 0; k < methods.size(); ++k)
            text += data_block(fmt::format("points{}_{}", i, k), rows_of(methods[k]));
    }
    return text;
}

/// "below: RRM, waves from 3e-06 s" for methods that are under the panel from their cheapest run on, else "".
std::string below_words(const BoardPanel& panel) {
    std::string text;
    for (const auto& method : panel.methods) {
        const auto above = [](const CostPoint& point) { return point.error > least_error; };
        if (method.descent.empty() || std::ranges::any_of(method.points, above)) continue;
        text += fmt::format("{}{} from {:.0e}", text.empty() ? "below: " : ", ", clipped(method.label, 24),
                            method.descent.vertices.front().cost);
    }
    return text;
}

/// Curves of one panel; with it, in the first one, the legend of all.
std::string plot_of(const Board& board, std::size_t i) {
    const BoardPanel& panel = board.panels[i];
    std::vector<std::string> plots{
        fmt::format("$front{} using 1:2 with steps linewidth 6 linecolor '#dddddd' notitle", i)};
    for (std::size_t k = 0; k < panel.methods.size(); ++k) {
        if (!drawable(panel.methods[k])) continue;
        plots.push_back(
            fmt::format("$points{}_{} using 1:2 with linespoints {} notitle", i, k, style_of(panel.styles[k])));
    }
    for (std::size_t k = 0; i == 0 && k < board.labels.size(); ++k)
        plots.push_back(fmt::format("keyentry with linespoints {} title {}", style_of(k), quoted(board.labels[k])));
    const std::string below = below_words(panel);
    const std::string label = below.empty()
                                  ? "unset label 3\n"
                                  : "set label 3 " + quoted(below) + " at graph 0.04,0.08 noenhanced font ',9'\n";
    return "set title " + quoted(panel.heading) + " noenhanced font ',10' offset 0,-0.7\n" + label + "plot " +
           joined(plots, ", \\\n     ") + "\n";
}

}  // namespace

Board board_of(const std::vector<Report>& reports, Cost cost) {
    Board board{cost == Cost::time ? "error against run time" : "error against counted work",
                cost == Cost::time ? "thread time [s]" : "counted work",
                {},
                {}};
    for (const auto& report : reports) {
        const auto& quantity = quantity_of(report.result);
        const std::string& study = report.result.study.name;
        BoardPanel panel{clipped(study.substr(study.rfind('/') + 1), 24) + ": " + quantity.key(), {}, {}};
        panel.methods = methods_of(report.result, quantity, cost);
        for (const auto& method : panel.methods) panel.styles.push_back(place_of(board.labels, method.label));
        board.panels.push_back(std::move(panel));
    }
    return board;
}

std::string script_of(const Board& board, PlotFormat format, const std::string& picture) {
    const std::size_t across = std::min(most_across, board.panels.size());
    const std::size_t down = (board.panels.size() + across - 1) / across;
    const int rows = static_cast<int>((board.labels.size() + 3) / 4);
    const int legend_height = 20 + 20 * rows;
    const int height = heading_height + static_cast<int>(down) * panel_height + legend_height;
    std::string text = opening(format, height, picture) + data_of(board);
    text +=
        fmt::format("set multiplot layout {},{} margins screen 0.07,0.985,{:.4f},{:.4f} spacing screen 0.065,{:.4f}\n",
                    down, across, (legend_height + 45.0) / height, 1 - 1.0 * heading_height / height, 50.0 / height);
    text += fmt::format("set label 1 {} at screen 0.5,{:.4f} center noenhanced font ',13'\n", quoted(board.title),
                        1 - 16.0 / height);
    text += fmt::format("set label 2 {} at screen 0.5,{:.4f} center noenhanced font ',10'\n", quoted(board.abscissa),
                        (legend_height + 10.0) / height);
    text += fmt::format(
        "set key at screen 0.03,{:.4f} left bottom vertical maxrows {} Left reverse noenhanced samplen 2 spacing 1.1 "
        "font ',10'\n",
        6.0 / height, rows);
    text += fmt::format(
        "set logscale xy\nset format xy '10^{{%T}}'\nset yrange [{}:*]\nset tics font ',8'\n"
        "set xtics 100\nset ytics 100\nset grid linetype 1 linecolor '#dddddd' linewidth 0.6\n",
        shortest(least_error));
    for (std::size_t i = 0; i < board.panels.size(); ++i) {
        text += plot_of(board, i);
        if (i == 0) text += "unset label 1\nunset label 2\nunset key\n";
    }
    return text + "unset multiplot\nunset output\n";
}

}  // namespace ordo::reports

#include "reports/plot/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace ordo::reports {
namespace {

constexpr int heading_height = 85;  // px
constexpr int spacing = 48;

int panel_height(std::size_t across) { return across == 1 ? 260 : 175; }

/// Whether any curve bends or breaks at place i: on straight stretches the ends alone draw the line.
bool bends(const Curves& curves, std::size_t i) {
    if (curves.style == Curves::Style::points || i == 0 || i + 1 == curves.x.size()) return true;
    const double share = (curves.x[i] - curves.x[i - 1]) / (curves.x[i + 1] - curves.x[i - 1]);
    return std::ranges::any_of(curves.values, [&](const auto& y) {
        const bool drawn = std::isfinite(y[i]);
        if (drawn != std::isfinite(y[i - 1]) || drawn != std::isfinite(y[i + 1])) return true;
        const double straight = (1 - share) * y[i - 1] + share * y[i + 1];
        return drawn && std::abs(y[i] - straight) > 1e-9 * (1 + std::abs(straight));
    });
}

std::string rows(const Curves& curves) {
    std::string text;
    for (std::size_t i = 0; i < curves.x.size(); ++i) {
        if (!bends(curves, i)) continue;
        text += shortest(curves.x[i]);
        for (const auto& values : curves.values) text += std::isfinite(values[i]) ? " " + shortest(values[i]) : " NaN";
        text += '\n';
    }
    return text;
}

std::string style_of(Curves::Style style, std::size_t k) {
    const std::string colour = colours[k % colours.size()];
    switch (style) {
        case Curves::Style::backdrop:
            return "with filledcurves y1=0 fillcolor '#e4e4e4' fillstyle transparent solid 0.7";
        case Curves::Style::points: return "with points pointtype 7 pointsize 0.5 linecolor '" + colour + "'";
        case Curves::Style::lines: break;
    }
    return "with lines linewidth 1.6 linecolor '" + colour + "'";
}

/// Boxes as bars along the panel's floor, a dot a particle; the same in every panel, so they are set once.
std::string floor_of(const FunctionFigure& figure) {
    std::string text;
    for (std::size_t p = 0; p < figure.particles.size(); ++p) {
        text += fmt::format(
            "set object {} rectangle from first {},graph 0 to first {},graph 0.045 behind fillcolor '#f3e6c4' "
            "fillstyle solid border linecolor '#a08030'\n",
            p + 1, shortest(figure.corners[2 * p]), shortest(figure.corners[2 * p + 1]));
        text += fmt::format("set label {} '' at first {},graph 0.022 point pointtype 7 pointsize 0.3\n", p + 10,
                            shortest(figure.particles[p]));
    }
    return text;
}

std::string plot_of(const FunctionPanel& panel, std::size_t index) {
    std::vector<std::string> plots;
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
        const Curves& curves = panel.curves[c];
        for (std::size_t k = 0; k < curves.values.size(); ++k) {
            const std::string title =
                curves.names.empty() ? "notitle" : "title " + quoted(curves.names[k]) + " noenhanced";
            plots.push_back(
                fmt::format("$curves{}_{} using 1:{} {} {}", index, c, k + 2, style_of(curves.style, k), title));
        }
    }
    const bool legend = std::ranges::any_of(panel.curves, [](const Curves& c) { return !c.names.empty(); });
    return fmt::format("set offsets 0,0,graph {},graph 0.1\nset label 3 {} at graph 0,1.07 left noenhanced font ',9'\n",
                       legend ? 0.24 : 0.06, quoted(panel.heading)) +
           "plot " + joined(plots, ", \\\n     ") + "\n";
}

std::string frame_of(const FunctionFigure& figure, std::size_t down, int height) {
    std::string text = fmt::format(
        "set multiplot layout {},{} margins screen 0.06,0.98,{:.4f},{:.4f} spacing screen {},{:.4f}\n", down,
        figure.across, 48.0 / height, 1 - 1.0 * heading_height / height, 0.055, 1.0 * spacing / height);
    text += fmt::format("set label 1 {} at screen 0.5,{:.4f} center noenhanced font ',13'\n", quoted(figure.title),
                        1 - 22.0 / height);
    text += fmt::format("set label 2 {} at screen 0.5,{:.4f} center noenhanced textcolor '#555555'\n",
                        quoted(figure.subtitle), 1 - 46.0 / height);
    text += fmt::format("set label 4 {} at screen 0.52,{:.4f} center noenhanced font ',9'\n", quoted(figure.abscissa),
                        12.0 / height);
    text += fmt::format("set xrange [{}:{}]\nset yrange [*:*] noextend\n", shortest(figure.from), shortest(figure.to));
    if (figure.to - figure.from <= 16) text += "set xtics 1\n";
    text += "set tics font ',8'\nset grid linetype 1 linecolor '#dddddd' linewidth 0.6\n";
    text += "set format y '%.3g'\nset key at graph 0.99,0.98 right top horizontal maxrows 2 font ',7' samplen 1\n";
    return text;
}

}  // namespace

std::string script_of(const FunctionFigure& figure, PlotFormat format, const std::string& picture) {
    const std::size_t down = (figure.panels.size() + figure.across - 1) / figure.across;
    const int height = heading_height + static_cast<int>(down) * (panel_height(figure.across) + spacing);
    std::string text = opening(format, height, picture);
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
        for (std::size_t c = 0; c < figure.panels[i].curves.size(); ++c)
            text += data_block(fmt::format("curves{}_{}", i, c), rows(figure.panels[i].curves[c]));
    }
    text += frame_of(figure, down, height) + floor_of(figure);
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
        text += plot_of(figure.panels[i], i);
        if (i == 0) text += "unset label 1\nunset label 2\nunset label 4\n";
    }
    return text + "unset multiplot\nunset output\n";
}

}  // namespace ordo::reports

#include "reports/plot/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.hpp"
#include "reports/plot/ticks.hpp"

namespace ordo::reports {
namespace {

// Point types filled and hollow; with the seven colours 42 distinct curves.
constexpr std::array<std::array<int, 2>, 6> shapes{{{7, 6}, {5, 4}, {9, 8}, {13, 12}, {11, 10}, {15, 14}}};

constexpr std::size_t widest_legend = 100;  // characters that fit under the picture

std::string pair_text(const Point& point) { return shortest(point.x) + " " + shortest(point.y); }

/// Abscissa, error and whether a fit used it; an empty line, which breaks the line of points, for a run without a
/// point.
std::string point_rows(const Curve& curve) {
    std::string rows;
    for (const auto& point : curve.points)
        rows += point.drawn ? pair_text(point.at) + (point.used ? " 1\n" : " 0\n") : "\n";
    return rows;
}

/// Abscissa, error, and the ends of the bar of each point that has one.
std::string bar_rows(const Curve& curve) {
    std::string rows;
    for (const auto& [at, drawn, used, spread] : curve.points) {
        if (!drawn || !(spread > 0)) continue;
        rows += pair_text(at) + " " + pair_text({at.x * std::max(1 - spread, 1e-3), at.x * (1 + spread)}) + "\n";
    }
    return rows;
}

std::string pair_rows(const std::vector<Point>& points) {
    std::string rows;
    for (const auto& point : points) rows += pair_text(point) + "\n";
    return rows;
}

/// Data of what a layout has beside its curves; nothing for what it has not.
std::string mark_blocks(const Layout& layout) {
    std::string text;
    if (!layout.front.empty()) text += data_block("front", pair_rows(layout.front));
    if (!layout.crossovers.empty()) text += data_block("crossovers", pair_rows(layout.crossovers));
    if (!layout.reached.empty()) text += data_block("reached", pair_rows(layout.reached));
    for (std::size_t i = 0; i < layout.levels.size(); ++i) {
        const double level = layout.levels[i];
        text += data_block(fmt::format("level{}", i), pair_rows({{layout.x.low, level}, {layout.x.high, level}}));
    }
    return text;
}

std::string data_blocks(const Layout& layout) {
    std::string text = mark_blocks(layout);
    for (std::size_t i = 0; i < layout.curves.size(); ++i) {
        const Curve& curve = layout.curves[i];
        text += data_block(fmt::format("points{}", i), point_rows(curve));
        if (const std::string bars = bar_rows(curve); !bars.empty()) text += data_block(fmt::format("bars{}", i), bars);
        for (std::size_t k = 0; k < curve.fits.size(); ++k)
            text += data_block(fmt::format("fit{}_{}", i, k), pair_rows(curve.fits[k]));
    }
    for (std::size_t i = 0; i < layout.triangles.size(); ++i) {
        const auto& [left, right, angle] = layout.triangles[i].corners;
        text += data_block(fmt::format("triangle{}", i), pair_text(left) + "\n" + pair_text(right) + "\n" +
                                                             pair_text(angle) + "\n" + pair_text(left) + "\n");
    }
    return text;
}

/// The order beside the upright side of its triangle.
std::string triangle_label(const Triangle& triangle) {
    const auto& [left, right, angle] = triangle.corners;
    const bool at_right = angle.x == right.x;
    const double middle = std::sqrt(angle.y * (at_right ? right.y : left.y));
    return fmt::format("set label {} at {},{} {} offset {},0\n", quoted(shortest(triangle.order)), shortest(angle.x),
                       shortest(middle), at_right ? "left" : "right", at_right ? "0.7" : "-0.7");
}

/// Columns and rows of the legend; two columns where all entries are short.
struct Legend {
    std::size_t columns = 1;
    std::size_t rows = 0;
};

Legend legend_shape(const Layout& layout) {
    const auto is_long = [](const Curve& curve) { return width_of(curve.legend) > widest_legend / 2; };
    const std::size_t entries = layout.curves.size() + layout.remarks.size() + (layout.front.empty() ? 0 : 1);
    const std::size_t columns =
        entries < 3 || !layout.remarks.empty() || std::ranges::any_of(layout.curves, is_long) ? 1 : 2;
    return {columns, (entries + columns - 1) / columns};
}

/// The legend stands below the axes, where it hides no data.
std::string legend_settings(const std::string& heading, const Legend& legend) {
    return fmt::format(
        "set bmargin {:.1f}\nset key at screen 0.02,0.012 left bottom vertical maxrows {} Left reverse "
        "noenhanced samplen 2.5 spacing 1.15 title {} noenhanced left\n",
        5.2 + 1.2 * static_cast<double>(legend.rows), legend.rows, quoted(clipped(heading, widest_legend)));
}

std::string settings(const Words& words, const Layout& layout, const Legend& legend) {
    std::string text = "set tmargin 4.5\n" + legend_settings(words.legend, legend);
    text += "set title " + quoted(clipped(words.title, 80)) + " noenhanced font ',15' offset 0,1\n";
    text += "set label " + quoted(words.subtitle) + " at graph 0.5,1.045 center noenhanced textcolor '#555555'\n";
    text += "set xlabel " + quoted(words.abscissa) + " noenhanced\n";
    text += "set ylabel " + quoted(words.ordinate) + " noenhanced\n";
    text += "set logscale xy\n";
    text += "set xrange [" + shortest(layout.x.low) + ":" + shortest(layout.x.high) + "]\n";
    text += "set yrange [" + shortest(layout.y.low) + ":" + shortest(layout.y.high) + "]\n";
    text += "set xtics " + log_ticks(layout.x) + "\nset ytics " + log_ticks(layout.y) + "\n";
    text += "set grid xtics ytics linetype 1 linecolor '#cccccc' linewidth 0.6\n";
    for (const auto& triangle : layout.triangles) text += triangle_label(triangle);
    if (layout.empty) text += "set label " + quoted(words.nothing) + " at graph 0.5,0.5 center\n";
    return text;
}

/// What is plotted for one series: the connection (dotted or solid), fitted lines, markers (hollow where no fit used
/// the run), and the entry of the legend.
void add_curve(std::vector<std::string>& plots, const Curve& curve, std::size_t i, bool solid) {
    const std::string colour = fmt::format("linecolor '{}'", colours[i % colours.size()]);
    const auto [filled, hollow] = shapes[i % shapes.size()];
    const std::string points = fmt::format("$points{}", i);
    if (std::ranges::any_of(curve.points, &CurvePoint::drawn)) {
        plots.push_back(points + " using 1:2 with lines linewidth 1 dashtype " + (solid ? "1 " : "3 ") + colour +
                        " notitle");
        for (std::size_t k = 0; k < curve.fits.size(); ++k) {
            plots.push_back(fmt::format("$fit{}_{} using 1:2 with lines linewidth 2 {} notitle", i, k, colour));
        }
        const auto markers = [&](int used, int shape) {
            return fmt::format(
                "{} using 1:($3 == {} ? $2 : NaN) with points pointtype {} pointsize 1.1 linewidth 1.5 {} notitle",
                points, used, shape, colour);
        };
        plots.push_back(markers(1, filled));
        plots.push_back(markers(0, hollow));
        if (!bar_rows(curve).empty())
            plots.push_back(fmt::format("$bars{} using 1:2:3:4 with xerrorbars pointtype -1 {} notitle", i, colour));
    }
    plots.push_back(fmt::format("keyentry with {} linewidth 2 pointsize 1.1 pointtype {} {} title {}",
                                curve.fits.empty() && !solid ? "points" : "linespoints", filled, colour,
                                quoted(clipped(curve.legend, widest_legend))));
}

/// Behind the curves: the front as a staircase, and a line at each error asked for.
void add_backdrop(std::vector<std::string>& plots, const Layout& layout) {
    if (!layout.front.empty()) {
        plots.push_back("$front using 1:2 with steps linewidth 7 linecolor '#dddddd' notitle");
        plots.push_back(
            "keyentry with lines linewidth 7 linecolor '#dddddd' title 'least error for at most that cost: "
            "the Pareto front is its corners'");
    }
    for (std::size_t i = 0; i < layout.levels.size(); ++i)
        plots.push_back(
            fmt::format("$level{} using 1:2 with lines linewidth 1 dashtype 2 linecolor '#777777' notitle", i));
}

/// Over the curves: rings where the lead changes, ticks where an error asked for is met, and the remarks.
void add_marks(std::vector<std::string>& plots, const Layout& layout) {
    if (!layout.crossovers.empty())
        plots.push_back(
            "$crossovers using 1:2 with points pointtype 6 pointsize 2.4 linewidth 1.5 linecolor '#000000' "
            "notitle");
    if (!layout.reached.empty())
        plots.push_back(
            "$reached using 1:2 with points pointtype 1 pointsize 1.2 linewidth 1.2 linecolor '#000000' "
            "notitle");
    for (const auto& remark : layout.remarks)
        plots.push_back("keyentry with lines linewidth 0.1 linecolor '#ffffff' title " +
                        quoted(clipped(remark, widest_legend)));
}

std::string plot_command(const Layout& layout) {
    std::vector<std::string> plots{"NaN notitle"};
    add_backdrop(plots, layout);
    for (std::size_t i = 0; i < layout.triangles.size(); ++i) {
        plots.push_back(fmt::format("$triangle{} using 1:2 with lines linewidth 1 linecolor '#444444' notitle", i));
    }
    for (std::size_t i = 0; i < layout.curves.size(); ++i) add_curve(plots, layout.curves[i], i, layout.solid);
    add_marks(plots, layout);
    return "plot " + joined(plots, ", \\\n     ") + "\n";
}

}  // namespace

Words words_of(const studies::Result& result, const studies::Quantity& quantity) {
    const std::string error = error_words(quantity);
    return {.title = result.study.name,
            .subtitle = error + " " + time_words(result, quantity),
            .abscissa = "",
            .ordinate = error + unit_words(quantity),
            .legend = "",
            .nothing = "no run has a finite, positive error"};
}

std::string script_of(const Layout& layout, const Words& words, PlotFormat format, const std::string& picture) {
    const Legend legend = legend_shape(layout);
    const int height = 580 + 20 * static_cast<int>(legend.rows);  // rows of the legend take nothing from the axes
    std::string text = opening(format, height, picture);
    text += data_blocks(layout) + settings(words, layout, legend) + plot_command(layout);
    return text + "unset output\n";
}

}  // namespace ordo::reports

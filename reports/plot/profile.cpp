#include "reports/plot/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::reports {
namespace {

namespace fs = std::filesystem;

constexpr const char* legend_above = "set key at graph 1,1.14 right top horizontal maxrows 1 font ',10'\n";
constexpr const char* inside_legend = "set key at graph 0.99,0.98 right top horizontal maxrows 3 font ',7'\n";
constexpr int panel_height = 230;  // px
constexpr int heading_height = 70;

/// Place and components; an empty line, which breaks the lines, where a component has no value.
std::string rows(const Profile& profile, const Panel& panel) {
    std::string text;
    for (std::size_t i = 0; i < profile.places.size(); ++i) {
        std::string row = shortest(profile.places[i]);
        bool whole = true;
        for (const auto& component : panel.values) {
            whole = whole && std::isfinite(component[i]);
            row += " " + shortest(component[i]);
        }
        text += whole ? row + "\n" : "\n";
    }
    return text;
}

/// A component's name within its field: "xy" of "stress_xy".
std::string short_name(const Panel& panel, const std::string& component) {
    return component.starts_with(panel.field + "_") ? component.substr(panel.field.size() + 1) : component;
}

/// The field's name stands above its panel at the left, the legend of its components at the right.
std::string plot_of(const Panel& panel, std::size_t index, const std::string& abscissa) {
    std::string text = "set xlabel " + quoted(abscissa) + " noenhanced offset 0,0.3\n";
    text += "set label 3 " + quoted(panel.field + " [" + panel.unit + "]") + " at graph 0,1.07 left noenhanced\n";
    std::vector<std::string> curves;
    for (std::size_t k = 0; k < panel.components.size(); ++k) {
        const std::string title = panel.components.size() == 1
                                      ? "notitle"
                                      : "title " + quoted(short_name(panel, panel.components[k])) + " noenhanced";
        curves.push_back(fmt::format("$panel{} using 1:{} with lines linewidth 2 dashtype {} linecolor '{}' {}", index,
                                     k + 2, 1 + k / colours.size(), colours[k % colours.size()], title));
    }
    text += panel.components.size() > 4 ? inside_legend : legend_above;
    return text + "plot " + joined(curves, ", \\\n     ") + "\n";
}

}  // namespace

std::string script_of(const Profile& profile, PlotFormat format, const std::string& picture) {
    const std::size_t across = profile.panels.size() == 1 ? 1 : 2;
    const std::size_t down = (profile.panels.size() + across - 1) / across;
    const int height = heading_height + panel_height * static_cast<int>(down) * (across == 1 ? 2 : 1);
    std::string text = opening(format, height, picture);
    for (std::size_t i = 0; i < profile.panels.size(); ++i)
        text += data_block(fmt::format("panel{}", i), rows(profile, profile.panels[i]));
    text += fmt::format("set multiplot layout {},{} margins screen 0.1,0.97,{:.4f},{:.4f} spacing screen 0.12,{:.4f}\n",
                        down, across, 50.0 / height, 1 - 85.0 / height, 68.0 / height);
    text += fmt::format("set label 1 {} at screen 0.5,{:.4f} center noenhanced font ',13'\n", quoted(profile.title),
                        1 - 22.0 / height);
    text += fmt::format("set label 2 {} at screen 0.5,{:.4f} center noenhanced textcolor '#555555'\n",
                        quoted(profile.subtitle), 1 - 46.0 / height);
    text += "set grid linetype 1 linecolor '#dddddd' linewidth 0.6\nset offsets 0,0,graph 0.06,graph 0.06\n";
    text += "set format y '%.3g'\nset key samplen 0.7\n";
    const auto [low, high] = std::ranges::minmax(profile.places);
    text += fmt::format("set xrange [{}:{}]\n", shortest(low), shortest(high));
    for (std::size_t i = 0; i < profile.panels.size(); ++i) {
        text += plot_of(profile.panels[i], i, profile.abscissa);
        if (i == 0) text += "unset label 1\nunset label 2\n";
    }
    return text + "unset multiplot\nunset output\n";
}

std::vector<std::string> draw(const Profile& profile, const std::string& picture) {
    const PlotFormat format = format_by_ending(picture);
    const auto [low, high] = std::ranges::minmax(profile.places);
    if (!(low < high)) throw InputError(one_line(picture), "a picture needs two different places at least");
    return draw_with_script(script_of(profile, format, fs::path(picture).filename().string()), picture);
}

}  // namespace ordo::reports

#include "reports/plot/plot.hpp"

#include <algorithm>
#include <filesystem>

#include "reports/files.hpp"
#include "reports/plot/script.hpp"

namespace ordo::reports {
namespace {

namespace fs = std::filesystem;

/// "study-displacement.rms-h" with the characters of plain file names only.
std::string file_name(const studies::Study& study, const View& view) {
    std::string name = study.name + "-" + view.quantity.key() + "-" + view.abscissa;
    std::ranges::replace(name, '/', '_');
    return safe_path(name);
}

}  // namespace

std::vector<Figure> figures(const Report& report, PlotFormat format) {
    std::vector<Figure> all;
    for (const auto& view : views_of(report.result)) {
        const std::string name = file_name(report.result.study, view);
        all.push_back({name, script_of(report.result, view, format, name + ending_of(format))});
    }
    return all;
}

std::vector<std::string> draw(const Report& report, const std::string& folder, PlotFormat format) {
    std::vector<std::string> scripts;
    for (const auto& figure : figures(report, format)) {
        const std::string path = (fs::path(folder) / (figure.name + ".gp")).string();
        check_writable(path);
        write_whole(path, figure.script);
        scripts.push_back(path);
    }
    std::vector<std::string> files = scripts;
    for (const auto& script : scripts) {
        files.push_back(fs::path(script).replace_extension(ending_of(format)).string());
        draw_picture(script, files.back());
    }
    return files;
}

}  // namespace ordo::reports

#include "app/one_run.hpp"

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "core/text.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/reader/study_reader.hpp"

namespace ordo::app {
namespace {

/// --set scene.E=50, solver.stress_update=usl, resolution.cells=64, by their first word.
std::map<std::string, Given> settings(const po::variables_map& options, const std::string& command) {
    const std::vector<std::string> kinds{"scene", "solver", "resolution"};
    std::map<std::string, Given> given;
    if (!options.contains("set")) return given;
    for (const auto& text : options["set"].as<std::vector<std::string>>()) {
        const auto setting = studies::setting_from(text);
        const auto dot = setting.path.find('.');
        const std::string kind = setting.path.substr(0, dot);
        if (dot == std::string::npos || std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
            throw InputError(command + " --set " + text,
                             "must begin with scene., solver. or resolution." + did_you_mean(kind, kinds));
        }
        if (!given[kind].emplace(setting.path.substr(dot + 1), studies::value_from(setting.value)).second)
            throw InputError(command + " --set", "'" + one_line(setting.path) + "' is set twice");
    }
    return given;
}

}  // namespace

void add_one_run_options(po::options_description& options) {
    options.add_options()("solver", po::value<std::string>()->value_name("NAME"), "which solver")(
        "set", po::value<std::vector<std::string>>()->value_name("path=value"),
        "scene.k=v, solver.k=v or resolution.k=v; may be repeated");
}

OneRun one_run_from(const po::variables_map& options, const std::vector<std::string>& words,
                    const std::string& command) {
    if (words.size() != 1) throw InputError(command, "names no scene; usage: " + command + " SCENE --solver NAME");
    if (!options.contains("solver")) throw InputError(command, "needs --solver NAME");
    auto given = settings(options, command);
    const auto& scene = studies::scene_named(words.front(), command);
    const auto& solver = solvers::solver_named(options["solver"].as<std::string>(), command + " --solver");
    const std::string where = command + " --set";
    OneRun run{.scene_name = scene.name,
               .scene = scene.problem(resolve(scene.parameters, given["scene"], where, "scene " + scene.name)),
               .solver = &solver,
               .options = resolve(solver.options, given["solver"], where, "solver " + solver.name),
               .resolution = resolve(solver.resolution, given["resolution"], where, "solver " + solver.name)};
    if (!solver.accepts(run.scene))
        throw InputError(command, "solver " + solver.name + " does not accept the scene " + scene.name);
    return run;
}

}  // namespace ordo::app

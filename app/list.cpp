// ordo list: what exists, with parameters, units, defaults and claims; everything from the declarations.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "app/command.hpp"
#include "core/error.hpp"
#include "core/named.hpp"
#include "core/text.hpp"
#include "oracles/oracle.hpp"
#include "reports/schema.hpp"
#include "solvers/solver.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/reader/study_reader.hpp"

namespace ordo::app {
namespace {

void line(const std::string& name, const std::string& about) { std::cout << fmt::format("  {:<22} {}\n", name, about); }

void show(const std::string& title, const std::vector<Parameter>& parameters) {
    std::cout << '\n' << title << ":\n";
    for (const auto& parameter : parameters) {
        const std::string rule = parameter.kind == Parameter::Kind::word ? "" : ", " + parameter.rule();
        line(parameter.name,
             fmt::format("{} [{}] default {}{}", parameter.help, parameter.unit, parameter.default_text(), rule));
        for (const auto& choice : parameter.words)
            std::cout << fmt::format("  {:<22}   {:<16} {}\n", "", choice.name, choice.help);
    }
}

void show_scene(const studies::SceneEntry& scene) {
    std::cout << scene.name << ": " << scene.about << "\nunits " << scene.units << "; exact solution " << scene.oracle
              << "; source " << joined(scene.source) << '\n';
    show("parameters", scene.parameters);
}

void show_solver(const solvers::Solver& solver) {
    std::cout << solver.name << ": " << solver.about << "\nfields " << joined(solver.fields) << "; source "
              << joined(solver.source) << '\n';
    show("options", solver.options);
    show("resolution", solver.resolution);
    const auto claim = solver.claim(resolve(solver.options, {}, "", solver.name));
    std::cout << fmt::format("\nclaim with the defaults: order {} in space, {} in time, {}; conserves {} [{}]\n",
                             claim.order_in_space, claim.order_in_time, claim.provided, joined(claim.conserves),
                             claim.source);
}

/// The names of the constants of a solution at its defaults.
std::string constant_names(const oracles::Exact& exact) {
    std::vector<std::string> names;
    for (const auto& constant : exact.constants(std::nullopt)) names.push_back(constant.name);
    return joined(names);
}

/// One end of the box; beyond all numbers it says so.
std::string end_text(double end) { return std::abs(end) > 1e300 ? (end < 0 ? "-inf" : "inf") : shortest(end); }

std::string box_text(const oracles::Exact& exact) {
    std::vector<std::string> edges;
    for (std::size_t axis = 0; axis < exact.lower.size(); ++axis)
        edges.push_back("[" + end_text(exact.lower[axis]) + ", " + end_text(exact.upper[axis]) + "]");
    return joined(edges, " x ");
}

/// "position in space, in [-inf, inf] m"
std::string place_text(const oracles::Exact& exact) {
    if (!exact.abscissa.empty()) return exact.abscissa + ", in " + box_text(exact);
    const bool material = exact.coordinates == oracles::Coordinates::material;
    return (material ? "position in the undeformed body, in " : "position in space, in ") + box_text(exact) + " m";
}

void show_oracle(const oracles::Oracle& oracle) {
    const auto exact = oracle.bind(resolve(oracle.parameters, {}, "", oracle.name));
    std::cout << oracle.name << ": " << oracle.about << "\n\n"
              << oracle.explanation << (oracle.fields.empty() ? "\n" : "\n\nfields:\n");
    for (const auto& field : oracle.fields)
        line(field.name, std::array{"scalar", "vector", "tensor"}[static_cast<std::size_t>(field.rank)] +
                             std::string(" [") + field.unit + "]");
    show("parameters", oracle.parameters);
    std::cout << "\nwith the defaults:\n";
    if (!exact.fields.empty()) {
        line("x", place_text(exact));
        line("t", exact.times.text() + " s");
    }
    if (exact.constants) line("constants", constant_names(exact));
    if (exact.averages) line("cells", "exact means over cells");
    std::cout << "\nsmoothness: " << oracle.smoothness << "\naccuracy: " << oracle.accuracy
              << "\nsource: " << joined(oracle.source) << "\nexample: ordo oracle " << oracle.example << '\n';
}

/// All entries by name and line, or one of them whole.
template <class T, class Show>
void list_catalogue(const std::vector<T>& entries, const std::string& title, const std::string& name, Show&& show_one) {
    if (name.empty()) {
        std::cout << title << ":\n";
        for (const auto& entry : entries) line(entry.name, entry.about);
        return;
    }
    show_one(named(entries, name, "ordo list " + title, "there is no"));
}

void list_norms() {
    std::cout << "norms (e: difference at a point, w: its volume, n: number of points):\n";
    line("rms", "sqrt(sum |e|^2 / n)");
    line("l1", "sum w |e|");
    line("l2", "sqrt(sum w |e|^2)");
    line("linf", "max |e|");
    std::cout << "  on cells l1 and l2 are integrals over them, and there are\n";
    line("l1_fans", "integral of |e| over the middle half of every fan");
    line("l1_near", "the part of l1 no further than measure.near from what is not smooth; of points too");
    line("l1_away", "the rest of l1: both parts together are l1");
    line("shock", "largest error of the place of a shock, where the field passes the middle of its sides [m]");
    line("contact", "the same of contacts [m]");
    line("fan_edge", "the same of the edges of fans, 5 % inside them [m]");
    std::cout << "  'over': 'maximum' takes the largest value over the ends of all steps; 'against': 'finest' the run "
                 "of smallest dt\n";
}

/// Study files below a folder, in the order of their paths.
void list_studies(const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code error;
    if (!fs::is_directory(folder, error))
        throw InputError("ordo list studies",
                         "there is no folder '" + folder + "'; name one: ordo list studies FOLDER");
    std::vector<std::string> paths;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".json" && entry.path().parent_path().filename() != "published")
            paths.push_back(entry.path().string());
    }
    std::sort(paths.begin(), paths.end());
    std::string text = "studies in " + folder + ":\n";
    for (const auto& path : paths) text += "  " + path + "\n      " + one_line(studies::read_study(path).about) + '\n';
    std::cout << text;
}

int run(const std::vector<std::string>& words) {
    const std::string kind = words.empty() ? "" : words[0];
    const std::string name = words.size() < 2 ? "" : words[1];
    const bool all = kind.empty();
    if (!name.empty() && (kind == "norms" || kind == "schema"))
        throw InputError("ordo list " + kind, "takes no name, but got '" + name + "'");
    if (all || kind == "scenes") list_catalogue(studies::all_scenes(), "scenes", name, show_scene);
    if (all || kind == "solvers") list_catalogue(solvers::all_solvers(), "solvers", name, show_solver);
    if (all || kind == "oracles") list_catalogue(oracles::all_oracles(), "oracles", name, show_oracle);
    if (all || kind == "norms") list_norms();
    if (kind == "studies" || (all && std::filesystem::is_directory("studies")))
        list_studies(name.empty() ? "studies" : name);
    if (kind == "schema") std::cout << reports::study_schema();
    const std::vector<std::string> kinds{"scenes", "solvers", "oracles", "norms", "studies", "schema"};
    if (!all && std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
        throw InputError("ordo list", "there is nothing called '" + kind + "'" + did_you_mean(kind, kinds));
    }
    return all_hold;
}

}  // namespace

Command list_command() {
    return {.name = "list",
            .about = "what exists: scenes, solvers, oracles, norms, studies, the study schema",
            .usage = "[scenes|solvers|oracles|norms|studies|schema] [NAME]",
            .examples = {"ordo list", "ordo list solvers mpm", "ordo list scenes bar_vibration",
                         "ordo list studies studies"},
            .options = {},
            .most_arguments = 2,
            .run = [](const po::variables_map&, const std::vector<std::string>& words) { return run(words); }};
}

}  // namespace ordo::app

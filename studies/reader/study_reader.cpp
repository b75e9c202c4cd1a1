#include "studies/reader/study_reader.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/error.hpp"
#include "core/text.hpp"
#include "solvers/solver.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/reader/json_input.hpp"
#include "studies/reader/parts.hpp"

namespace ordo::studies {
namespace {

Given given_from(const Node& node) {
    Given given;
    for (const auto& member : node.members()) {
        if (member.key() != "name") given.emplace(member.key(), member.value());
    }
    return given;
}

SceneChoice scene_from(const Node& node) {
    if (!node.is_object()) node.refuse("must be an object with a 'name'");
    const SceneEntry& entry = scene_named(node.at("name").text(), node.at("name").where());
    return {entry.name, resolve(entry.parameters, given_from(node), node.where(), "scene " + entry.name)};
}

/// One solver entry; a list in an option stands for one solver each.
std::vector<SolverChoice> solvers_from(const Node& node) {
    if (!node.is_object()) node.refuse("must be an object with a 'name'");
    const auto& solver = solvers::solver_named(node.at("name").text(), node.at("name").where());
    std::string label = solver.name;
    if (node.has("label")) label = node.at("label").text();
    if (label.empty()) node.at("label").refuse("is empty");
    std::vector<Given> variants{{}};
    for (const auto& member : node.members()) {
        if (member.key() == "name" || member.key() == "label") continue;
        const auto choices = member.items();
        if (choices.empty()) member.refuse("is an empty list");
        std::vector<Given> longer;
        for (const auto& variant : variants) {
            for (const auto& choice : choices) {
                longer.push_back(variant);
                longer.back().emplace(member.key(), choice.value());
            }
        }
        variants = std::move(longer);
    }
    std::vector<SolverChoice> choices;
    for (const auto& given : variants) {
        choices.push_back({solver.name, resolve(solver.options, given, node.where(), "solver " + solver.name), label});
    }
    return choices;
}

std::vector<SolverChoice> all_that_accept(const solvers::Scene& scene) {
    std::vector<SolverChoice> choices;
    for (const auto& solver : solvers::all_solvers()) {
        if (solver.accepts(scene))
            choices.push_back({solver.name, resolve(solver.options, {}, "", solver.name), solver.name});
    }
    return choices;
}

/// Solvers with the same label, given or by name, are told apart by what differs between them: "mpm usl",
/// "mpm usl, margin = 0.2".
void label(std::vector<SolverChoice>& choices, const Node& node) {
    const std::vector<SolverChoice> given = choices;
    std::set<std::string> labels;
    for (auto& choice : choices) {
        const std::string own = choice.label;
        for (const auto& [name, value] : choice.options.all()) {
            const auto differs = [&](const SolverChoice& other) {
                return other.name == choice.name && other.label == own && other.options.all().at(name) != value;
            };
            if (std::none_of(given.begin(), given.end(), differs)) continue;
            choice.label += std::holds_alternative<std::string>(value) ? " " + text_of(value)
                                                                       : ", " + name + " = " + text_of(value);
        }
        if (!labels.insert(choice.label).second) node.refuse("the solver '" + choice.label + "' is listed twice");
    }
}

std::vector<SolverChoice> all_solvers_from(const Node& node, const SceneChoice& scene) {
    const solvers::Scene problem = scene_named(scene.name, "").problem(scene.values);
    std::vector<SolverChoice> choices;
    if (node.is_text()) {
        node.one_of({"all"});
        choices = all_that_accept(problem);
    } else {
        for (const auto& item : node.items()) {
            for (auto& choice : solvers_from(item)) choices.push_back(std::move(choice));
        }
    }
    if (choices.empty()) node.refuse("no solver takes part");
    for (const auto& choice : choices) {
        if (!solvers::solver_named(choice.name, "").accepts(problem)) {
            node.refuse("solver " + choice.name + " does not accept the scene " + scene.name);
        }
    }
    label(choices, node);
    return choices;
}

/// Finer levels may be skipped where each run is in one line only, whose coarse runs say all that it is judged by.
bool stops_when_decided(const Node& node, const Study& study) {
    node.one_of({"when_decided"});
    if (study.measure.stability) node.refuse("is for errors that fall with h, but the study measures stability");
    if (study.sweep.path == Path::grid) node.refuse("needs one line through each run, but path 'grid' has two");
    if (!study.measure.orders_against.empty()) node.refuse("does not go together with measure.orders_against");
    const auto exact = [](const Quantity& quantity) { return quantity.against == Against::exact; };
    if (!std::ranges::all_of(study.measure.quantities, exact)) node.refuse("needs measure.against to be 'exact'");
    return true;
}

Study study_from(Json document, const std::string& where, const std::string& folder) {
    inline_published(document, where, folder);
    const Node root(document, where);
    root.only({"study", "about", "source", "scene", "solvers", "sweep", "measure", "expect", "published", "allow",
               "stop", "timeout_s"});
    Study study;
    study.name = root.at("study").text();
    if (study.name.empty()) root.at("study").refuse("is empty");
    if (root.has("about")) study.about = root.at("about").text();
    if (root.has("source")) study.source = root.at("source").texts();
    study.scene = scene_from(root.at("scene"));
    study.solvers = all_solvers_from(root.at("solvers"), study.scene);
    const auto problem = scene_named(study.scene.name, "").problem(study.scene.values);
    study.sweep = sweep_from(root.at("sweep"), study.solvers, problem);
    study.measure = measure_from(root.at("measure"), study);
    if (root.has("expect")) study.expect = expectations_from(root.at("expect"), study);
    if (root.has("published")) study.published = published_from(root.at("published"), study);
    if (root.has("allow")) {
        for (const auto& item : root.at("allow").items())
            (item.one_of({"diverged", "timed_out"}) == 0 ? study.diverged_allowed : study.time_out_allowed) = true;
    }
    if (root.has("stop")) study.stops_when_decided = stops_when_decided(root.at("stop"), study);
    if (root.has("timeout_s")) {
        study.timeout_s = root.at("timeout_s").number();
        if (!(*study.timeout_s > 0)) root.at("timeout_s").refuse("must be > 0");
    }
    study.document = document.dump();
    return study;
}

}  // namespace

Study read_study(const std::string& path, const std::vector<Setting>& settings) {
    Json document = parse_json(read_text(path), path);
    for (const auto& setting : settings) put_setting(document, setting);
    return study_from(std::move(document), path, std::filesystem::path(path).parent_path().string());
}

Study study_from_text(const std::string& text, const std::string& where, const std::string& folder) {
    return study_from(parse_json(text, where), where, folder);
}

}  // namespace ordo::studies

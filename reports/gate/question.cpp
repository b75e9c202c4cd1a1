#include "reports/gate/question.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <variant>

#include "core/text.hpp"
#include "reports/view.hpp"

namespace ordo::reports {
namespace {

using Json = nlohmann::json;

constexpr std::size_t longest_value = 60;

std::string value_at(const Json& json, const std::string& pointer) {
    const Json::json_pointer place(pointer);
    if (!json.contains(place)) return "absent";
    if (json.at(place).is_number()) return shortest(json.at(place).get<double>());
    return clipped(json.at(place).dump(-1, ' ', false, Json::error_handler_t::replace), longest_value);
}

/// A scene or solver with all its values, defaults too.
Json chosen(const std::string& name, const Values& values) {
    Json json{{"name", name}};
    for (const auto& [key, value] : values.all()) std::visit([&](const auto& plain) { json[key] = plain; }, value);
    return json;
}

}  // namespace

std::string question_of(const studies::Study& study) {
    Json json = Json::parse(study.document);
    json.erase("about");
    json.erase("source");
    json["scene"] = chosen(study.scene.name, study.scene.values);
    json["solvers"] = Json::array();
    for (const auto& solver : study.solvers) {
        json["solvers"].push_back(chosen(solver.name, solver.options));
        json["solvers"].back()["label"] = solver.label;
    }
    return json.dump();
}

std::vector<Difference> differences(const std::string& before, const std::string& now) {
    const Json old_question = Json::parse(before);
    const Json new_question = Json::parse(now);
    std::vector<Difference> found;
    for (const auto& change : Json::diff(old_question, new_question)) {
        const auto member = change.at("path").get<std::string>();
        found.push_back({member, value_at(old_question, member), value_at(new_question, member)});
    }
    return found;
}

std::string text_of(const std::vector<Difference>& differences) {
    constexpr std::size_t most = 3;
    std::string text;
    for (std::size_t i = 0; i < differences.size() && i < most; ++i) {
        const auto& [member, before, now] = differences[i];
        text += fmt::format("{}{} was {}, is {}", i == 0 ? "" : "; ", member, before, now);
    }
    return differences.size() > most ? text + fmt::format("; and {} more", differences.size() - most) : text;
}

}  // namespace ordo::reports

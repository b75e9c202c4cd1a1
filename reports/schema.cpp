#include "reports/schema.hpp"

#include <algorithm>
#include <map>

#include "solvers/solver.hpp"
#include "studies/amplification/figures.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/engine/study.hpp"
#include "studies/reader/json_input.hpp"

namespace ordo::reports {
namespace {

using studies::Json;

const Json text{{"type", "string"}};
const Json above_zero{{"type", "number"}, {"exclusiveMinimum", 0}};

const Json abscissa{
    {"type", "string"},
    {"pattern", "^(1/)?[A-Za-z_][A-Za-z0-9_]*$"},
    {"description", "what an order is fitted against: h, dt, a swept axis, or one over an axis or a counter of work"}};

Json one_or_list(const Json& item) {
    return {{"oneOf", {item, {{"type", "array"}, {"items", item}, {"minItems", 1}}}}};
}

/// The same where an empty list is fine.
Json one_or_any(const Json& item) { return {{"oneOf", {item, {{"type", "array"}, {"items", item}}}}}; }

const Json texts = one_or_any(text);

Json words(const std::vector<std::string>& allowed) { return {{"enum", allowed}}; }

/// One declared parameter as a schema, with its help, unit and default.
Json schema_of(const Parameter& parameter) {
    Json json{{"description", parameter.help + (parameter.unit == "-" ? "" : " [" + parameter.unit + "]")}};
    switch (parameter.kind) {
        case Parameter::Kind::toggle: json["type"] = "boolean"; break;
        case Parameter::Kind::word: json["enum"] = parameter.word_names(); break;
        case Parameter::Kind::whole: json["type"] = "integer"; break;
        case Parameter::Kind::number: json["type"] = "number"; break;
    }
    const Range& range = parameter.range;
    if (std::isfinite(range.low)) json[range.low_excluded ? "exclusiveMinimum" : "minimum"] = range.low;
    if (std::isfinite(range.high)) json["maximum"] = range.high;
    if (parameter.fallback)
        json["default"] = std::visit([](const auto& value) { return Json(value); }, *parameter.fallback);
    return json;
}

/// An object with this name and these parameters, each alone or, where `lists`, as a list of choices.
Json named(const std::string& name, const std::string& about, const std::vector<Parameter>& parameters, bool lists) {
    Json properties{{"name", {{"const", name}}}};
    Json required = Json::array({"name"});
    for (const auto& parameter : parameters) {
        properties[parameter.name] = lists ? one_or_list(schema_of(parameter)) : schema_of(parameter);
        if (parameter.required) required.push_back(parameter.name);
    }
    if (lists) properties["label"] = text;
    return {{"type", "object"},
            {"description", about},
            {"properties", properties},
            {"required", required},
            {"additionalProperties", false}};
}

Json object(Json properties, std::vector<std::string> required) {
    return {{"type", "object"},
            {"properties", std::move(properties)},
            {"required", std::move(required)},
            {"additionalProperties", false}};
}

Json scene_schema() {
    Json choices = Json::array();
    for (const auto& scene : studies::all_scenes())
        choices.push_back(named(scene.name, scene.about, scene.parameters, false));
    return {{"oneOf", choices}};
}

Json solvers_schema() {
    Json choices = Json::array();
    for (const auto& solver : solvers::all_solvers())
        choices.push_back(named(solver.name, solver.about, solver.options, true));
    const Json one{{"oneOf", choices}};
    return {{"oneOf", {{{"const", "all"}}, one, {{"type", "array"}, {"items", one}, {"minItems", 1}}}}};
}

Json sweep_schema() {
    Json properties{{"path", words({"space", "time", "joint", "grid"})}};
    properties["coupling"] = object({{"dt", above_zero}, {"power", above_zero}}, {"dt", "power"});
    properties["coupling"]["description"] = "path joint: dt = C h^k, C the member dt, k the member power";
    std::map<std::string, std::vector<Json>> choices;
    for (const auto& solver : solvers::all_solvers()) {
        for (const auto& parameter : solver.resolution)
            choices[parameter.name].push_back(one_or_list(schema_of(parameter)));
    }
    // Solvers may differ in what they allow.
    for (auto& [name, allowed] : choices) {
        allowed.erase(std::unique(allowed.begin(), allowed.end()), allowed.end());
        properties[name] = allowed.size() == 1 ? allowed.front() : Json{{"anyOf", allowed}};
    }
    return object(properties, {"path"});
}

Json measure_schema() {
    std::vector<std::string> fields;
    for (const auto& solver : solvers::all_solvers()) {
        for (const auto& name : solver.fields) {
            if (std::ranges::find(fields, name) == fields.end()) fields.push_back(name);
        }
    }
    const Json measured = object({{"at", above_zero},
                                  {"until", words({"exact", "accumulated", "steps"})},
                                  {"fields", one_or_list(words(fields))},
                                  {"norms", one_or_list(words(studies::norm_names()))},
                                  {"over", words({"final", "maximum"})},
                                  {"volume", words({"current", "undeformed"})},
                                  {"near", above_zero},
                                  {"against", one_or_list(words({"exact", "finest", "itself"}))},
                                  {"orders_against", one_or_list(abscissa)}},
                                 {"at", "fields"});
    const Json asked =
        object({{"stability", one_or_list(words(studies::stability_names()))},
                {"crossings", above_zero},
                {"between", {{"type", "array"}, {"items", above_zero}, {"minItems", 2}, {"maxItems", 2}}},
                {"tolerance", above_zero},
                {"growth", above_zero},
                {"motion", words({"noise", "scene"})}},
               {"stability"});
    return {{"oneOf", {measured, asked}}};
}

Json expectation_schema() {
    const Json order{{"anyOf", {{{"type", "number"}}, words({"expected"})}}};
    Json json = object({{"order", order},
                        {"within", above_zero},
                        {"may_exceed", {{"type", "string"}, {"minLength", 1}}},
                        {"levels", {{"type", "integer"}, {"minimum", 2}}},
                        {"error_at_most", above_zero},
                        {"exact_within", above_zero},
                        {"value", {{"type", "number"}}},
                        {"agrees_with", text},
                        {"against", abscissa},
                        {"where", texts},
                        {"of", texts},
                        {"solver", texts},
                        {"source", text}},
                       {"source"});
    json["oneOf"] = {{{"required", {"order", "within"}}},
                     {{"required", {"error_at_most"}}},
                     {{"required", {"exact_within"}}},
                     {{"required", {"value", "within"}}},
                     {{"required", {"agrees_with", "within"}}}};
    return json;
}

Json published_schema() {
    const Json row{{"type", "object"},
                   {"properties", {{"value", text}}},
                   {"required", {"value"}},
                   {"additionalProperties", {{"type", "number"}}}};
    const Json table = object({{"id", text},
                               {"title", text},
                               {"source", text},
                               {"quantity", text},
                               {"rows", {{"type", "array"}, {"items", row}, {"minItems", 1}}}},
                              {"id", "title", "source", "quantity", "rows"});
    Json json = object({{"file", text},
                        {"table", table},
                        {"compare", words({"digits", "band", "none"})},
                        {"band", above_zero},
                        {"because", text},
                        {"solver", text}},
                       {"compare"});
    json["oneOf"] = {{{"required", {"file"}}}, {{"required", {"table"}}}};
    return json;
}

}  // namespace

std::string study_schema() {
    Json schema{
        {"$schema", "http://json-schema.org/draft-07/schema#"}, {"$id", "ordo-study-1"}, {"title", "A study of Ordo"}};
    const Json body = object({{"study", {{"type", "string"}, {"minLength", 1}}},
                              {"about", text},
                              {"source", texts},
                              {"scene", scene_schema()},
                              {"solvers", solvers_schema()},
                              {"sweep", sweep_schema()},
                              {"measure", measure_schema()},
                              {"expect", one_or_any(expectation_schema())},
                              {"published", one_or_any(published_schema())},
                              {"allow", one_or_any(words({"diverged", "timed_out"}))},
                              {"stop", words({"when_decided"})},
                              {"timeout_s", above_zero}},
                             {"study", "scene", "solvers", "sweep", "measure"});
    schema.update(body);
    return schema.dump(1) + "\n";
}

}  // namespace ordo::reports

#include "studies/engine/description.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "core/text.hpp"

namespace ordo::studies {
namespace {

using Json = nlohmann::json;  // sorts members

/// JSON knows no infinity and no NaN: they stand as words.
Json exact(double value) { return std::isfinite(value) ? Json(value) : Json(shortest(value)); }

struct AsJson {
    Json operator()(double value) const { return exact(value); }
    Json operator()(bool value) const { return value; }
    Json operator()(const std::string& value) const { return value; }
};

Json values_json(const Values& values) {
    Json json = Json::object();
    for (const auto& [name, value] : values.all()) json[name] = std::visit(AsJson{}, value);
    return json;
}

Json chosen(const std::string& name, const Values& values) { return {{"name", name}, {"values", values_json(values)}}; }

Json measure_json(const Measure& measure) {
    Json quantities = Json::array();
    for (const auto& quantity : measure.quantities)
        quantities.push_back({{"key", quantity.key()}, {"near", exact(quantity.near)}});
    Json json{{"fields", measure.fields}, {"quantities", std::move(quantities)}};
    if (const auto& asked = measure.stability)
        json["stability"] = {{"crossings", asked->crossings}, {"from", asked->from},     {"to", asked->to},
                             {"tolerance", asked->tolerance}, {"growth", asked->growth}, {"as_scene", asked->as_scene}};
    return json;
}

Json json_of(const RunSpec& spec) {
    return {{"scene", chosen(spec.scene.name, spec.scene.values)},
            {"solver", chosen(spec.solver.name, spec.solver.options)},
            {"resolution", values_json(spec.resolution)},
            {"end", exact(spec.t_end)},
            {"measure", measure_json(spec.measure)}};
}

}  // namespace

std::string description_of(const RunSpec& spec) { return json_of(spec).dump(); }

std::string description_of(const RunSpec& spec, const RunSpec& reference) {
    Json json = json_of(spec);
    json["reference"] = json_of(reference);
    return json.dump();
}

}  // namespace ordo::studies

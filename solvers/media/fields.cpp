#include "solvers/media/fields.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::solvers {
namespace {

bool has(const Medium& medium, LineField field) {
    const bool gas = std::holds_alternative<IdealGas>(medium);
    if (field == LineField::pressure) return gas;
    return !gas || (field != LineField::stress && field != LineField::strain && field != LineField::temperature);
}

std::vector<std::string> names_in(const Medium& medium) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < line_field_names().size(); ++k) {
        if (has(medium, static_cast<LineField>(k))) names.push_back(line_field_names()[k]);
    }
    return names;
}

}  // namespace

const std::vector<std::string>& line_field_names() {
    static const std::vector<std::string> names{"density",     "velocity", "pressure", "stress",      "strain",
                                                "temperature", "energy",   "momentum", "total_energy"};
    return names;
}

std::vector<std::string> line_fields_in(const Scene& scene) {
    if (!is_line(scene)) throw std::logic_error("the scene is no line");
    return names_in(std::get<LineScene>(scene).medium);
}

std::vector<LineField> line_fields(const Medium& medium, std::span<const std::string> names) {
    const auto& all = line_field_names();
    std::vector<LineField> fields;
    for (const auto& name : names) {
        const auto found = std::find(all.begin(), all.end(), name);
        const auto field = static_cast<LineField>(found - all.begin());
        if (found == all.end() || !has(medium, field)) {
            const std::string kind = std::holds_alternative<IdealGas>(medium) ? "a gas" : "an elastic line";
            throw InputError("", kind + " has no field '" + name + "' (valid: " + joined(names_in(medium)) + ")");
        }
        fields.push_back(field);
    }
    return fields;
}

}  // namespace ordo::solvers

#include "app/constants.hpp"

#include <cmath>

#include "core/text.hpp"

namespace ordo::app {
namespace {

std::string value_text(const oracles::Constant& constant);

/// {"name": value, ...} on one line.
std::string record(const oracles::Constants& members) {
    std::string text;
    for (const auto& member : members)
        text += (text.empty() ? "\"" : ", \"") + member.name + "\": " + value_text(member);
    return "{" + text + "}";
}

std::string value_text(const oracles::Constant& constant) {
    if (const double* number = std::get_if<double>(&constant.value))
        return std::isfinite(*number) ? seventeen_digits(*number) : "null";
    if (const auto* word = std::get_if<std::string>(&constant.value)) return '"' + *word + '"';
    std::string text;
    for (const auto& members : std::get<std::vector<oracles::Constants>>(constant.value))
        text += (text.empty() ? "\n  " : ",\n  ") + record(members);
    return "[" + text + "]";
}

}  // namespace

std::string constants_as_json(const oracles::Constants& constants) {
    std::string text;
    for (const auto& constant : constants)
        text += (text.empty() ? "\n \"" : ",\n \"") + constant.name + "\": " + value_text(constant);
    return "{" + text + "\n}\n";
}

}  // namespace ordo::app

#include <charconv>
#include <cmath>

#include "core/error.hpp"
#include "studies/reader/parts.hpp"

namespace ordo::studies {
namespace {

Json as_json(const std::string& text) {
    return std::visit([](const auto& known) { return Json(known); }, value_from(text));
}

/// "4,8,16" as a list, "4" as one value.
Json values_of(const std::string& text) {
    Json values = Json::array();
    std::size_t from = 0;
    for (std::size_t comma = text.find(','); comma != std::string::npos; comma = text.find(',', from)) {
        values.push_back(as_json(text.substr(from, comma - from)));
        from = comma + 1;
    }
    values.push_back(as_json(text.substr(from)));
    return values.size() == 1 ? values[0] : values;
}

}  // namespace

Setting setting_from(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) throw InputError("--set " + text, "must be path=value");
    try {
        Json(text).dump();
    } catch (const Json::exception&) {
        throw InputError("--set", "is not valid UTF-8");
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

Value value_from(const std::string& text) {
    const Json parsed = Json::parse(text, nullptr, false);
    if (parsed.is_boolean()) return parsed.get<bool>();
    if (parsed.is_number()) return parsed.get<double>();
    if (parsed.is_string()) return parsed.get<std::string>();
    double number = 0;  // ".5" and "1.", which JSON does not know
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc() && end == text.data() + text.size() && std::isfinite(number)) return number;
    return text;
}

void put_setting(Json& document, const Setting& setting) {
    std::string pointer = "/";
    for (const char c : setting.path) pointer += c == '.' ? "/" : c == '/' ? "~1" : c == '~' ? "~0" : std::string{c};
    const std::string parent = setting.path.substr(0, setting.path.find_last_of('.'));
    try {
        const Json::json_pointer place(pointer);
        if (document.contains(place.parent_pointer())) {
            document.at(place.parent_pointer())[place.back()] = values_of(setting.value);
            return;
        }
    } catch (const Json::exception&) {
        throw InputError("--set " + setting.path, "is no place in a study; write member.member=value");
    }
    throw InputError("--set " + setting.path, "the study has no '" + parent + "'");
}

}  // namespace ordo::studies

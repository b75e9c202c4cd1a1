#include "core/parameter.hpp"

#include <cmath>
#include <stdexcept>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo {
namespace {

template <class T>
const T& entry(const Given& values, const std::string& name) {
    const auto found = values.find(name);
    if (found == values.end()) throw std::logic_error("no value named '" + name + "'");
    const T* value = std::get_if<T>(&found->second);
    if (value == nullptr) throw std::logic_error("value '" + name + "' is of another kind");
    return *value;
}

[[noreturn]] void refuse(const Parameter& declared, const Value& value, const std::string& where,
                         const std::string& wanted) {
    const bool quoted = std::holds_alternative<std::string>(value);
    const std::string shown = quoted ? "'" + text_of(value) + "'" : text_of(value);
    throw InputError(where, "'" + declared.name + "' is " + shown + ", but must be " + wanted);
}

void check_number(const Parameter& declared, const Value& value, const std::string& where) {
    const double* number = std::get_if<double>(&value);
    const bool whole = declared.kind == Parameter::Kind::whole;
    if (number == nullptr) refuse(declared, value, where, (whole ? "" : "a number, ") + declared.rule());
    const bool fraction = whole && *number != std::floor(*number);
    if (fraction || !declared.range.contains(*number)) refuse(declared, value, where, declared.rule());
}

void check_word(const Parameter& declared, const Value& value, const std::string& where) {
    const std::string* given = std::get_if<std::string>(&value);
    if (given == nullptr) refuse(declared, value, where, "a string, " + declared.rule());
    const auto names = declared.word_names();
    for (const auto& name : names) {
        if (name == *given) return;
    }
    refuse(declared, value, where, declared.rule() + did_you_mean(*given, names));
}

}  // namespace

bool Range::contains(double value) const {
    if (!std::isfinite(value)) return false;
    return (low_excluded ? value > low : value >= low) && value <= high;
}

std::string Range::text() const {
    const bool below = std::isfinite(high);
    const bool above = std::isfinite(low);
    if (above && below)
        return std::string("in ") + (low_excluded ? "(" : "[") + shortest(low) + ", " + shortest(high) + "]";
    if (above) return std::string(low_excluded ? "> " : ">= ") + shortest(low);
    if (below) return "<= " + shortest(high);
    return "finite";
}

std::vector<std::string> Parameter::word_names() const {
    std::vector<std::string> names;
    for (const auto& choice : words) names.push_back(choice.name);
    return names;
}

std::string Parameter::default_text() const {
    if (fallback) return text_of(*fallback);
    return required ? "required" : "absent";
}

std::string Parameter::rule() const {
    switch (kind) {
        case Kind::number: return range.text();
        case Kind::whole: return "a whole number " + range.text();
        case Kind::toggle: return "true or false";
        case Kind::word: break;
    }
    return "one of: " + joined(word_names());
}

Parameter number(std::string name, std::string unit, double fallback, Range range, std::string help) {
    return {std::move(name), std::move(unit), Parameter::Kind::number, fallback, false, range, {}, std::move(help)};
}

Parameter whole(std::string name, double fallback, Range range, std::string help) {
    return {std::move(name), "-", Parameter::Kind::whole, fallback, false, range, {}, std::move(help)};
}

Parameter word(std::string name, std::string fallback, std::vector<Word> words, std::string help) {
    return {std::move(name), "-", Parameter::Kind::word, std::move(fallback),
            false,           {},  std::move(words),      std::move(help)};
}

Parameter toggle(std::string name, bool fallback, std::string help) {
    return {std::move(name), "-", Parameter::Kind::toggle, fallback, false, {}, {}, std::move(help)};
}

std::vector<Parameter> appended(std::vector<Parameter> declared, const std::vector<Parameter>& more) {
    declared.insert(declared.end(), more.begin(), more.end());
    return declared;
}

Parameter required(Parameter parameter) {
    parameter.fallback.reset();
    parameter.required = true;
    return parameter;
}

Parameter without_default(Parameter parameter) {
    parameter.fallback.reset();
    return parameter;
}

double Values::number(const std::string& name) const { return entry<double>(values_, name); }
int Values::whole(const std::string& name) const { return static_cast<int>(entry<double>(values_, name)); }
const std::string& Values::word(const std::string& name) const { return entry<std::string>(values_, name); }
bool Values::toggle(const std::string& name) const { return entry<bool>(values_, name); }

void check_value(const Parameter& declared, const Value& value, const std::string& where) {
    switch (declared.kind) {
        case Parameter::Kind::number:
        case Parameter::Kind::whole: check_number(declared, value, where); return;
        case Parameter::Kind::word: check_word(declared, value, where); return;
        case Parameter::Kind::toggle:
            if (!std::holds_alternative<bool>(value)) refuse(declared, value, where, declared.rule());
            return;
    }
}

Values resolve(const std::vector<Parameter>& declared, const Given& given, const std::string& where,
               const std::string& owner) {
    for (const auto& [name, value] : given) {
        const Parameter* parameter = find_parameter(declared, name);
        if (parameter == nullptr) {
            throw InputError(where,
                             "'" + name + "' is not a parameter of " + owner + did_you_mean(name, names_of(declared)));
        }
        check_value(*parameter, value, where);
    }
    Given full = given;
    for (const auto& parameter : declared) {
        if (full.contains(parameter.name)) continue;
        if (parameter.fallback) full.emplace(parameter.name, *parameter.fallback);
        else if (parameter.required)
            throw InputError(where, "'" + parameter.name + "' of " + owner + " is missing (" + parameter.rule() + ")");
    }
    return Values(std::move(full));
}

const Parameter* find_parameter(const std::vector<Parameter>& declared, const std::string& name) {
    for (const auto& parameter : declared) {
        if (parameter.name == name) return &parameter;
    }
    return nullptr;
}

std::vector<std::string> names_of(const std::vector<Parameter>& declared) {
    std::vector<std::string> names;
    for (const auto& parameter : declared) names.push_back(parameter.name);
    return names;
}

std::string text_of(const Value& value) {
    if (const bool* toggle = std::get_if<bool>(&value)) return *toggle ? "true" : "false";
    if (const double* number = std::get_if<double>(&value)) return shortest(*number);
    return std::get<std::string>(value);
}

}  // namespace ordo

#pragma once
// Declared parameters: the single source of validation, messages, `ordo list`, the study schema and the documentation.
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ordo {

/// One parameter's value: a toggle, a number (whole numbers too) or a word out of a closed set.
using Value = std::variant<bool, double, std::string>;

/// The numbers a parameter accepts.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_excluded = false;

    bool contains(double value) const;  ///< false for NaN and for infinities
    std::string text() const;           ///< "> 0", "in [1, 64]", "finite"
};

inline constexpr Range finite{};
inline constexpr Range positive{.low = 0, .low_excluded = true};
constexpr Range at_least(double low) { return {.low = low}; }
constexpr Range between(double low, double high) { return {.low = low, .high = high}; }

/// One word of a closed set, with its line of help (and its literature, where it has one).
struct Word {
    std::string name;
    std::string help;
};

/// A declared parameter. `fallback` empty and `required` false: it may be absent, and the owner says what then holds.
struct Parameter {
    enum class Kind { number, whole, word, toggle };

    std::string name;
    std::string unit;  ///< SI, or "-" when dimensionless
    Kind kind = Kind::number;
    std::optional<Value> fallback;
    bool required = false;
    Range range;
    std::vector<Word> words;
    std::string help;

    std::vector<std::string> word_names() const;
    std::string default_text() const;  ///< the default, "required" or "absent"
    std::string rule() const;          ///< what it accepts: its range, or its words
};

Parameter number(std::string name, std::string unit, double fallback, Range range, std::string help);
Parameter whole(std::string name, double fallback, Range range, std::string help);
Parameter word(std::string name, std::string fallback, std::vector<Word> words, std::string help);
Parameter toggle(std::string name, bool fallback, std::string help);
Parameter required(Parameter parameter);         ///< the same without a default: it must be given
Parameter without_default(Parameter parameter);  ///< the same without a default: it may stay absent

/// `declared`, and behind it `more`.
std::vector<Parameter> appended(std::vector<Parameter> declared, const std::vector<Parameter>& more);

/// What a user gave, by name.
using Given = std::map<std::string, Value>;

/// A full, valid set of values. Asking for an undeclared name or another kind is a programming error
/// (std::logic_error).
class Values {
public:
    Values() = default;
    explicit Values(Given values) : values_(std::move(values)) {}

    bool has(const std::string& name) const { return values_.contains(name); }
    double number(const std::string& name) const;
    int whole(const std::string& name) const;
    const std::string& word(const std::string& name) const;
    bool toggle(const std::string& name) const;
    const Given& all() const { return values_; }
    bool operator==(const Values&) const = default;

private:
    Given values_;
};

/// `given` checked against `declared`, defaults filled in. `where` opens each message; `owner` names what declares.
/// Throws InputError on an unknown or missing name, a wrong type, a number out of range or a word out of the set.
Values resolve(const std::vector<Parameter>& declared, const Given& given, const std::string& where,
               const std::string& owner);

/// One value against its declaration; throws InputError.
void check_value(const Parameter& declared, const Value& value, const std::string& where);

const Parameter* find_parameter(const std::vector<Parameter>& declared, const std::string& name);
std::vector<std::string> names_of(const std::vector<Parameter>& declared);
std::string text_of(const Value& value);  ///< as a user would write it: true, 0.5, musl

}  // namespace ordo

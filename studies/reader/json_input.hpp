#pragma once
// Strict, bounded reading of JSON that comes from outside: studies, published tables, reports.
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/parameter.hpp"

namespace ordo::studies {

using Json = nlohmann::ordered_json;

/// The text as JSON; // and /* */ comments are allowed. Throws InputError with line and column on a syntax error, and
/// on nesting deeper than 64, a repeated member, or a number that no double can hold. `where` opens the message.
Json parse_json(const std::string& text, const std::string& where);

/// The whole file, at most 64 MiB. Throws InputError when it is missing, a folder, unreadable or too large.
std::string read_text(const std::string& path);

/// A JSON value with the place it stands at, for messages: "bar.json: /scene/E". Every reader throws InputError.
class Node {
public:
    Node(const Json& json, std::string file, std::string pointer = "", std::string key = "")
        : json_(&json), file_(std::move(file)), pointer_(std::move(pointer)), key_(std::move(key)) {}

    /// Refuses members outside `allowed` (with the nearest) and values that are no object.
    void only(const std::vector<std::string>& allowed) const;
    bool has(const std::string& member) const { return json_->is_object() && json_->contains(member); }
    Node at(const std::string& member) const;        ///< throws when it is missing
    std::vector<Node> items() const;                 ///< of an array; a lone value counts as an array of one
    std::vector<Node> members() const;               ///< of an object, in the order of the file
    const std::string& key() const { return key_; }  ///< its name in the object that it is a member of

    double number() const;
    std::string text() const;
    bool toggle() const;
    Value value() const;                     ///< toggle, number or string
    std::vector<std::string> texts() const;  ///< one string or an array of them
    bool is_array() const { return json_->is_array(); }
    bool is_text() const { return json_->is_string(); }
    bool is_object() const { return json_->is_object(); }
    /// One of the words, by position; the message names them and the nearest.
    std::size_t one_of(const std::vector<std::string>& words) const;

    const Json& json() const { return *json_; }
    std::string where() const;
    [[noreturn]] void refuse(const std::string& problem) const;

private:
    const Json* json_;
    std::string file_;
    std::string pointer_;
    std::string key_;
};

}  // namespace ordo::studies

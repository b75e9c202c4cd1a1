#include "studies/reader/json_input.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::studies {
namespace {

constexpr int deepest = 64;
constexpr std::uintmax_t largest_file = 64u << 20;

/// What the parser says, on one line and without its own name in front.
std::string one_line(std::string message) {
    if (const auto bracket = message.find("] "); bracket != std::string::npos) message = message.substr(bracket + 2);
    for (char& c : message) {
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    }
    return message;
}

std::string shown(const Json& json) {
    if (json.is_array()) return "a list";
    if (json.is_object()) return "an object";
    if (json.is_string()) return "'" + json.get<std::string>() + "'";
    return json.dump();
}

}  // namespace

Json parse_json(const std::string& text, const std::string& where) {
    std::vector<std::set<std::string>> open;
    const auto guard = [&](int depth, Json::parse_event_t event, Json& parsed) {
        if (depth > deepest) throw InputError(where, "nested deeper than " + std::to_string(deepest) + " levels");
        if (event == Json::parse_event_t::object_start) open.emplace_back();
        if (event == Json::parse_event_t::object_end) open.pop_back();
        if (event == Json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second) {
            throw InputError(where, "the member '" + parsed.get<std::string>() + "' stands twice in one object");
        }
        return true;
    };
    try {
        return Json::parse(text, guard, true, true);
    } catch (const Json::exception& error) {
        throw InputError(where, "not valid JSON: " + one_line(error.what()));
    }
}

std::string read_text(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) throw InputError(path, "there is no such file");
    if (!std::filesystem::is_regular_file(path, error)) throw InputError(path, "is not a file");
    if (std::filesystem::file_size(path, error) > largest_file) throw InputError(path, "is larger than 64 MiB");
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw InputError(path, "cannot be read");
    return text.str();
}

std::string Node::where() const { return pointer_.empty() ? file_ : file_ + ": " + pointer_; }

void Node::refuse(const std::string& problem) const { throw InputError(where(), problem); }

void Node::only(const std::vector<std::string>& allowed) const {
    if (!json_->is_object()) refuse("is " + shown(*json_) + ", but must be an object");
    for (const auto& [name, value] : json_->items()) {
        if (std::find(allowed.begin(), allowed.end(), name) != allowed.end()) continue;
        refuse("unknown member '" + name + "'" + did_you_mean(name, allowed));
    }
}

Node Node::at(const std::string& member) const {
    if (!has(member)) refuse("the member '" + member + "' is missing");
    return {(*json_)[member], file_, pointer_ + "/" + member, member};
}

std::vector<Node> Node::items() const {
    if (!json_->is_array()) return {*this};
    std::vector<Node> nodes;
    for (const auto& item : *json_) nodes.emplace_back(item, file_, pointer_ + "/" + std::to_string(nodes.size()));
    return nodes;
}

std::vector<Node> Node::members() const {
    std::vector<Node> nodes;
    for (const auto& [name, value] : json_->items()) nodes.emplace_back(value, file_, pointer_ + "/" + name, name);
    return nodes;
}

double Node::number() const {
    if (!json_->is_number()) refuse("is " + shown(*json_) + ", but must be a number");
    return json_->get<double>();
}

std::string Node::text() const {
    if (!json_->is_string()) refuse("is " + shown(*json_) + ", but must be a string");
    return json_->get<std::string>();
}

bool Node::toggle() const {
    if (!json_->is_boolean()) refuse("is " + shown(*json_) + ", but must be true or false");
    return json_->get<bool>();
}

Value Node::value() const {
    if (json_->is_boolean()) return toggle();
    if (json_->is_number()) return number();
    if (json_->is_string()) return text();
    refuse("is " + shown(*json_) + ", but must be a number, a string, true or false");
}

std::vector<std::string> Node::texts() const {
    std::vector<std::string> words;
    for (const auto& item : items()) words.push_back(item.text());
    return words;
}

std::size_t Node::one_of(const std::vector<std::string>& words) const {
    const auto found = std::find(words.begin(), words.end(), text());
    if (found == words.end())
        refuse("is '" + text() + "', but must be one of: " + joined(words) + did_you_mean(text(), words));
    return static_cast<std::size_t>(found - words.begin());
}

}  // namespace ordo::studies

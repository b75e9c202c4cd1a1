#pragma once
// What several sub-commands ask of their words.
#include <map>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::app {

/// The format of that name; the message names the nearest.
template <class Format>
Format format_of(const po::variables_map& options, const std::map<std::string, Format>& formats,
                 const std::string& command) {
    const auto name = options["format"].as<std::string>();
    if (const auto found = formats.find(name); found != formats.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [known, format] : formats) names.push_back(known);
    throw InputError(command + " --format", "there is no format '" + name + "'" + did_you_mean(name, names));
}

/// The one report that the command takes.
inline std::string one_report(const std::vector<std::string>& files, const std::string& command) {
    if (files.size() != 1) throw InputError(command, "takes one report; usage: " + command + " REPORT");
    return files.front();
}

}  // namespace ordo::app

#pragma once
// What several sub-commands ask of their words.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
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

/// The errors between the commas of an option, each a number above zero, there once; none where it is not given.
inline std::vector<double> errors_of(const po::variables_map& options, const std::string& name,
                                     const std::string& command) {
    if (!options.contains(name)) return {};
    const std::string where = command + " --" + name;
    std::vector<double> errors;
    std::istringstream list(options[name].as<std::string>() + ",");
    for (std::string text; std::getline(list, text, ',');) {
        double error = 0;
        const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), error);
        if (fault != std::errc() || end != text.data() + text.size() || !(error > 0) || !std::isfinite(error))
            throw InputError(where, "'" + text + "' is no error above zero (nearest: 1e-2,1e-4)");
        if (std::ranges::find(errors, error) != errors.end()) throw InputError(where, "'" + text + "' stands twice");
        errors.push_back(error);
    }
    return errors;
}

}  // namespace ordo::app

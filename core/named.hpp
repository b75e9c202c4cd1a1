#pragma once
// Looking up an entry of a catalogue by its name.
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo {

/// The entry of that name. Throws InputError: `absent` ("there is no solver"), the name, and the nearest valid one.
template <class Entry>
const Entry& named(const std::vector<Entry>& entries, const std::string& name, const std::string& where,
                   const std::string& absent) {
    std::vector<std::string> names;
    for (const auto& entry : entries) {
        if (entry.name == name) return entry;
        names.push_back(entry.name);
    }
    throw InputError(where, absent + " '" + name + "'" + did_you_mean(name, names));
}

}  // namespace ordo

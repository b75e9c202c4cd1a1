#pragma once
// What a run follows from, in one canonical text: equal runs have equal texts, whichever study asks for them.
#include <string>

#include "studies/engine/run.hpp"

namespace ordo::studies {

/// JSON with sorted members and the shortest numbers that read back as the same doubles: scene and solver with all
/// their values, resolution, end, and what is measured. Names, labels and time limits are left out: no figure follows
/// from them.
std::string description_of(const RunSpec& spec);

/// The same for a run whose errors are taken against `reference` too.
std::string description_of(const RunSpec& spec, const RunSpec& reference);

}  // namespace ordo::studies

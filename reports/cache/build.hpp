#pragma once
// What the figures of a run follow from beside its description.
#include <string>

namespace ordo::reports {

/// JSON: compiler, flags, libraries, digests of the sources that figures are computed by (a room each), processor and C
/// library, whose roots and exponentials are not the same everywhere.
std::string build_of_figures();

}  // namespace ordo::reports

#pragma once
// What does not depend on x, as JSON.
#include <string>

#include "oracles/oracle.hpp"

namespace ordo::app {

/// An object with 17 digits a number; what has no value is null.
std::string constants_as_json(const oracles::Constants& constants);

}  // namespace ordo::app

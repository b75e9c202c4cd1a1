#pragma once
// The six constants of an isotropic elastic solid, by name.
#include "oracles/oracle.hpp"

namespace ordo::oracles {

/// What core/elastic_constants.hpp computes, for whoever asks by name. It has constants and no fields: nothing depends
/// on x or t.
Oracle elastic_constants_oracle();

}  // namespace ordo::oracles

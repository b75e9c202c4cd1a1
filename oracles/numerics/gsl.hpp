#pragma once
// GSL aborts the process on an error unless told not to; its handler is one for the whole process.

namespace ordo::oracles {

/// Switches GSL's error handler off, once; whoever calls GSL says this first and looks at return codes.
void quiet_gsl();

}  // namespace ordo::oracles

#pragma once
// A small fixed piece of work, timed beside the solvers: what times are measured in where machines differ.

namespace ordo::reports {

/// Thread time [s] of particles gathering from and scattering to a small grid, the best of five repetitions of about a
/// millisecond each. A noisy neighbour can only lengthen it, so that the smaller of two timings is the better one.
double reference_kernel_seconds();

}  // namespace ordo::reports

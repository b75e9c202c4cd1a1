#pragma once
// Error norms over weighted points.
#include <span>

#include "studies/engine/study.hpp"

namespace ordo::studies {

/// Norm of the difference of two fields at n points of `components` numbers each; |e| is the Euclidean length.
///
///   rms = sqrt(sum |e|^2 / n)    l1 = sum w |e|    l2 = sqrt(sum w |e|^2)    linf = max |e|
///
/// found, exact   n x components, in the field's unit      weights   n, volume of each point [m^dim]
/// return   [field] for rms and linf, [field m^dim] for l1, [field m^(dim/2)] for l2; NaN if any difference is NaN
double error_norm(Norm norm, std::span<const double> found, std::span<const double> exact,
                  std::span<const double> weights, int components);

}  // namespace ordo::studies

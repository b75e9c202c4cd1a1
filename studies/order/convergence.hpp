#pragma once
// What errors, or values, do under refinement, by name.
#include <string>

namespace ordo::studies {

/// As an abscissa falls to zero:
///   converges        an order, known within +- 0.2 (0.4 beside a floor or a second power, 0.5 for both of a grid)
///   at_floor         a floor, and too few points above it for an order
///   pre_asymptotic   orders drift, or the finest points leave the line: no asymptotic range
///   stalled          errors do not fall: an order below 0.1
///   diverges         errors grow
///   inconclusive     too few points, or too much scatter, for an order
///   invalid          no series of positive errors at different positive abscissae
enum class Convergence { converges, at_floor, pre_asymptotic, stalled, diverges, inconclusive, invalid };

/// "pre_asymptotic".
std::string text_of(Convergence convergence);

}  // namespace ordo::studies

#pragma once
// Quantities that are measured against themselves: no exact solution, so their series are extrapolated to h = 0.
#include <string>
#include <vector>

#include "studies/engine/result.hpp"
#include "studies/order/grid_convergence.hpp"

namespace ordo::studies {

/// What the methods without an exact solution make of one quantity along one series.
struct SeriesExtrapolation {
    std::string series;
    std::string abscissa;
    std::string quantity;
    std::vector<int> used;
    std::vector<Extrapolation> methods;
};

/// One for each fit of a quantity that is measured against itself, over the runs that the fit uses.
std::vector<SeriesExtrapolation> extrapolations_of(const Result& result);

}  // namespace ordo::studies

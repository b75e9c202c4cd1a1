#pragma once
// Joint fits of mesh width and time step, where a study's path is a grid of both: a pure function of its runs.
#include <string>
#include <vector>

#include "studies/engine/result.hpp"
#include "studies/order/joint_fit.hpp"

namespace ordo::studies {

/// One quantity over one grid of h and dt.
struct JointResult {
    std::string grid;  ///< "ppc = 4", "mpm usl"; as a series' label
    std::string quantity;
    std::vector<int> used;  ///< runs, in the order of the fit's shares
    std::vector<LeftOut> left_out;
    JointFit fit;
};

/// A joint fit for each grid and quantity; none unless the path is `grid`. What is expected to be exact has no order
/// and no fit; a NaN is not left out: the fit refuses it by name.
std::vector<JointResult> joint_fits_of(const Study& study, const std::vector<Run>& runs);

}  // namespace ordo::studies

#pragma once
// The points of a joint fit: what they are, and why they may be none to fit.
#include <set>
#include <string>
#include <vector>

#include "studies/order/joint_fit.hpp"

namespace ordo::studies {

/// h (0) or dt (1) of a point, and its name.
double abscissa_of(const JointPoint& point, int part);
const char* name_of(int part);

/// Values of h (0) or dt (1), rising.
std::set<double> levels_of(const std::vector<JointPoint>& points, int part);

/// Why these points cannot be fitted, or "".
std::string invalid_point(const std::vector<JointPoint>& points);

/// Why they are too few to tell both orders, or "".
std::string too_few(const std::vector<JointPoint>& points);

}  // namespace ordo::studies

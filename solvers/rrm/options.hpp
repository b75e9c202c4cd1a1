#pragma once
// What a user may choose, and what it comes to.
#include <vector>

#include "core/parameter.hpp"
#include "solvers/rrm/line.hpp"

namespace ordo::solvers::rrm {

std::vector<Parameter> declared_options();
std::vector<Parameter> declared_resolution();

/// Throws InputError for a line that cannot be: edges that do not rise, unphysical pieces, one periodic end.
void check(const LineScene& scene);

Options options_from(const LineScene& scene, const Values& options, const Values& resolution);

}  // namespace ordo::solvers::rrm

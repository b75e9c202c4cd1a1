#pragma once
// Parts of the study reader; study_reader.cpp puts them together.
#include <vector>

#include "solvers/solver.hpp"
#include "studies/engine/study.hpp"
#include "studies/reader/json_input.hpp"
#include "studies/reader/study_reader.hpp"

namespace ordo::studies {

/// Puts one `--set` into the document. Throws InputError where the study has no such place.
void put_setting(Json& document, const Setting& setting);

/// The axes and the path, each value checked against what the solvers declare, and the path against the axes.
/// `coupling`, dt = C h^k, becomes the axis dt beside the width's.
Sweep sweep_from(const Node& node, const std::vector<SolverChoice>& choices, const solvers::Scene& problem);

/// What is measured, when, and against what; fields and norms must be there to measure.
Measure measure_from(const Node& node, const Study& study);

/// What is asked of stability, in the place of what is measured; a figure of one Courant number needs that axis.
Measure stability_from(const Node& node, const Study& study);

/// The expectations; conditions must name swept axes, quantities must be measured.
std::vector<Expectation> expectations_from(const Node& node, const Study& study);

/// One expectation for each quantity and solver that `claim` speaks of, each with the order that theory expects of it.
/// Throws InputError, at this node, where theory expects none.
std::vector<Expectation> expected_orders(const Node& node, const Expectation& claim, const Study& study);

/// Replaces each `published.file` by the table in it, so that the document is complete.
void inline_published(Json& document, const std::string& where, const std::string& folder);

/// The published tables; rows must name swept axes, values must be decimal numbers.
std::vector<Published> published_from(const Node& node, const Study& study);

}  // namespace ordo::studies

#pragma once
// "stop": "when_decided": which levels of a line need not be run. docs/study-files.md states the rules.
#include <string>
#include <vector>

#include "studies/engine/result.hpp"

namespace ordo::studies {

/// Why the levels of the line behind its first `ended` ones need not be run; "" where they must. It follows from the
/// study and those first runs only, whose ids are their places in `runs`.
std::string why_decided(const Study& study, const std::vector<Run>& runs, const Series& line, std::size_t ended);

/// Runs that are marked as skipped although the study or the coarser runs of their line do not allow it.
long skipped_wrongly(const Study& study, const std::vector<Run>& runs);

}  // namespace ordo::studies

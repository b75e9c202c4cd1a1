#include "studies/engine/engine.hpp"

#include "studies/engine/crew.hpp"

namespace ordo::studies {

std::vector<Run> run_all(const Study& study, const EngineOptions& options) { return Crew(study, options).all_runs(); }

}  // namespace ordo::studies

#pragma once
// A benchmark: a physical problem tied to its truth. One file in studies/scenes each, which enrols itself.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/parameter.hpp"
#include "oracles/oracle.hpp"
#include "solvers/scene.hpp"

namespace ordo::studies {

struct SceneEntry {
    std::string name;
    std::string about;
    std::vector<std::string> source;  ///< keys of docs/references.bib
    std::string units;                ///< "SI", or "dimensionless"
    std::vector<Parameter> parameters;
    std::string oracle;  ///< name of its exact solution in the oracles' catalogue
    std::function<solvers::Scene(const Values&)> problem;
    std::function<oracles::Exact(const Values&)> truth;
};

/// Adds a benchmark to the catalogue; a file in studies/scenes says `const bool enrolled = enrol({...});`.
bool enrol(SceneEntry entry);

/// All benchmarks, in the order of their names.
const std::vector<SceneEntry>& all_scenes();

/// The benchmark of that name. Throws InputError with the nearest name.
const SceneEntry& scene_named(const std::string& name, const std::string& where);

}  // namespace ordo::studies

#pragma once
// A scene and a solver named on the command line, for commands that need no study.
#include <string>
#include <vector>

#include "app/command.hpp"
#include "solvers/solver.hpp"

namespace ordo::app {

/// Options --solver and --set of such a command.
void add_one_run_options(po::options_description& options);

struct OneRun {
    std::string scene_name;
    solvers::Scene scene;
    const solvers::Solver* solver = nullptr;
    Values options;
    Values resolution;
};

/// From the scene's name, --solver and --set scene.k=v, solver.k=v, resolution.k=v. Throws InputError, opened by
/// `command` ("ordo solve"), for what is missing, unknown or does not go together.
OneRun one_run_from(const po::variables_map& options, const std::vector<std::string>& words,
                    const std::string& command);

}  // namespace ordo::app

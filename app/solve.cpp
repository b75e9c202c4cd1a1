// ordo solve: one run of one solver, its fields as columns.
#include <atomic>
#include <cmath>
#include <csignal>
#include <iostream>

#include "app/columns.hpp"
#include "app/one_run.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/files.hpp"
#include "studies/engine/engine.hpp"

namespace ordo::app {
namespace {

constexpr double most_steps = 1e9;

std::atomic<bool> stop_asked{false};

void ask_to_stop(int) { stop_asked = true; }

std::vector<Column> columns_of(const solvers::Snapshot& shot) {
    const auto dim = static_cast<std::size_t>(shot.dim);
    std::vector<Column> columns;
    const auto add = [&](const std::string& field, const std::vector<double>& values, std::size_t components) {
        const auto names = component_names(field, static_cast<int>(components), shot.dim);
        for (std::size_t k = 0; k < components; ++k) {
            columns.push_back({names[k], {}});
            for (std::size_t i = 0; i < shot.points(); ++i) columns.back().values.push_back(values[i * components + k]);
        }
    };
    add("X", shot.X, dim);
    add("x", shot.x, dim);
    add("volume", shot.weights, 1);
    for (const auto& field : shot.fields) add(field.name, field.values, static_cast<std::size_t>(field.components));
    return columns;
}

int run(const po::variables_map& options, const std::vector<std::string>& words) {
    if (!options.contains("t")) throw InputError("ordo solve", "needs --t T");
    const double t = options["t"].as<double>();
    if (!(t > 0) || !std::isfinite(t)) throw InputError("ordo solve --t", "is " + shortest(t) + ", but must be > 0");
    const auto [scene, problem, solver, values, resolution] = one_run_from(options, words, "ordo solve");
    const auto plan = solver->plan(problem, values, resolution);
    if (!(t / plan.dt < most_steps))
        throw InputError("ordo solve", "asks for more than " + shortest(most_steps) + " steps");
    const auto format = options["format"].as<std::string>();
    columns_as(format, {}, "ordo solve");
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    const auto out = options.contains("out") ? options["out"].as<std::string>() : "";
    if (!out.empty()) reports::check_writable(out);
    const auto fields = solver->fields_in ? solver->fields_in(problem) : solver->fields;
    std::string text;
    try {
        const auto simulation = solver->start(problem, values, resolution, fields);
        simulation->advance_to(t, [] { return stop_asked.load(std::memory_order_relaxed); });
        text = columns_as(format, columns_of(simulation->snapshot()), "ordo solve");
    } catch (const solvers::Interrupted&) {
        throw studies::StudyInterrupted{};
    } catch (const solvers::Diverged& error) {
        std::cerr << "ordo: the run diverged: " << error.what() << '\n';
        return gate_failed;
    }
    if (out.empty()) std::cout << text;
    else reports::write_whole(out, text);
    return all_hold;
}

}  // namespace

Command solve_command() {
    po::options_description options("options");
    add_one_run_options(options);
    // clang-format off
    options.add_options()
        ("t", po::value<double>()->value_name("T"), "end of the run [s]")
        ("out,o", po::value<std::string>()->value_name("FILE"), "where the columns go (default standard output)")
        ("format", po::value<std::string>()->value_name("NAME")->default_value("csv"), "csv or json");
    // clang-format on
    return {.name = "solve",
            .about = "one run of one solver, its particles as columns",
            .usage = "SCENE --solver NAME --t T [--set path=value]... [-o FILE] [--format csv|json]",
            .examples =
                {"ordo solve bar_vibration --solver mpm --t 0.5 --set resolution.cells=16 --set resolution.dt=1e-3"},
            .options = options,
            .most_arguments = 1,
            .run = run};
}

}  // namespace ordo::app

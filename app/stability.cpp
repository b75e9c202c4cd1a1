// ordo stability: how large may the step be, and what happens beyond?
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <iostream>
#include <optional>

#include "app/one_run.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "studies/amplification/limits.hpp"
#include "studies/engine/engine.hpp"

namespace ordo::app {
namespace {

using studies::Limit;
using studies::Scheme;
using studies::Stability;

constexpr double margin = 0.9;  // of the limit that is suggested

std::atomic<bool> stop_asked{false};

void ask_to_stop(int) { stop_asked = true; }

Stability asked_from(const po::variables_map& options, const solvers::Scene& scene) {
    const std::string motion = options["motion"].as<std::string>();
    if (motion != "noise" && motion != "scene")
        throw InputError("ordo stability --motion", "is '" + motion + "', but must be one of: noise, scene");
    if (motion == "noise" && solvers::is_line(scene) && !options["motion"].defaulted())
        throw InputError("ordo stability --motion", "is 'noise', which is for bodies (nearest: scene)");
    Stability asked;
    asked.as_scene = motion == "scene" || solvers::is_line(scene);
    asked.growth = asked.as_scene ? 10 : 1000;
    asked.crossings = options["crossings"].as<double>();
    asked.from = options["from"].as<double>();
    asked.to = options["to"].as<double>();
    const auto sound = [](double value) { return value > 0 && std::isfinite(value); };
    if (!sound(asked.crossings) || asked.crossings > 1e6)
        throw InputError("ordo stability --crossings", "is " + shortest(asked.crossings) + ", but must be in (0, 1e6]");
    if (!sound(asked.from) || !sound(asked.to) || asked.from >= asked.to)
        throw InputError("ordo stability --from", "and --to must be two rising Courant numbers > 0");
    return asked;
}

std::string text_of(const Limit& limit, double to) {
    if (std::isinf(limit.value())) return fmt::format("above {:g}", to);
    const double half = 0.5 * (limit.unstable - limit.stable);
    return fmt::format("{:.4f} +- {:.1g}", limit.value(), half);
}

/// Nothing for a scheme without a matrix.
std::optional<Limit> by_matrix(const Scheme& scheme, const Stability& asked) {
    if (!studies::has_matrix(scheme)) return {};
    return studies::limit_by_matrix(scheme, asked);
}

void tell(const Scheme& scheme, const Stability& asked, const Limit& runs, const std::optional<Limit>& matrix,
          const studies::Growth& beyond) {
    std::cout << "largest stable Courant number " << text_of(runs, asked.to) << " by runs";
    if (matrix) std::cout << ", " << text_of(*matrix, asked.to) << " by the matrix of one step";
    if (const auto theory = studies::limit_by_theory(scheme))
        std::cout << fmt::format("; theory {:.4f} (closed form, no ends)", *theory);
    if (std::isfinite(runs.unstable)) {
        std::cout << "; beyond it ";
        if (matrix) std::cout << studies::growing_mode(scheme, runs.unstable) << " grows";
        else std::cout << "the norm grows";
        if (!beyond.why.empty()) std::cout << ", until " << one_line(beyond.why);
    }
    const auto crossing = studies::limit_while_crossing(scheme);
    if (crossing) std::cout << fmt::format("; {:.4f} where particles cross cells", *crossing);
    double limit = std::min(runs.stable, matrix ? matrix->stable : runs.stable);
    if (crossing) limit = std::min(limit, *crossing);
    if (!std::isfinite(limit) || limit == 0) return void(std::cout << '\n');
    const double safe = margin * limit;
    std::cout << fmt::format("\nsafe step: courant = {:.3g}, dt = {:.4g} s\n", safe, scheme.plan(safe).dt);
}

int run(const po::variables_map& options, const std::vector<std::string>& words) {
    const OneRun one = one_run_from(options, words, "ordo stability");
    for (const char* step : {"dt", "courant"}) {
        if (options.contains("set") &&
            std::ranges::any_of(options["set"].as<std::vector<std::string>>(), [&](const std::string& text) {
                return text.starts_with(std::string("resolution.") + step + "=");
            }))
            throw InputError("ordo stability --set", std::string("sets ") + step + ", which is what is searched for");
    }
    const Stability asked = asked_from(options, one.scene);
    const Scheme scheme{one.scene, one.solver, one.options, one.resolution};
    if (find_parameter(one.solver->resolution, "courant") == nullptr)
        throw InputError("ordo stability", "solver " + one.solver->name + " takes no steps of a Courant number");
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    try {
        const studies::Growths growths(scheme, asked, [] { return stop_asked.load(std::memory_order_relaxed); });
        const auto is_stable = [&](double courant) {
            return growths.at(courant, false).kind == studies::Growth::Class::stable;
        };
        const Limit runs = studies::first_limit(is_stable, asked);
        const bool found = std::isfinite(runs.unstable);
        tell(scheme, asked, runs, by_matrix(scheme, asked),
             found ? growths.at(runs.unstable, true) : studies::Growth{});
    } catch (const solvers::Interrupted&) {
        throw studies::StudyInterrupted{};
    } catch (const solvers::Diverged& error) {
        std::cerr << "ordo: no limit in the bracket: " << one_line(error.what()) << '\n';
        return gate_failed;
    }
    return all_hold;
}

}  // namespace

Command stability_command() {
    po::options_description options("options");
    add_one_run_options(options);
    // clang-format off
    options.add_options()
        ("motion", po::value<std::string>()->value_name("NAME")->default_value("noise"),
         "noise: the body at rest with noise of 1e-9 of the wave speed; scene: its own motion and loads (lines always)")
        ("crossings", po::value<double>()->value_name("N")->default_value(1000),
         "length of a run: cells that a wave crosses")
        ("from", po::value<double>()->value_name("C")->default_value(0.1), "smallest Courant number tried")
        ("to", po::value<double>()->value_name("C")->default_value(4), "largest Courant number tried");
    // clang-format on
    return {.name = "stability",
            .about = "the largest stable step of a solver on a scene, by runs, matrix and theory",
            .usage = "SCENE --solver NAME [--set path=value]... [--motion noise|scene]",
            .examples = {"ordo stability bar_vibration --solver mpm --set resolution.cells=10 --set resolution.ppc=2",
                         "ordo stability oedometer --solver mpm --set resolution.cells=32 --motion scene"},
            .options = options,
            .most_arguments = 1,
            .run = run};
}

}  // namespace ordo::app
